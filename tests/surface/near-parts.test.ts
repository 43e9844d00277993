import fc from 'fast-check';
import { expect, test } from 'vitest';
import { havePartsWithin } from '../../web/surface/near-parts.ts';

/** A square grid of triangles at height `z`, from (x, y) on, its points moved by `bend`. */
function grid(side: number, x: number, y: number, z: number, bend = (_x: number, _y: number) => 0) {
  const [position, triangles]: number[][] = [[], []];
  for (let row = 0; row <= side; row++) {
    for (let column = 0; column <= side; column++) {
      const [u, v] = [column / side, row / side];
      position.push(x + u, y + v, z + bend(u, v));
      if (row === side || column === side) continue;
      const at = row * (side + 1) + column;
      triangles.push(at, at + 1, at + side + 2, at, at + side + 2, at + side + 1);
    }
  }
  return { position, triangles };
}

function together(...grids: ReturnType<typeof grid>[]) {
  const [position, triangles]: number[][] = [[], []];
  for (const each of grids) {
    const shift = position.length / 3;
    for (const coordinate of each.position) position.push(coordinate);
    for (const corner of each.triangles) triangles.push(corner + shift);
  }
  return { position: Float64Array.from(position), triangles: Uint32Array.from(triangles) };
}

test('one part is near nothing, however it is folded', () => {
  const folded = together(grid(8, 0, 0, 0, (u) => 1e-3 * Math.sin(40 * u)));
  expect(havePartsWithin(folded, 1)).toBe(false);
});

test.each([1, 3, 20])(
  'sheets of %i squares a side above each other are near within their distance, and not below',
  (side) => {
    for (const offset of [0, 6e6]) {
      const sheets = together(grid(side, offset, offset, 0), grid(7, offset + 0.013, offset, 0.01));
      expect(havePartsWithin(sheets, 0.0101)).toBe(true);
      expect(havePartsWithin(sheets, 0.0099)).toBe(false);
    }
  },
);

test('large triangles beside small ones, edge against edge, are measured exactly', () => {
  const bar = (x: number, z: number, along: 'x' | 'y') => {
    const place = (t: number, s: number) =>
      along === 'x' ? [x + t, 0.001 * s, z + 0.001 * s] : [x + 0.001 * s, t - 5, z];
    return { position: [...place(0, 0), ...place(10, 0), ...place(5, -1)], triangles: [0, 1, 2] };
  };
  const crossing = together(bar(0, 0, 'x'), bar(5, 0.02, 'y'), grid(30, 40, 0, 0));
  expect(havePartsWithin(crossing, 0.0201)).toBe(true);
  expect(havePartsWithin(crossing, 0.0199)).toBe(false);
});

test('parts in one place, as along seams, are one', () => {
  expect(havePartsWithin(together(grid(5, 0, 0, 0), grid(5, 1, 0, 0)), 0.5)).toBe(false);
  expect(havePartsWithin(together(grid(5, 0, 0, 0), grid(5, 1.01, 0, 0)), 0.5)).toBe(true);
});

test('no bound, or none at all, is near nothing', () => {
  const sheets = together(grid(3, 0, 0, 0), grid(3, 0, 0, 0.1));
  for (const within of [0, -1, Number.NaN, Infinity]) expect(havePartsWithin(sheets, within)).toBe(false);
});

test('many parts give the answer that looking at every pair gives', () => {
  const places = fc.array(fc.tuple(fc.integer({ min: 0, max: 4000 }), fc.integer({ min: 0, max: 4000 })), {
    minLength: 2,
    maxLength: 12,
  });
  fc.assert(
    fc.property(places, fc.double({ min: 0.01, max: 0.5, noNaN: true }), (list, within) => {
      // Squares in one plane: their distance is that of their boxes. No two have a corner in one place.
      const at = list.map((place, i) => place.map((part) => 0.0015 * part + 1e-5 * Math.PI * i));
      const mesh = together(...at.map(([x, y], i) => grid(1 + (i % 3), x, y, 0)));
      const gap = (a: number, b: number) => Math.max(0, Math.abs(a - b) - 1);
      const pairs = at.flatMap((one, i) => at.slice(i + 1).map((other) => [one, other]));
      const distances = pairs.map(([one, other]) => Math.hypot(gap(one[0], other[0]), gap(one[1], other[1])));
      fc.pre(distances.every((distance) => Math.abs(distance - within) > 1e-6));
      expect(havePartsWithin(mesh, within)).toBe(distances.some((distance) => distance < within));
    }),
  );
});

test('what is no surface is near nothing and joins nothing', () => {
  const apart = together(grid(5, 0, 0, 0), grid(5, 0, 0, 1));
  const points = apart.position.length / 3;
  const strays = 200_000;
  const position = new Float64Array(apart.position.length + 3 + 3 * strays).fill(Number.NaN);
  position.set(apart.position);
  position.fill(0.5, 3 * points, 3 * points + 3);
  // Of a triangle with a point twice nothing is a surface: neither one of the stray point, nor one from sheet to sheet.
  const mesh = { position, triangles: Uint32Array.of(0, 0, points, 0, points - 1, 0, ...apart.triangles) };
  expect(havePartsWithin(mesh, 0.99)).toBe(false);
  expect(havePartsWithin(mesh, 1.01)).toBe(true);
});
