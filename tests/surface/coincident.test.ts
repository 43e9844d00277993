import { expect, test } from 'vitest';
import { coincidentIn } from '../../web/surface/coincident.ts';

const count = (...triangles: number[][]) => coincidentIn(Uint32Array.from(triangles.flat()), 100);

test.each([
  ['one triangle', [[0, 1, 2]], 0, 0],
  [
    'two that share an edge',
    [
      [0, 1, 2],
      [0, 2, 3],
    ],
    0,
    0,
  ],
  [
    'the same, from another corner',
    [
      [0, 1, 2],
      [1, 2, 0],
      [2, 0, 1],
    ],
    2,
    0,
  ],
  [
    'two sides',
    [
      [7, 3, 5],
      [3, 7, 5],
    ],
    0,
    1,
  ],
  [
    'two sides, twice each',
    [
      [7, 3, 5],
      [3, 7, 5],
      [5, 7, 3],
      [5, 3, 7],
    ],
    2,
    1,
  ],
  [
    'with a point twice, which are none',
    [
      [0, 0, 2],
      [0, 0, 2],
    ],
    0,
    0,
  ],
] as const)('%s', (_, triangles, copied, twoSided) => {
  expect(count(...triangles.map((each) => [...each]))).toEqual({
    copiedTriangles: copied,
    twoSidedTriangles: twoSided,
  });
});
