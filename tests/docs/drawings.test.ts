// The drawings in docs/drawings are what their scripts draw, and every picture that a document shows is there.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { drawings } from '../../docs/drawings/drawings.ts';

test.each(Object.entries(drawings))('%s is as its script draws it', (name, draw) => {
  expect(readFileSync(`docs/drawings/${name}.svg`, 'utf8')).toBe(draw());
});

const documents = ['README.md', ...readdirSync('docs').map((name) => join('docs', name))].filter((path) =>
  path.endsWith('.md'),
);

test.each(documents)('%s links to files that are there', (path) => {
  const links = Array.from(readFileSync(path, 'utf8').matchAll(/\]\(([^)#]+)[^)]*\)/g), ([, link]) => link);
  const missing = links.filter((link) => !link.includes('://') && !existsSync(join(path, '..', link)));
  expect(missing).toEqual([]);
});
