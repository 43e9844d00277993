import { describe, expect, test } from 'vitest';
import { cornerNormals } from '../../web/viewer/corner-normals.ts';
import { frameOf } from '../../web/viewer/frame.ts';
import { surfaceArrays } from '../../web/viewer/surface-arrays.ts';

/** Two triangles that share an edge along x and meet at `degrees` there: 0 is flat. */
function folded(degrees: number): { corners: Float32Array; triangles: Uint32Array } {
  const bend = (degrees * Math.PI) / 180;
  const [low, high] = [
    [0, -1, 0],
    [0, Math.cos(bend), Math.sin(bend)],
  ];
  const points = [[-1, 0, 0], [1, 0, 0], high, low];
  const triangles = [0, 1, 2, 1, 0, 3];
  return {
    corners: new Float32Array(triangles.flatMap((vertex) => points[vertex])),
    triangles: new Uint32Array(triangles),
  };
}

describe('normals for smooth shading', () => {
  test('are the mean across a bend', () => {
    const { corners, triangles } = folded(30);
    const normals = cornerNormals(corners, triangles, 4);
    const half = (15 * Math.PI) / 180;
    // The first corner lies on the shared edge, the third on the upper triangle alone.
    expect([...normals.subarray(0, 3)]).toEqual([
      0,
      expect.closeTo(-Math.sin(half), 6),
      expect.closeTo(Math.cos(half), 6),
    ]);
    expect(normals[8]).toBeCloseTo(Math.cos(2 * half), 6);
  });

  test('are those of each face across a crease', () => {
    const { corners, triangles } = folded(90);
    const normals = cornerNormals(corners, triangles, 4);
    expect([...normals.subarray(0, 3)].map((part) => Math.round(part) + 0)).toEqual([0, -1, 0]);
    expect([...normals.subarray(9, 12)].map((part) => Math.round(part) + 0)).toEqual([0, 0, 1]);
  });

  test('stay numbers on a triangle without area', () => {
    const normals = cornerNormals(new Float32Array(9), new Uint32Array([0, 1, 2]), 3);
    expect(normals.every(Number.isFinite)).toBe(true);
  });
});

describe('a surface as it is drawn', () => {
  const position = new Float64Array([1e7, 0, 0, 1e7 + 2, 0, 0, 1e7, 2, 0]);
  const triangles = new Uint32Array([0, 1, 2]);
  const frame = frameOf({ position, triangles });

  test('fills the frame around the origin', () => {
    expect(frame.centre).toEqual([1e7 + 1, 1, 0]);
    expect(frame.radius).toBeCloseTo(Math.SQRT2, 12);
  });

  test('keeps its shape far from the origin, where single precision alone would lose it', () => {
    const { corners } = surfaceArrays({ position, triangles }, frame);
    const edge = Math.hypot(corners[3] - corners[0], corners[4] - corners[1], corners[5] - corners[2]);
    expect(edge).toBeCloseTo(Math.SQRT2, 6);
  });

  test('a surface of a single place has a frame too', () =>
    expect(frameOf({ position: new Float32Array(9), triangles }).radius).toBe(1));

  test.each([[Number.NaN], [0], [-1e300]])(
    'its frame is that of what triangles use, whatever stands at %d',
    (place) => {
      const more = Float64Array.of(...position, place, 0, 0, place, place, place);
      expect(frameOf({ position: more, triangles: Uint32Array.of(3, 4, 4, 0, 1, 2) })).toEqual(frame);
    },
  );

  test('what names a point twice is drawn nowhere, and shades nothing', () => {
    const more = Float64Array.of(...position, Number.NaN, 0, 0);
    const drawn = surfaceArrays({ position: more, triangles: Uint32Array.of(0, 1, 2, 0, 0, 3) }, frame);
    expect(drawn.corners.subarray(0, 9)).toEqual(surfaceArrays({ position, triangles }, frame).corners);
    expect(drawn.normals.subarray(0, 9)).toEqual(surfaceArrays({ position, triangles }, frame).normals);
    expect([...drawn.corners.subarray(9)]).toEqual(Array(9).fill(0));
  });
});
