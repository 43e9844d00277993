import { describe, expect, test } from 'vitest';
import { reduce } from '../../wasm/index.ts';
import type { Mesh, Reduction } from '../../wasm/types.ts';
import { bumpyPlate } from './bumpy-plate.ts';

const bounds = { position: { relative: 0.01 }, '*': { relative: 0.03 } };

/** The values that the reduced mesh should hold: those of the input at the vertices that were kept. */
function gathered(values: ArrayLike<number>, components: number, vertices: Uint32Array): number[] {
  return Array.from(vertices).flatMap((vertex) =>
    Array.from({ length: components }, (_, component) => values[vertex * components + component] as number),
  );
}

function expectSubsetBitForBit(mesh: Mesh, { mesh: reduced, vertices }: Reduction): void {
  expect(Array.from(reduced.position)).toEqual(gathered(mesh.position, 3, vertices));
  mesh.variables.forEach(({ components, values }, i) => {
    expect(Array.from(reduced.variables[i]?.values ?? [])).toEqual(gathered(values, components, vertices));
  });
}

describe('reduce', () => {
  test('removes triangles within the bounds and says so', async () => {
    const mesh = bumpyPlate(30);
    const { mesh: reduced, report } = await reduce(mesh, { bounds });
    expect(reduced.triangles.length / 3).toBe(report.triangles.after);
    expect(reduced.position.length / 3).toBe(report.vertices.after);
    expect(report.triangles).toEqual({ before: 1800, after: expect.any(Number) });
    expect(report.triangles.after).toBeLessThan(900);
    expect(report.termination).toBe('finished');
    expect(report.seconds).toBeGreaterThan(0);
    expect(report.variables.map(({ name }) => name)).toEqual(['position', 'height', 'flow']);
    for (const { error, bound, ratio } of report.variables) {
      expect(error).toBeLessThanOrEqual(bound);
      expect(ratio).toBeLessThanOrEqual(1);
    }
  });

  test('takes the arrays over where it may, with the same result', async () => {
    const given = bumpyPlate(20);
    const copied = await reduce(given, { bounds });
    expect(given.position.length).toBe(3 * 21 * 21);
    const taken = await reduce(given, { bounds, transfer: true });
    expect(given.position.length).toBe(0);
    expect(given.triangles.length).toBe(0);
    expect(taken.mesh).toEqual(copied.mesh);
  });

  test('gives the error of every variable on every reduced triangle', async () => {
    const { mesh, triangleErrors, report } = await reduce(bumpyPlate(20), { bounds });
    const count = mesh.triangles.length / 3;
    expect(triangleErrors.map(({ largest }) => largest.length)).toEqual([count, count, count]);
    // Signed errors exist for numbers; of the variables only position, by its normal, is a vector that has them.
    expect(triangleErrors.map(({ lowest }) => lowest.length)).toEqual([count, count, 0]);
    triangleErrors.forEach(({ largest }, i) => {
      expect(Math.max(...largest)).toBeCloseTo(report.variables[i]?.error as number, 6);
    });
  });

  test('keeps a subset of the vertices, their values bit for bit, in the precision they came in', async () => {
    const mesh = bumpyPlate(20);
    const reduction = await reduce(mesh, { bounds });
    expectSubsetBitForBit(mesh, reduction);
    expect(reduction.mesh.position).toBeInstanceOf(Float32Array);
    expect(reduction.mesh.variables.map(({ values }) => values.constructor)).toEqual([Float64Array, Float32Array]);
  });

  test('takes positions in double precision as well', async () => {
    const mesh = bumpyPlate(10);
    mesh.position = Float64Array.from(mesh.position, (x) => x + 1 / 3);
    const reduction = await reduce(mesh, { bounds });
    expect(reduction.mesh.position).toBeInstanceOf(Float64Array);
    expectSubsetBitForBit(mesh, reduction);
  });

  test('leaves the arrays of the caller as they were', async () => {
    const mesh = bumpyPlate(10);
    const copy = structuredClone(mesh);
    await reduce(mesh, { bounds });
    expect(mesh).toEqual(copy);
  });

  test('takes views that begin inside a larger buffer', async () => {
    const mesh = bumpyPlate(10);
    const padded = new Float32Array(mesh.position.length + 10);
    padded.set(mesh.position, 5);
    const view = { ...mesh, position: padded.subarray(5, 5 + mesh.position.length) };
    expect((await reduce(view, { bounds })).mesh).toEqual((await reduce(mesh, { bounds })).mesh);
  });

  test('takes the mesh as it is at the call, whatever the caller does to it later', async () => {
    const mesh = bumpyPlate(10);
    const expected = await reduce(mesh, { bounds });
    const first = reduce(bumpyPlate(20), { bounds });
    const second = reduce(mesh, { bounds });
    mesh.position.fill(0);
    await first;
    expect((await second).mesh).toEqual(expected.mesh);
  });

  test('gives the same bytes again', async () => {
    const [one, other] = await Promise.all([reduce(bumpyPlate(20), { bounds }), reduce(bumpyPlate(20), { bounds })]);
    expect(one.mesh).toEqual(other.mesh);
    expect(one.triangleErrors).toEqual(other.triangleErrors);
  });

  test('a variable without a bound holds nothing back and has an infinite bound', async () => {
    const { report } = await reduce(bumpyPlate(10), { bounds: { position: { relative: 0.01 }, height: 'free' } });
    expect(report.variables.map(({ bound }) => Number.isFinite(bound))).toEqual([true, false, false]);
    expect(report.variables[1]?.ratio).toBe(0);
  });

  test('takes absolute bounds in the unit of the variable', async () => {
    const { report } = await reduce(bumpyPlate(10), { bounds: { position: { absolute: 0.02 }, '*': 'free' } });
    expect(report.variables[0]?.bound).toBe(0.02);
  });

  test('keeps locked vertices', async () => {
    const locked = Uint32Array.of(60, 61, 62);
    const { vertices, report } = await reduce(bumpyPlate(10), { bounds, locked });
    expect(Array.from(vertices)).toEqual(expect.arrayContaining([60, 61, 62]));
    expect(report.refused.locked).toBe(3);
  });

  test('keeps what meets a locked box, and finer bounds where the multiplier is small', async () => {
    const plate = bumpyPlate(16);
    const near = Float64Array.from({ length: 17 * 17 }, (_, vertex) => (vertex % 17 < 8 ? 0.05 : 1));
    const mesh = { ...plate, variables: [...plate.variables, { name: 'near', components: 1, values: near }] };
    const withMultiplier = { ...bounds, near: 'free' } as const;
    const plain = await reduce(mesh, { bounds: withMultiplier });
    const focused = await reduce(mesh, { bounds: withMultiplier, boundMultiplier: 'near' });
    expect(focused.report.triangles.after).toBeGreaterThan(plain.report.triangles.after);
    expect(Math.max(...focused.report.variables.map(({ ratio }) => ratio))).toBeLessThanOrEqual(1);

    const lockedBoxes = [
      { lowest: [0, 0, -1] as [number, number, number], highest: [0.2, 0.2, 1] as [number, number, number] },
    ];
    const { vertices, report } = await reduce(mesh, { bounds: withMultiplier, lockedBoxes });
    expect(report.unusedLockedBoxes).toEqual([]);
    const away = { lowest: [0, 0, 7] as [number, number, number], highest: [1, 1, 8] as [number, number, number] };
    const beside = await reduce(mesh, { bounds: withMultiplier, lockedBoxes: [...lockedBoxes, away] });
    expect(beside.report.unusedLockedBoxes).toEqual([1]);
    const inBox = [0, 1, 2, 3].flatMap((row) => [0, 1, 2, 3].map((column) => 17 * row + column));
    expect(Array.from(vertices)).toEqual(expect.arrayContaining(inBox));
  });

  test('options that are left out take the defaults of the core', async () => {
    const mesh = bumpyPlate(20);
    const byDefault = (await reduce(mesh, { bounds })).mesh.triangles;
    const explicit = await Promise.all(
      (['maximum', 'introduced'] as const).map(async (cost) => (await reduce(mesh, { bounds, cost })).mesh.triangles),
    );
    expect(explicit).toContainEqual(byDefault);
  });

  test('counts what is odd about the mesh', async () => {
    const mesh = bumpyPlate(4);
    mesh.triangles = Uint32Array.of(...mesh.triangles, 7, 7, 8);
    const { report } = await reduce(mesh, { bounds });
    expect(report.defects).toEqual({
      repeatedVertexTriangles: 1,
      zeroAreaTriangles: 0,
      unusedVertices: 0,
      flippedTriangles: 0,
      unorientableComponents: 0,
      copiedTriangles: 0,
      twoSidedTriangles: 0,
    });
  });
});
