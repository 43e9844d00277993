import { describe, expect, test } from 'vitest';
import { MeshboundError, reduce, segment } from '../../wasm/index.ts';
import type { MappedReduction, Reduction, SurfaceMap } from '../../wasm/types.ts';
import { bumpyPlate } from './bumpy-plate.ts';

const bounds = { position: { relative: 0.01 }, '*': { relative: 0.03 } };

test('cuts the mesh into pieces, each in one triangle of either surface, and leaves all arrays the caller’s', async () => {
  const mesh = bumpyPlate(20);
  const reduction = await reduce(mesh, { bounds });
  const map = reduction.map as SurfaceMap;
  const { pieces, original, reduced, foldedPieces } = await segment(mesh, reduction);
  const corners = map.triangle.length + map.crossingRightward.length;
  expect(pieces.every((corner) => corner < corners)).toBe(true);
  expect(original.every((triangle, piece) => piece === 0 || triangle >= original[piece - 1])).toBe(true);
  expect(new Set(original).size).toBe(mesh.triangles.length / 3);
  expect(new Set(reduced).size).toBe(reduction.mesh.triangles.length / 3);
  expect(foldedPieces).toBeGreaterThanOrEqual(reduction.report.foldedCells);
  for (const array of [mesh.position, mesh.triangles, map.barycentric, map.crossingEdges, reduction.vertices]) {
    expect(array.length).toBeGreaterThan(0);
  }
});

test('says where there is nothing to cut by, or the two do not belong together', async () => {
  const propagated = await reduce(bumpyPlate(8), { bounds, errors: 'propagated' });
  await expect(segment(bumpyPlate(8), propagated)).rejects.toThrow(/no map/);
  const other = await reduce(bumpyPlate(6), { bounds });
  await expect(segment(bumpyPlate(8), other)).rejects.toMatchObject({
    code: 'bad_map',
    message: 'The map has 49 images, but the original has 81 vertices; there must be one for each.',
  });
  const emptied = { ...other, map: { ...(other.map as SurfaceMap), triangle: new Uint32Array() } };
  await expect(segment(bumpyPlate(6), emptied)).rejects.toThrow(/no map/);
});

describe('what is damaged', () => {
  const plate = bumpyPlate(8);
  const reduced = (async () => {
    const { mesh, vertices, map } = await reduce(plate, { bounds });
    return { mesh, vertices, map: map as SurfaceMap };
  })();
  const damaged = async (damage: (reduction: MappedReduction) => void): Promise<Reduction> => {
    const reduction = structuredClone(await reduced);
    damage(reduction);
    return reduction as Reduction;
  };

  const refusals: [string, { code?: string; index?: number; message: RegExp }, (reduction: MappedReduction) => void][] =
    [
      ['a triangle', { index: 1, message: /triangle 4000000000/ }, ({ map }) => map.triangle.fill(4_000_000_000, 1, 2)],
      ['a share', { index: 1, message: /barycentric/ }, ({ map }) => map.barycentric.fill(Number.NaN, 3, 6)],
      ['an edge', { index: 2, message: /of the original, which/ }, ({ map }) => map.crossingEdges.fill(3e9, 8, 10)],
      ['a reduced edge', { index: 2, message: /edge 3000000000-/ }, ({ map }) => map.crossingEdges.fill(3e9, 10, 12)],
      ['a place', { index: 2, message: /at 7 of the/ }, ({ map }) => map.crossingShares.fill(7, 4, 5)],
      ['a vertex', { index: 1, message: /vertex 4000000000/ }, ({ vertices }) => vertices.fill(4e9, 1, 2)],
      [
        'a corner',
        { code: 'bad_index', index: 1, message: /^Of the reduced mesh: Triangle 1 names vertex 3000000000/ },
        ({ mesh }) => mesh.triangles.fill(3e9, 3, 4),
      ],
      ['too few shares', { message: /barycentric has/ }, ({ map }) => shorten(map, 'barycentric')],
      ['too few edges', { message: /crossingEdges has/ }, ({ map }) => shorten(map, 'crossingEdges')],
      ['too few places', { message: /crossingShares has/ }, ({ map }) => shorten(map, 'crossingShares')],
      ['too few sides', { message: /crossingEdges has/ }, ({ map }) => shorten(map, 'crossingRightward')],
    ];
  test.each(refusals)('is refused by name: %s', async (_, { code = 'bad_map', index, message }, damage) => {
    const error = await segment(plate, await damaged(damage)).catch((reason: unknown) => reason);
    expect(error).toBeInstanceOf(MeshboundError);
    expect(error).toMatchObject({ code, index, message: expect.stringMatching(message) });
  });

  test('is refused before anything is copied where an array is of another type', async () => {
    const floats = await damaged(({ map }) => Object.assign(map, { crossingEdges: Float32Array.of(1, 2, 3, 4) }));
    await expect(segment(plate, floats)).rejects.toThrow(
      new TypeError("The map's crossingEdges must be a Uint32Array."),
    );
    const list = await damaged((reduction) => Object.assign(reduction, { vertices: [1, 2] }));
    await expect(segment(plate, list)).rejects.toThrow(new TypeError('The vertices must be a Uint32Array.'));
    const odd = await damaged(({ mesh }) => Object.assign(mesh, { triangles: mesh.triangles.slice(1) }));
    await expect(segment(plate, odd)).rejects.toMatchObject({ code: 'bad_index' });
  });

  test('is refused or does no harm, whatever number is another one', async () => {
    const intact = (await reduced).map;
    let refused = 0;
    for (let round = 0; round < 300; round++) {
      const spoilt = await damaged(({ mesh, vertices, map }) => {
        const { triangle, barycentric, crossingEdges, crossingShares, crossingRightward } = map;
        const arrays = [
          triangle,
          barycentric,
          crossingEdges,
          crossingShares,
          crossingRightward,
          vertices,
          mesh.triangles,
        ];
        const array = arrays[round % arrays.length];
        const other = [0, 1, 2 ** 32 - 1, 2 ** 31, round][round % 5];
        array[(round * 7919) % array.length] = other;
      });
      const outcome = await segment(plate, spoilt).catch((reason: unknown) => reason);
      if (outcome instanceof MeshboundError) {
        expect(['bad_map', 'bad_index', 'no_triangles']).toContain(outcome.code);
        refused++;
      } else {
        const { pieces } = outcome as Awaited<ReturnType<typeof segment>>;
        const corners = intact.triangle.length + intact.crossingRightward.length;
        expect(pieces.every((corner) => corner < corners)).toBe(true);
      }
    }
    expect(refused).toBeGreaterThan(100);
    expect((await segment(plate, await damaged(() => {}))).original.length).toBeGreaterThan(0);
  });
});

function shorten(map: SurfaceMap, array: keyof SurfaceMap): void {
  Object.assign(map, { [array]: map[array].slice(1) });
}

test('can be aborted', async () => {
  const mesh = bumpyPlate(60);
  const reduction = await reduce(mesh, { bounds });
  const aborting = new AbortController();
  const running = segment(mesh, reduction, { signal: aborting.signal });
  aborting.abort();
  await expect(running).rejects.toThrow(expect.objectContaining({ name: 'AbortError' }));
  expect((await segment(mesh, reduction)).original.length).toBeGreaterThan(0);
});
