import { describe, expect, test } from 'vitest';
import { reduceLevels } from '../../wasm/index.ts';
import { faceNormals } from '../../web/viewer/corner-normals.ts';
import { frameOf } from '../../web/viewer/frame.ts';
import { carriedOver, type MorphEnd, morphArrays, morphCorners } from '../../web/viewer/morph-corners.ts';
import { surfaceArrays } from '../../web/viewer/surface-arrays.ts';
import { bumpyPlate } from '../wasm/bumpy-plate.ts';

/**
 * A square with the corners 0 1 / 3 2 and its diagonal from 0 to 2; the morph has the middle of the diagonal as its corner 4,
 * which divides both triangles.
 */
const square = Uint32Array.of(0, 1, 2, 0, 2, 3);
const divided = Uint32Array.of(0, 1, 4, 1, 2, 4, 0, 4, 3, 4, 2, 3);
const onSquare: MorphEnd = {
  triangle: Uint32Array.of(0, 0, 1, 1),
  vertices: Uint32Array.of(0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 0, 2, 0),
  weights: Float64Array.of(1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0.5, 0.5, 0),
};

describe('the corners of a morph on a level', () => {
  const corners = morphCorners(divided, onSquare, square);

  test('have weights in the triangle that they are seen from', () => {
    const weightsOf = (corner: number) => Array.from(corners.weights.subarray(3 * corner, 3 * corner + 3));
    expect(weightsOf(0)).toEqual([1, 0, 0]);
    expect(weightsOf(1)).toEqual([0, 1, 0]);
    expect(weightsOf(2)).toEqual([0.5, 0, 0.5]); // the middle, from the triangle 0 1 2
    expect(weightsOf(7)).toEqual([0.5, 0.5, 0]); // and from 0 2 3
  });

  test('get what is linear on the level, in every part', () => {
    const ofCorners = Float32Array.of(0, 10, 20, 0, 20, 30);
    const pairs = Float32Array.from({ length: 12 }, (_, i) => ofCorners[Math.floor(i / 2)] * (i % 2 ? -1 : 1));
    const expected = [0, 10, 10, 10, 20, 10, 0, 10, 30, 10, 20, 30];
    expect(Array.from(carriedOver(ofCorners, 1, corners))).toEqual(expected);
    expect(Array.from(carriedOver(pairs, 2, corners))).toEqual(expected.flatMap((value) => [value, 0 - value]));
  });

  test('keep what is flat on a triangle flat, missing places too', () => {
    const flat = Float32Array.of(0.3, 0.3, 0.3, -1, -1, -1);
    const carried = carriedOver(flat, 1, corners);
    expect(new Set(carried.subarray(0, 6))).toEqual(new Set([Math.fround(0.3)]));
    expect(new Set(carried.subarray(6))).toEqual(new Set([-1]));
  });
});

describe('a morph as it is drawn', async () => {
  const mesh = bumpyPlate(30);
  const percent = (share: number) => ({ '*': { relative: share / 100 } });
  const { levels, morphs } = await reduceLevels(mesh, { levels: [percent(1), percent(3)], morphs: true });
  const surfaces = [mesh, ...levels.map((level) => level.mesh)];
  const frame = frameOf(mesh);
  const drawn = surfaces.map((surface) => surfaceArrays(surface, frame));

  test('stands at both ends where the morph of the core has its corners', () => {
    morphs.forEach((morph, i) => {
      [morph.finer, morph.coarser].forEach((end, side) => {
        const at = morphCorners(morph.triangles, end, surfaces[i + side].triangles);
        const { corners } = morphArrays(drawn[i + side], at);
        let farthest = 0;
        corners.forEach((coordinate, index) => {
          const axis = index % 3;
          const exact = end.position[3 * morph.triangles[Math.floor(index / 3)] + axis];
          farthest = Math.max(farthest, Math.abs(coordinate - (exact - frame.centre[axis]) / frame.radius));
        });
        expect(farthest).toBeLessThan(1e-6);
      });
    });
  });

  test('has no cracks: a corner stands at one place, whichever triangle it is seen from, to the last bit', () => {
    morphs.forEach((morph, i) => {
      [morph.finer, morph.coarser].forEach((end, side) => {
        const at = morphCorners(morph.triangles, end, surfaces[i + side].triangles);
        const { corners } = morphArrays(drawn[i + side], at);
        const seen = new Map<number, string>();
        const torn = morph.triangles.filter((corner, n) => {
          const place = corners.subarray(3 * n, 3 * n + 3).join();
          const before = seen.get(corner) ?? place;
          seen.set(corner, place);
          return before !== place;
        });
        expect(torn).toHaveLength(0);
      });
    });
  });

  test('begins and ends at the very numbers with which the levels are drawn', () => {
    morphs.forEach((morph, i) => {
      [morph.finer, morph.coarser].forEach((end, side) => {
        const level = surfaces[i + side];
        const { corners } = morphArrays(drawn[i + side], morphCorners(morph.triangles, end, level.triangles));
        const places = new Set(Array.from(morph.triangles, (_, n) => corners.subarray(3 * n, 3 * n + 3).join()));
        const exact = drawn[i + side].corners;
        const missing = level.triangles.filter((_, n) => !places.has(exact.subarray(3 * n, 3 * n + 3).join()));
        expect(missing).toHaveLength(0);
      });
    });
  });

  test('is lit and outlined as the triangles of the levels are', () => {
    const { triangles, coarser } = morphs[1];
    const at = morphCorners(triangles, coarser, surfaces[2].triangles);
    const { faces, within } = morphArrays(drawn[2], at);
    const { unit } = faceNormals(drawn[2].corners);
    const hosts = Array.from(triangles, (_, n) => at.triangle[Math.floor(n / 3)]);
    const normals = hosts.flatMap((host) => Array.from(unit.subarray(3 * host, 3 * host + 3)));
    expect(normals.filter((part, n) => !(Math.abs(faces[n] / 32767 - part) < 1e-4))).toEqual([]);
    expect(at.weights.filter((weight, n) => !(Math.abs(within[n] / 65535 - weight) < 1e-4))).toHaveLength(0);
    // What lies on an edge lies on it exactly, for the edge is drawn there.
    expect(within.every((weight, n) => weight > 0 || at.weights[n] < 1e-5)).toBe(true);
    expect(at.weights.every((weight, n) => weight > 0 || within[n] === 0)).toBe(true);
  });

  test('has values that the corners of the core have, too', () => {
    morphs.forEach((morph, i) => {
      const { triangles, variables } = surfaces[i];
      const heights = Float32Array.from(triangles, (vertex) => variables[0].values[vertex]);
      const carried = carriedOver(heights, 1, morphCorners(morph.triangles, morph.finer, triangles));
      const exact = morph.finer.variables[0].values;
      expect(carried.every((value, corner) => Math.abs(value - exact[morph.triangles[corner]]) < 1e-6)).toBe(true);
    });
  });

  test('has weights that add up to 1 everywhere', () => {
    const { triangles, finer, coarser } = morphs[1];
    for (const [end, level] of [
      [finer, surfaces[1]],
      [coarser, surfaces[2]],
    ] as const) {
      const ones = new Float32Array(level.triangles.length).fill(1);
      const sums = carriedOver(ones, 1, morphCorners(triangles, end, level.triangles));
      expect(sums.every((sum) => Math.abs(sum - 1) < 1e-6)).toBe(true);
    }
  });
});
