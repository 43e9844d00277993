import { expect, test } from 'vitest';
import type { Measurement } from './cases.ts';
import type { Row } from './row.ts';
import { table } from './table.ts';

const triangles = 1000;

function took(cpu: number, left: number): Measurement {
  return { wall: cpu, cpu, triangles, left, peakBytes: 0 };
}

/** The cells of a table with one row, by the titles of their columns. */
function cells(results: Row['results']): Record<string, string> {
  const split = (line: string) => line.split('|').map((cell) => cell.trim());
  const [titles = [], , row = []] = table([{ size: 'small', variables: 7, results }])
    .split('\n')
    .map(split);
  return Object.fromEntries(titles.map((title, column) => [title, row[column] ?? '']));
}

test('where a peer leaves as many triangles, the times are compared', () => {
  const row = cells({ native: took(2, 100), module: took(4, 100), meshoptimizer: took(1, 100), VTK: took(16, 100) });
  expect(row['native : meshoptimizer']).toBe('0.50');
  expect(row['module : meshoptimizer']).toBe('0.25');
  expect(row['native : VTK']).toBe('8.0');
});

test('a peer that gives up is not the faster for it: what it removed counts, and what it left is named', () => {
  // A tenth of the triangles in half of the time: a fifth of the speed.
  const row = cells({ native: took(2, 100), module: took(4, 100), meshoptimizer: took(1, 910), VTK: took(1, 910) });
  expect(row['native : VTK']).toBe('5.0 (910 left)');
  expect(row['native : meshoptimizer']).toBe('5.0 (910 left)');
  expect(row['module : meshoptimizer']).toBe('2.5 (910 left)');
  expect(row.left).toBe('100');
});

test('a peer that stops within a collapse of what it was asked for did not give up', () => {
  expect(cells({ native: took(1, 100), VTK: took(1, 102) })['native : VTK']).toBe('1.0');
  expect(cells({ native: took(1, 100), VTK: took(1, 103) })['native : VTK']).toBe('1.0 (103 left)');
  expect(cells({ native: took(1, 100), VTK: took(1, 98) })['native : VTK']).toBe('1.0');
});

test('a peer that removes nothing has no speed to compare with', () => {
  expect(cells({ native: took(1, 100), VTK: took(1, triangles) })['native : VTK']).toBe('– (1000 left)');
});

test('a peer that failed has no figure', () => {
  expect(cells({ native: took(1, 100) })['native : VTK']).toBe('–');
});

test('the two accounts of errors leave different numbers, at the same bounds: their times are compared', () => {
  const row = cells({ native: took(1, 100), 'native, propagated': took(0.5, 400) });
  expect(row['propagated : tracked']).toBe('2.0');
  expect(row['propagated, left']).toBe('400');
});
