// The drawings in docs/drawings are what their scripts draw.
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { drawings } from '../../docs/drawings/drawings.ts';

test.each(Object.entries(drawings))('%s is as its script draws it', (name, draw) => {
  expect(readFileSync(`docs/drawings/${name}.svg`, 'utf8')).toBe(draw());
});
