import { beforeAll, describe, expect, test } from 'vitest';
import packageJson from '../../package.json';
import { Folder } from './command.ts';
import { engine } from './engine.ts';

const folder = new Folder();

/** The files that the examples speak of. */
beforeAll(async () => {
  for (const name of ['engine.vtp', 'engine.vtk', 'part.vtp', 'small.vtp']) await folder.save(name, engine());
  await folder.save('part.stl', engine());
  const { mesh } = await folder.read('part.stl');
  folder.write('part.csv', `heat [K]\n${'300\n'.repeat(mesh.position.length / 3)}`);
  await folder.save('scan.ply', { ...engine(), variables: [] });
});

/** The commands below "Examples:", without what they are piped into. */
function examplesOf(help: string): string[] {
  const lines = help.slice(help.indexOf('Examples:')).split('\n');
  return lines.filter((line) => line.startsWith('  meshbound ')).map((line) => line.split(' | ')[0].trim());
}

test('--help tells of every command and of the exit statuses', async () => {
  const { status, stdout, stderr } = await folder.run('--help');
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  for (const word of ['inspect', 'reduce', 'verify', 'convert', 'Exit status']) expect(stdout).toContain(word);
});

test('--version is that of the package', async () => {
  expect(await folder.run('--version')).toMatchObject({ status: 0, stdout: `${packageJson.version}\n` });
});

describe.each(['inspect', 'reduce', 'verify', 'convert'])('%s --help', (command) => {
  test('shows usage, options and examples that work as they stand', async () => {
    const { status, stdout, stderr } = await folder.run(command, '--help');
    expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
    expect(stdout).toContain(`Usage: meshbound ${command} `);
    const examples = examplesOf(stdout);
    expect(examples.length).toBeGreaterThanOrEqual(2);
    const outcome = await folder.runShell(examples.join(' && '));
    expect(outcome).toMatchObject({ status: 0 });
  });
});
