import { describe, expect, it } from 'vitest';
import type { Mesh } from '../../wasm/types.ts';
import { readSurface } from '../../web/formats/read.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { fingerprint } from './sample-mesh.ts';

/** Two squares side by side, of two triangles each; the second one begins at x = `start`. */
function twoSquares(start: number, value = 0): Mesh {
  const square = (x: number) => [x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0];
  return {
    position: Float32Array.of(...square(0), ...square(start)),
    triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7),
    variables: [{ name: 'p', components: 1, values: Float32Array.of(0, 0, 0, 0, value, value, value, value) }],
  };
}

const readAs = async (format: 'ply' | 'vtp' | 'vtk', mesh: Mesh) =>
  readSurface(`mesh.${format}`, await writeSurface(format, mesh));

describe.each(['ply', 'vtp', 'vtk'] as const)('points in one place that are not one in a file, %s', (format) => {
  it.each([
    ['differ', 1],
    ['agree', 0],
  ])('are kept and locked on the rim, whether their values %s', async (_, value) => {
    const mesh = twoSquares(1, value);
    const { mesh: back, locked, summary } = await readAs(format, mesh);
    expect(fingerprint(back)).toEqual(fingerprint(mesh));
    expect(Array.from(locked ?? [])).toEqual([1, 2, 4, 7]);
    expect(summary).toBe('4 points on seams, where several lie in one place, will stay as they are.');
  });

  it('are no seam where the rims do not meet', async () => {
    const apart = await readAs(format, twoSquares(1.5));
    expect([apart.summary, apart.locked]).toEqual(['', undefined]);
  });

  it('are no seam inside of two sheets', async () => {
    // A fan of four triangles round point 0, twice, in the same place.
    const [position, fan] = [
      [0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0],
      [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1],
    ];
    const sheets: Mesh = {
      position: Float32Array.of(...position, ...position),
      triangles: Uint32Array.of(...fan, ...fan.map((corner) => corner + 5)),
      variables: [],
    };
    expect(Array.from((await readAs(format, sheets)).locked ?? [])).toEqual([1, 2, 3, 4, 6, 7, 8, 9]);
  });
});
