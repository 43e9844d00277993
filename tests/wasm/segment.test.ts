import { expect, test } from 'vitest';
import { reduce, segment } from '../../wasm/index.ts';
import type { SurfaceMap } from '../../wasm/types.ts';
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
  await expect(segment(bumpyPlate(8), other)).rejects.toThrow(/not one of this mesh/);
});

test('can be aborted', async () => {
  const mesh = bumpyPlate(60);
  const reduction = await reduce(mesh, { bounds });
  const aborting = new AbortController();
  const running = segment(mesh, reduction, { signal: aborting.signal });
  aborting.abort();
  await expect(running).rejects.toThrow(expect.objectContaining({ name: 'AbortError' }));
  expect((await segment(mesh, reduction)).original.length).toBeGreaterThan(0);
});
