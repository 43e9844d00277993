// The examples that run without a browser do what they say. Wants a build (npm run build) and a native one.
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync, rmSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { expect, test } from 'vitest';

const scratch = resolve('build/examples-cpp');

function run(program: string, ...args: string[]): string {
  return execFileSync(program, args, { encoding: 'utf8', stdio: 'pipe' });
}

test('the list names every example and no other', () => {
  const folders = readdirSync('examples', { withFileTypes: true }).filter((entry) => entry.isDirectory());
  const named = readFileSync('examples/README.md', 'utf8').matchAll(/^\| `examples\/(\w+)` \|/gm);
  expect(Array.from(named, ([, name]) => name).sort()).toEqual(folders.map(({ name }) => name).sort());
});

test('the C++ program finds the installed library and reduces a hill', () => {
  rmSync(scratch, { recursive: true, force: true });
  run('cmake', '--install', 'build/native', '--prefix', join(scratch, 'prefix'));
  const build = join(scratch, 'build');
  run('cmake', '-S', 'examples/cpp', '-B', build, `-DCMAKE_PREFIX_PATH=${join(scratch, 'prefix')}`);
  run('cmake', '--build', build);
  const [, before, after] = run(join(build, 'reduce')).match(/^(\d+) triangles became (\d+)$/m) ?? [];
  expect(Number(before)).toBe(2048);
  expect(Number(after)).toBeLessThan(500);
});

test('the script for Node reduces a hill, further for larger bounds', () => {
  const printed = run('node_modules/.bin/tsx', 'examples/node/reduce.ts');
  const after = Array.from(printed.matchAll(/8192 triangles became (\d+);/g), ([, count]) => Number(count));
  expect(after).toHaveLength(3);
  expect(after).toEqual([...after].sort((one, other) => other - one));
  expect(after[2]).toBeLessThan(after[0]);
});
