import { beforeAll, describe, expect, test } from 'vitest';
import { Folder } from './command.ts';
import { engine } from './engine.ts';

const folder = new Folder();
const outputs = ['-o', 'out.vtp', '--map', 'map.vtp', '--report', 'report.json'];
const before = 'what was there before';

/** Large enough to be under way for a while. */
beforeAll(async () => {
  await folder.save('large.vtp', engine(300));
  await folder.save('small.vtp', engine(8));
});

/** Reduces what takes long, and sends a signal as soon as the bar shows that it is under way. */
async function interrupt(signal: NodeJS.Signals) {
  const { child, outcome } = folder.runOnTerminal('reduce', 'large.vtp', ...outputs, '-b', '*=1%');
  child.stderr?.once('data', () => child.kill(signal));
  return outcome;
}

describe.each([
  ['SIGINT', 130],
  ['SIGTERM', 143],
] as const)('%s', (signal, status) => {
  test('ends the reduction and leaves no file, whole or half', async () => {
    const files = folder.files();
    const outcome = await interrupt(signal);
    expect(outcome).toMatchObject({ status, stdout: '' });
    expect(outcome.stderr).toContain(`Interrupted by ${signal}; nothing was written.`);
    expect(folder.files()).toEqual(files);
  });

  test('leaves the files that were there as they were', async () => {
    for (const name of ['out.vtp', 'map.vtp', 'report.json']) folder.write(name, before);
    const files = folder.files();
    expect(await interrupt(signal)).toMatchObject({ status });
    expect(folder.files()).toEqual(files);
    for (const name of ['out.vtp', 'map.vtp', 'report.json']) expect(folder.text(name)).toBe(before);
  });
});

describe('the progress', () => {
  test('is a bar on a terminal, gone at the end', async () => {
    const { outcome } = folder.runOnTerminal('reduce', 'small.vtp', '-o', 'out.vtp', '-b', '*=1%');
    const { status, stderr } = await outcome;
    expect(status).toBe(0);
    expect(stderr).toMatch(/\r\[#*\.*\] {1,3}\d+ %/);
    expect(stderr.split('\r').at(-1)).toBe('');
    expect(stderr.split('\r').at(-2)?.trim()).toBe('');
  });

  test('is silent elsewhere, and with --quiet', async () => {
    const args = ['reduce', 'small.vtp', '-o', 'out.vtp', '-b', '*=1%'];
    expect((await folder.run(...args)).stderr).toBe('');
    expect((await folder.runOnTerminal(...args, '--quiet').outcome).stderr).toBe('');
  });
});
