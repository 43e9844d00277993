import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';

/** Text of another language, in which quotation marks are what that language has: XML, HTML, bounds, a command to be typed. */
const otherLanguages = [
  'web/formats/vtp/write-vtp.ts',
  'web/element/attributes/viewer-state.ts',
  'web/session/bounds/bound-text.ts',
  'web/guide/main.ts',
  'web/node-cli/fault.ts',
];

function filesIn(folder: string, ending: RegExp): string[] {
  const names = readdirSync(folder, { recursive: true }).map((name) => join(folder, String(name)));
  return names.filter((path) => ending.test(path) && !otherLanguages.includes(path));
}

function linesWith(pattern: RegExp, paths: string[]): string[] {
  return paths.flatMap((path) => {
    const lines = readFileSync(path, 'utf8').split('\n');
    return lines.filter((line) => pattern.test(line)).map((line) => `${path}: ${line.trim()}`);
  });
}

it('every message quotes by curly marks, in C++', () => {
  const files = [...filesIn('core/src', /\.[ch]pp$/), ...filesIn('wasm', /\.[ch]pp$/)];
  expect(files.length).toBeGreaterThan(50);
  expect(linesWith(/\\"/, files)).toEqual([]);
});

it('every message quotes by curly marks, in TypeScript', () => {
  const files = [...filesIn('web', /\.ts$/), ...filesIn('wasm', /\.ts$/)];
  expect(files.length).toBeGreaterThan(100);
  // A value between straight marks in a template, where it is no attribute of an element.
  expect(linesWith(/(?<![=\w])(["'])\$\{[^}]*\}\1/, files)).toEqual([]);
});
