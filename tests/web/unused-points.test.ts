// Points that no triangle of three distinct points uses count for nothing on the page either, whatever stands there.

import { describe, expect, test } from 'vitest';
import type { Mesh } from '../../wasm/types.ts';
import { fieldRange, usedValues } from '../../web/colour/field.ts';
import { nearestVertex } from '../../web/page/constraints/nearest-vertex.ts';
import { placeInSight } from '../../web/page/constraints/proposed-place.ts';
import { boundsForFile, leastMultiplier } from '../../web/session/bounds/bounds-for-file.ts';
import { unusedNotes } from '../../web/session/report/defect-notes.ts';
import { spanOf } from '../../web/surface/value-span.ts';

describe.each([[Number.NaN], [1e9], [0]])('points at %d', (place) => {
  /** Two stray points, one of them named by a triangle that names it twice, then a triangle. */
  const mesh: Mesh = {
    position: Float64Array.of(place, place, place, place, 0, 0, 1, 1, 1, 2, 1, 1, 1, 3, 1),
    triangles: Uint32Array.of(1, 1, 2, 2, 3, 4),
    variables: [{ name: 't', components: 1, values: Float64Array.of(place, -place, 0.5, 6, 7) }],
  };
  const [t] = mesh.variables;

  test('are no values', () => {
    expect([...usedValues(t.values, mesh.triangles)]).toEqual([0.5, 6, 7]);
    expect(fieldRange(t.values, mesh.triangles)).toEqual({ lowest: 0.5, highest: 7 });
    expect(spanOf(t, mesh.triangles)).toEqual({
      components: [{ lowest: 0.5, highest: 7 }],
      extent: 6.5,
      magnitude: 7,
      constant: false,
      nan: 0,
      infinite: 0,
    });
  });

  test('are neither near nor in sight', () => {
    expect(nearestVertex(mesh, [place || 0, 0, 0])).toBeGreaterThan(1);
    expect(nearestVertex(mesh, [1.9, 1, 1])).toBe(3);
    expect(placeInSight(mesh)).toEqual([1, 3, 1]);
  });

  test('multiply no bound', () => {
    expect(leastMultiplier(mesh, 't')).toBe(0.5);
    expect(leastMultiplier(mesh, null)).toBe(1);
    const { bounds } = boundsForFile('ply', mesh, { t: { relative: 0.1 } });
    expect(bounds).toEqual({ t: { relative: 0.1 } });
  });
});

test('are counted', () => {
  expect(unusedNotes(0)).toEqual([]);
  expect(unusedNotes(1)).toEqual(['1 vertex belongs to no triangle: left out of the result.']);
});
