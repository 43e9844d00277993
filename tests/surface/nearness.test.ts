import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { multiplierNear } from '../../web/surface/nearness.ts';

/** A square of two triangles a unit, in the plane z = 0. */
function plate(side: number) {
  const at = (column: number, row: number) => row * (side + 1) + column;
  const all = Array.from({ length: (side + 1) ** 2 }, (_, i) => [i % (side + 1), Math.floor(i / (side + 1))]);
  const squares = all.filter(([column, row]) => column < side && row < side);
  return {
    position: Float64Array.from(all.flatMap(([x, y]) => [x, y, 0])),
    triangles: Uint32Array.from(
      squares.flatMap(([x, y]) => [
        ...[at(x, y), at(x + 1, y), at(x + 1, y + 1)],
        ...[at(x, y), at(x + 1, y + 1), at(x, y + 1)],
      ]),
    ),
    variables: [],
  };
}

describe('what multiplies the bounds near a point', () => {
  const mesh = plate(20);

  test('is the factor at every point within the radius, and 1 beyond', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 0, max: 20, noNaN: true }),
        fc.double({ min: 0, max: 20, noNaN: true }),
        fc.double({ min: 0.01, max: 8, noNaN: true }),
        fc.double({ min: 0.001, max: 1, noNaN: true }),
        (x, y, radius, factor) => {
          const multiplier = multiplierNear(mesh, { point: [x, y, 0], radius, factor });
          const reaches = (corners: number[]) => corners.some((each) => awayFrom(each, x, y) <= radius);
          for (let first = 0; first < mesh.triangles.length; first += 3) {
            const corners = [...mesh.triangles.subarray(first, first + 3)];
            if (!reaches(corners)) continue;
            for (const corner of corners) expect(multiplier[corner]).toBe(factor);
          }
          multiplier.forEach((each, vertex) => {
            expect(each).toBeGreaterThanOrEqual(factor);
            expect(each).toBeLessThanOrEqual(1);
            // The triangles around a vertex reach no farther than their longest edge.
            if (awayFrom(vertex, x, y) > 2 * radius + Math.SQRT2) expect(each).toBe(1);
          });
        },
      ),
    );
  });

  test('reaches a point in the middle of a triangle that is larger than the radius', () => {
    const multiplier = multiplierNear(mesh, { point: [7.6, 3.3, 0], radius: 0.01, factor: 0.2 });
    const finer = [...multiplier.keys()].filter((vertex) => multiplier[vertex] < 1);
    expect(finer).toEqual([3 * 21 + 7, 3 * 21 + 8, 4 * 21 + 8]);
    for (const vertex of finer) expect(multiplier[vertex]).toBe(0.2);
  });

  test('rises on the way from the radius to twice the radius', () => {
    const multiplier = multiplierNear(mesh, { point: [10, 10, 0], radius: 4, factor: 0.5 });
    const row = Array.from({ length: 11 }, (_, column) => multiplier[10 * 21 + 10 + column]);
    expect(row).toEqual([...row].sort((a, b) => a - b));
    expect(row[5]).toBe(0.5);
    expect(row[7]).toBeCloseTo(0.75);
    expect(row[9]).toBe(1);
  });

  function awayFrom(vertex: number, x: number, y: number): number {
    return Math.hypot(mesh.position[3 * vertex] - x, mesh.position[3 * vertex + 1] - y);
  }
});

test('triangles that name a point twice count for nothing, whatever stands at their points', () => {
  const mesh = plate(4);
  const at = { point: [0, 0, 0] as const, radius: 1, factor: 0.1 };
  const position = Float64Array.of(...mesh.position, Number.NaN, 0, 0, 0, 0, 0);
  const points = mesh.position.length / 3;
  const more = { ...mesh, position, triangles: Uint32Array.of(...mesh.triangles, 24, 24, points, 24, points + 1, 24) };
  expect(multiplierNear(more, at)).toEqual(Float64Array.of(...multiplierNear(mesh, at), 1, 1));
});
