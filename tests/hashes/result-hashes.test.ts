// Every system gives the same bytes: those whose hashes expected.txt has. Wants the presets native, clang and arm64 built; the
// last is run by an emulator. Where a change of the bytes is meant: npm run hashes:renew.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';

import { mustSkip } from '../skipping.ts';

const program = (preset: string) => `build/${preset}/tests/hashes/result_hashes`;

const systems = [
  { name: `GCC on ${process.arch}`, command: [program('native')] },
  { name: `Clang on ${process.arch}`, command: [program('clang')] },
];
if (process.arch === 'x64') {
  const emulated = ['qemu-aarch64', '-L', '/usr/aarch64-linux-gnu', program('arm64')];
  systems.push({ name: 'GCC on arm64, emulated', command: emulated });
}

const expected = readFileSync('tests/hashes/expected.txt', 'utf8').trim().split('\n');

test('no two results are the same', () => {
  expect(expected.length).toBeGreaterThan(80);
  expect(new Set(expected.map((line) => line.split(' ')[0])).size).toBe(expected.length);
});

for (const { name, command } of systems) {
  const missing = existsSync(command[command.length - 1]) ? undefined : `${command.at(-1)} is missing`;
  test.skipIf(mustSkip(missing))(`${name} gives the bytes expected`, () => {
    const found = execFileSync(command[0], command.slice(1), { encoding: 'utf8' }).trim().split('\n');
    expect(found).toEqual(expected);
  });
}
