// The examples of README.md and docs do what they say. Wants a build (npm run build) and a native one. The example of a page
// is tested in a browser: tests/e2e/readme.spec.ts.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { beforeAll, describe, expect, test } from 'vitest';

import { writeSurface } from '../../web/formats/write.ts';
import { bumpyPlate } from '../wasm/bumpy-plate.ts';

/** Under the root, so that the examples find the modules and the command where they are. */
const folder = resolve('build/examples');

/** The examples of a document in one language. */
function examples(document: string, language: string): string[] {
  const blocks = readFileSync(document, 'utf8').matchAll(new RegExp(`^\`\`\`${language}\\n(.*?)^\`\`\``, 'gms'));
  return Array.from(blocks, ([, code]) => code);
}

/** An example says what it prints in comments at the ends of its lines. */
function expectPromised(printed: string, code: string): void {
  const promised = Array.from(code.matchAll(/; \/\/ (.+)$/gm), ([, words]) => words);
  expect(promised).not.toEqual([]);
  expect(printed.split('\n')).toEqual(expect.arrayContaining(promised));
}

beforeAll(() => {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
});

test('README has an example of ten lines at most for each face', () => {
  const all = ['sh', 'ts', 'html', 'cpp'].map((language) => examples('README.md', language));
  expect(all.map(({ length }) => length)).toEqual([1, 1, 1, 1]);
  for (const [code] of all) expect(code.trimEnd().split('\n').length).toBeLessThanOrEqual(10);
});

describe.each(['README.md', 'docs/cpp.md'])('C++ in %s', (document) => {
  test.each(examples(document, 'cpp'))('%#', (code) => {
    const [source, program] = [join(folder, 'example.cpp'), join(folder, 'example')];
    writeFileSync(source, code);
    const library = 'build/native/core/libmeshbound.a';
    execFileSync('c++', ['-std=c++20', '-Icore/include', source, library, '-o', program]);
    const printed = execFileSync(program, { encoding: 'utf8' });
    expectPromised(printed, code);
  });
});

describe.each(['README.md', 'docs/typescript.md'])('TypeScript in %s', (document) => {
  test.each(examples(document, 'ts'))('%#', (code) => {
    const source = join(folder, 'example.ts');
    writeFileSync(source, code.replaceAll("'./wasm/", "'../../wasm/"));
    writeFileSync(join(folder, 'tsconfig.json'), '{ "extends": "../../tsconfig.json", "include": ["example.ts"] }');
    execFileSync('node_modules/.bin/tsc', ['--project', folder]);
    const printed = execFileSync('node_modules/.bin/tsx', [source], { encoding: 'utf8' });
    expectPromised(printed, code);
  });
});

test('the command line in README.md', async () => {
  const { position, triangles } = bumpyPlate(20);
  const count = position.length / 3;
  const pressure = Float64Array.from({ length: count }, (_, vertex) => position[3 * vertex]);
  const velocity = Float64Array.from({ length: 3 * count }, (_, i) => Math.sin(position[i]));
  const variables = [
    { name: 'pressure', components: 1, values: pressure },
    { name: 'velocity', components: 3, values: velocity },
  ];
  writeFileSync(join(folder, 'part.vtp'), await writeSurface('vtp', { position, triangles, variables }));
  const script = `set -e\nnpx() { shift; "${process.execPath}" "${resolve('build/cli/meshbound.mjs')}" "$@"; }\n`;
  for (const code of examples('README.md', 'sh')) {
    const { status, stderr, stdout } = spawnSync('sh', ['-c', script + code], { cwd: folder, encoding: 'utf8' });
    expect(stderr).not.toMatch(/error/i);
    expect(status, stderr + stdout).toBe(0);
  }
});
