import { beforeAll, describe, expect, test } from 'vitest';
import { reduce } from '../../wasm/index.ts';
import type { Reduction, SurfaceMap, VertexErrors } from '../../wasm/types.ts';
import { bumpyPlate } from './bumpy-plate.ts';
import { crossingDifferences, dot, length, normalOf, placesOf, variablesOf, vertexDifferences } from './map-errors.ts';

const bounds = { position: { relative: 0.01 }, '*': { relative: 0.03 } };
/** Vertex errors are given in single precision, and both sides round on the way, relative to values of about 1. */
const rounding = 1e-7;

const mesh = bumpyPlate(30);
const variables = variablesOf(mesh);
const indices = variables.map((_, index) => index);

describe('the map from the original onto the reduced surface', () => {
  let reduction: Reduction;
  let map: SurfaceMap;
  let vertexErrors: VertexErrors[];

  beforeAll(async () => {
    reduction = await reduce(mesh, { bounds });
    map = reduction.map as SurfaceMap;
    vertexErrors = reduction.vertexErrors as VertexErrors[];
  });

  test('has a place in a reduced triangle for every vertex of the original', () => {
    const places = placesOf(map);
    expect(places).toHaveLength(mesh.position.length / 3);
    for (const { triangle, barycentric } of places) {
      expect(triangle).toBeLessThan(reduction.report.triangles.after);
      expect(Math.min(...barycentric)).toBeGreaterThanOrEqual(0);
      expect(Math.max(...barycentric)).toBeLessThanOrEqual(1);
      expect(barycentric.reduce((sum, next) => sum + next, 0)).toBeCloseTo(1, 14);
    }
  });

  test('leaves every vertex that was kept where it is', () => {
    const places = placesOf(map);
    reduction.vertices.forEach((vertex, kept) => {
      const { triangle, barycentric } = places[vertex];
      expect(reduction.mesh.triangles[3 * triangle + barycentric.indexOf(1)]).toBe(kept);
    });
  });

  test.each(indices)('gives the errors of variable %d at the vertices that follow from it', (index) => {
    const { error } = vertexErrors[index];
    const differences = vertexDifferences(mesh, reduction, index);
    expect(error).toHaveLength(differences.length);
    expect(Math.max(...error)).toBeGreaterThan(0);
    differences.forEach((difference, vertex) => {
      expect(Math.abs(error[vertex] - length(difference))).toBeLessThan(rounding);
    });
  });

  test('gives signed errors of scalars as original minus reduced, of vectors none', () => {
    const [, height, flow] = vertexErrors;
    vertexDifferences(mesh, reduction, 1).forEach(([difference], vertex) => {
      expect(Math.abs(height.signedError[vertex] - difference)).toBeLessThan(rounding);
    });
    expect(flow.signedError).toHaveLength(0);
  });

  test('gives the signed error of position as the distance along the normal, positive where the reduced surface is outside', () => {
    const { signedError } = vertexErrors[0];
    const places = placesOf(map);
    vertexDifferences(mesh, reduction, 0).forEach((difference, vertex) => {
      const normal = normalOf(reduction.mesh, places[vertex].triangle);
      expect(Math.abs(signedError[vertex] + dot(difference, normal))).toBeLessThan(rounding);
    });
  });

  test.each(indices)('has no larger error of variable %d at any vertex or crossing than the report says', (index) => {
    const { error, bound } = reduction.report.variables[index];
    const vertices = vertexDifferences(mesh, reduction, index).map(length);
    const crossings = crossingDifferences(mesh, reduction, index).map(length);
    expect(crossings.length).toBeGreaterThan(100);
    const largest = Math.max(...vertices, ...crossings);
    expect(largest).toBeLessThanOrEqual(error * (1 + rounding));
    // What is reported is what was measured, not an estimate from above.
    expect(largest).toBeGreaterThan(error * (1 - rounding));
    expect(error).toBeLessThanOrEqual(bound);
  });

  test.each(indices)('has no larger error of variable %d at a vertex than its triangle', (index) => {
    const { error } = vertexErrors[index];
    const { largest } = reduction.triangleErrors[index];
    map.triangle.forEach((triangle, vertex) => {
      expect(error[vertex]).toBeLessThanOrEqual(largest[triangle] + rounding);
    });
  });

  test('has crossings inside edges of both meshes, in their order along each edge of the original', () => {
    const { crossingEdges, crossingShares } = map;
    expect(crossingEdges).toHaveLength(2 * crossingShares.length);
    let before = { edge: '', s: 0 };
    for (let crossing = 0; 2 * crossing < crossingShares.length; crossing++) {
      const [a, b, c, d] = Array.from(crossingEdges.subarray(4 * crossing, 4 * crossing + 4)) as [
        number,
        number,
        number,
        number,
      ];
      const [s, t] = Array.from(crossingShares.subarray(2 * crossing, 2 * crossing + 2));
      expect(a).toBeLessThan(b);
      expect(b).toBeLessThan(mesh.position.length / 3);
      expect(Math.max(c, d)).toBeLessThan(reduction.report.vertices.after);
      for (const share of [s, t]) {
        expect(share).toBeGreaterThanOrEqual(0);
        expect(share).toBeLessThanOrEqual(1);
      }
      const edge = `${a} ${b}`;
      if (edge === before.edge) expect(s).toBeGreaterThanOrEqual(before.s);
      before = { edge, s };
    }
  });
});

test('a vertex that no triangle uses is nowhere', async () => {
  const plate = bumpyPlate(6);
  const stray = { ...plate, position: Float32Array.of(...plate.position, 0.5, 0.5, 0), variables: [] };
  const { map } = await reduce(stray, { bounds: { '*': { relative: 0.03 } } });
  expect(map?.triangle.at(-1)).toBe(0xffffffff);
});

test('a map of more places than are handed over at once is whole', async () => {
  const plate = bumpyPlate(60);
  const { map } = await reduce(plate, { bounds });
  expect(map?.barycentric).toHaveLength(plate.position.length);
  const empty = placesOf(map as SurfaceMap).filter(({ barycentric }) => Math.max(...barycentric) === 0);
  expect(empty).toEqual([]);
});

test('propagated errors keep no map and know nothing of single vertices', async () => {
  const reduction = await reduce(bumpyPlate(10), { bounds, errors: 'propagated' });
  expect(reduction).not.toHaveProperty('map');
  expect(reduction).not.toHaveProperty('vertexErrors');
});

describe('the freedom of the map', () => {
  const settled = [true, false].flatMap((optimizeVertexImages) =>
    [true, false].map((optimizeEdgeCrossings) => ({ optimizeVertexImages, optimizeEdgeCrossings })),
  );

  test('is used by default, and each way of using it changes the result', async () => {
    const byDefault = (await reduce(mesh, { bounds })).mesh;
    const meshes = await Promise.all(settled.map(async (options) => (await reduce(mesh, { bounds, ...options })).mesh));
    expect(meshes[0]).toEqual(byDefault);
    const texts = meshes.map(({ triangles }) => triangles.join());
    expect(new Set(texts).size).toBe(4);
  });

  test('is refused where it is neither true nor false', async () => {
    const optimizeVertexImages = 'no' as unknown as boolean;
    await expect(reduce(mesh, { bounds, optimizeVertexImages })).rejects.toMatchObject({
      code: 'bad_option',
      message: 'The option optimizeVertexImages cannot be “no”.',
    });
  });
});
