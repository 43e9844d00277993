// What the documents link to, show and name is there.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';

const folders = ['.', 'docs', 'examples'];
const documents = folders
  .flatMap((folder) => readdirSync(folder).map((name) => join(folder, name)))
  .filter((path) => path.endsWith('.md'));

function matches(path: string, pattern: RegExp): string[] {
  return Array.from(readFileSync(path, 'utf8').matchAll(pattern), ([, match]) => match);
}

test.each(documents)('%s links to files that are there', (path) => {
  const links = matches(path, /\]\(([^)#]+)[^)]*\)/g);
  const missing = links.filter((link) => !link.includes('://') && !existsSync(join(path, '..', link)));
  expect(missing).toEqual([]);
});

test.each(documents)('%s names files that are there', (path) => {
  const named = matches(path, /`((?:\.ci|scripts|core|wasm|web|tests|workers|examples)\/[\w./-]+)`/g);
  expect(named.filter((name) => !existsSync(name))).toEqual([]);
});

test.each(documents)('%s names commands that are there', (path) => {
  const { scripts } = JSON.parse(readFileSync('package.json', 'utf8')) as { scripts: Record<string, string> };
  const named = matches(path, /npm run ([\w:]+)/g);
  expect(named.filter((name) => !(name in scripts))).toEqual([]);
});
