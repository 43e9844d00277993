import { describe, expect, test } from 'vitest';
import { regionBorders } from '../../web/surface/region-borders.ts';

/** Edges as text, the lower end first, in order. */
function edgesOf(ends: Float64Array): string[] {
  const edges = Array.from({ length: ends.length / 6 }, (_, edge) =>
    [0, 3].map((end) => [...ends.subarray(6 * edge + end, 6 * edge + end + 3)].join(',')).sort(),
  );
  return edges.map((edge) => edge.join(' – ')).sort();
}

/** Two squares side by side, four triangles, and a fifth on the edge in the middle. */
const mesh = {
  position: Float32Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 1, 0.5, 1]),
  triangles: Uint32Array.from([0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 1, 4, 6]),
  variables: [],
};
const middle = '1,0,0 – 1,1,0';

describe('borders between regions', () => {
  test('are the edges between different labels, each once', () => {
    expect(edgesOf(regionBorders(mesh, Int32Array.of(3, 3, -1, -1, 3)))).toEqual([middle]);
    expect(edgesOf(regionBorders(mesh, Int32Array.of(1, 2, 3, 4, 5)))).toEqual([
      '0,0,0 – 1,1,0',
      middle,
      '1,0,0 – 2,1,0',
    ]);
  });

  test('are none where all labels are alike', () => {
    expect(regionBorders(mesh, new Int32Array(5).fill(7))).toHaveLength(0);
  });
});
