import { expect, test } from 'vitest';
import { inspect } from '../../wasm/index.ts';
import type { Mesh } from '../../wasm/types.ts';

const square: Mesh = {
  position: Float32Array.of(0, 0, 0, 3, 0, 0, 3, 4, 0, 0, 4, 0, 9, 9, 9),
  triangles: Uint32Array.of(0, 1, 2, 0, 2, 3),
  variables: [
    { name: 'density', components: 1, values: new Float64Array(5).fill(2) },
    { name: 'velocity', components: 2, values: Float32Array.of(0, 0, 3, 0, 3, -4, 0, 0, 0, 0) },
  ],
};

test('tells what the variables span, without reducing', async () => {
  const inspection = await inspect(square);
  expect(inspection.triangles).toBe(2);
  expect(inspection.vertices).toBe(5);
  expect(inspection.defects).toEqual({
    repeatedVertexTriangles: 0,
    zeroAreaTriangles: 0,
    unusedVertices: 1,
    flippedTriangles: 0,
    unorientableComponents: 0,
    copiedTriangles: 0,
    twoSidedTriangles: 0,
  });
  expect(inspection.variables.slice(1)).toEqual([
    { name: 'density', components: 1, extent: 0, magnitude: 2, constant: true },
    { name: 'velocity', components: 2, extent: 5, magnitude: 4, constant: false },
  ]);
});

test('refuses a mesh that could not be reduced', async () => {
  await expect(inspect({ ...square, triangles: Uint32Array.of(0, 1, 5) })).rejects.toMatchObject({
    name: 'MeshboundError',
    code: 'bad_index',
    index: 0,
  });
});

test('rejects with an AbortError where the signal was aborted before', async () => {
  await expect(inspect(square, { signal: AbortSignal.abort() })).rejects.toMatchObject({ name: 'AbortError' });
});
