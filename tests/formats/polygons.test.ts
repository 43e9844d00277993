import { describe, expect, it } from 'vitest';
import { triangulate } from '../../web/formats/faces/polygons.ts';

/** A comb: every other tooth reaches down, so no fan covers it; no three of its corners lie on a line. */
function comb(corners: number) {
  const position = Float64Array.from({ length: 3 * corners }, (_, i) => {
    const corner = Math.floor(i / 3);
    const last = corner === corners - 1;
    return [last ? corners / 2 : corner, last ? 100 * corners : (corner % 2) + (corner / corners) ** 2, 0][i % 3];
  });
  return {
    position,
    polygons: { corners: Uint32Array.from({ length: corners }, (_, i) => i), ends: Uint32Array.of(corners) },
  };
}

describe('splitting polygons', () => {
  it('covers a concave one exactly, every triangle its way round', () => {
    const { position, polygons } = comb(41);
    const { triangles, split } = triangulate(polygons, position, 'face');
    const areaOf = ([a, b, c]: ArrayLike<number> & Iterable<number>) => {
      const [ux, uy] = [position[3 * b] - position[3 * a], position[3 * b + 1] - position[3 * a + 1]];
      const [vx, vy] = [position[3 * c] - position[3 * a], position[3 * c + 1] - position[3 * a + 1]];
      return (ux * vy - uy * vx) / 2;
    };
    const areas = Array.from({ length: 39 }, (_, i) => areaOf(triangles.subarray(3 * i, 3 * i + 3)));
    let outline = 0;
    for (let i = 1; i + 1 < 41; i++) outline += areaOf([0, i, i + 1]);
    expect({ split, count: triangles.length / 3 }).toEqual({ split: 1, count: 39 });
    expect(areas.every((area) => Math.sign(area) === Math.sign(outline))).toBe(true);
    expect(areas.reduce((a, b) => a + b)).toBeCloseTo(outline);
  });

  it('takes what has no area or no finite place as a fan', () => {
    const polygons = { corners: Uint32Array.of(0, 1, 2, 3), ends: Uint32Array.of(4) };
    for (const position of [new Float32Array(12), new Float32Array(12).fill(Number.NaN)]) {
      expect(Array.from(triangulate(polygons, position, 'face').triangles)).toEqual([0, 1, 2, 0, 2, 3]);
    }
  });

  it('refuses concave ones that would take for ever', () => {
    const { position, polygons } = comb(2001);
    expect(() => triangulate(polygons, position, 'face')).toThrow(/concave face 0 has 2 001 corners/);
    const many = (corners: number, count: number) => {
      const one = comb(corners);
      const ends = Uint32Array.from({ length: count }, (_, i) => (i + 1) * corners);
      const all = Uint32Array.from({ length: count * corners }, (_, i) => i % corners);
      return triangulate({ corners: all, ends }, one.position, 'face').triangles.length / 3;
    };
    expect(() => many(2000, 26)).toThrow(/concave face 25 has 2 000 corners, which is too much after/);
    expect(many(2000, 20)).toBe(20 * 1998);
    expect(many(5, 100_000)).toBe(300_000);
  });
});
