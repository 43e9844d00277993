import { expect, test } from 'vitest';

import { figureKey, type Row, readFigures, tables } from './table.ts';

test('reads back the figures of the peers from its own tables', () => {
  const reduced = { triangles: 10, seconds: 1, ratio: 0.9, boundaryRatio: 0.8 };
  const row = (surface: string, bounds: string, meshoptimizer: number, keepsBoundary: boolean): Row => ({
    surface,
    triangles: 100,
    variables: 2,
    bounds,
    tracked: reduced,
    propagated: reduced,
    peers: { meshoptimizer: { triangles: meshoptimizer, keepsBoundary }, VTK: { triangles: 90, keepsBoundary: true } },
  });
  const rows = [row('plate', '0.1/1', 50, true), row('plate', '1/3', 40, false), row('pleats', '1/3', 30, true)];
  const figures = readFigures(`Text | with | bars\n\n${tables(rows)}\n`);
  expect(figures.size).toBe(rows.length);
  for (const { surface, bounds, peers } of rows) expect(figures.get(figureKey(surface, bounds))).toEqual(peers);
});

test('reads nothing from a text without tables', () => {
  expect(readFigures('').size).toBe(0);
  expect(readFigures('## Results\n\n| a | b |\n| --- | --- |\n| 1 | 2 |\n').size).toBe(0);
});
