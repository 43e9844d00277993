import { describe, expect, it } from 'vitest';
import type { Mesh } from '../../wasm/types.ts';
import { readSurface } from '../../web/formats/read.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { fingerprint } from './sample-mesh.ts';

interface Sheet {
  position: number[];
  triangles: number[];
}

const fan: Sheet = {
  position: [0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0],
  triangles: [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1],
};

function square(x: number, y: number): Sheet {
  return { position: [x, y, 0, x + 1, y, 0, x + 1, y + 1, 0, x, y + 1, 0], triangles: [0, 1, 2, 0, 2, 3] };
}

function twoSheets(one: Sheet, other: Sheet): Mesh {
  const moved = other.triangles.map((corner) => corner + one.position.length / 3);
  return {
    position: Float32Array.of(...one.position, ...other.position),
    triangles: Uint32Array.of(...one.triangles, ...moved),
    variables: [],
  };
}

/** Two squares side by side; the second one begins at x = `start`, with `value` at its points. */
function twoSquares(start: number, value = 0): Mesh {
  const values = Float32Array.of(0, 0, 0, 0, value, value, value, value);
  return { ...twoSheets(square(0, 0), square(start, 0)), variables: [{ name: 'p', components: 1, values }] };
}

const readAs = async (format: 'ply' | 'vtp' | 'vtk', mesh: Mesh) =>
  readSurface(`mesh.${format}`, await writeSurface(format, mesh));

describe.each(['ply', 'vtp', 'vtk'] as const)('points in one place that are not one in a file, %s', (format) => {
  it.each([
    ['differ', 1],
    ['agree', 0],
  ])('are a seam where rims run together, kept and free, whether their values %s', async (_, value) => {
    const mesh = twoSquares(1, value);
    const { mesh: back, locked, summary } = await readAs(format, mesh);
    expect(fingerprint(back)).toEqual(fingerprint(mesh));
    expect(locked).toBeUndefined();
    expect(summary).toBe('4 points on seams, where several lie in one place, will be reduced together.');
  });

  it('are no seam where the rims do not meet', async () => {
    const apart = await readAs(format, twoSquares(1.5));
    expect([apart.summary, apart.locked]).toEqual(['', undefined]);
  });

  it('are no seam inside of two sheets', async () => {
    // A fan of four triangles round point 0, twice, in the same place.
    const { locked, summary } = await readAs(format, twoSheets(fan, fan));
    expect(locked).toBeUndefined();
    expect(summary).toMatch(/^8 points on seams/);
  });

  it('are locked where rims touch in a corner', async () => {
    const { locked, summary } = await readAs(format, twoSheets(square(0, 0), square(1, 1)));
    expect(Array.from(locked ?? [])).toEqual([2, 4]);
    expect(summary).toBe('2 points where sheets touch, but have no edge in common, will stay as they are.');
  });

  it('are locked where one rim has points between those of the other', async () => {
    const finer = { position: [1, 0, 0, 2, 0, 0, 1, 0.5, 0, 1, 1, 0], triangles: [0, 1, 2, 2, 1, 3] };
    const { locked } = await readAs(format, twoSheets(square(0, 0), finer));
    expect(Array.from(locked ?? [])).toEqual([1, 2, 4, 7]);
  });

  it('are locked where a rim touches the inside of another sheet', async () => {
    const upright = { position: [0, 0, 0, 0, 0, 1, 0, 1, 1], triangles: [0, 1, 2] };
    expect(Array.from((await readAs(format, twoSheets(fan, upright))).locked ?? [])).toEqual([0, 5]);
  });

  it('are a seam where edges of three triangles run along the rim of another sheet', async () => {
    const book = { position: [0, 0, 0, 0, 1, 0, 1, 0, 0, -1, 0, 0, 0, 0, 1], triangles: [0, 1, 2, 1, 0, 3, 0, 1, 4] };
    const page = { position: [0, 0, 0, 0, 1, 0, 0, 0, -1], triangles: [0, 1, 2] };
    const { locked, summary } = await readAs(format, twoSheets(book, page));
    expect(locked).toBeUndefined();
    expect(summary).toMatch(/^4 points on seams/);
  });

  it('are nothing where no triangle uses them', async () => {
    const { position, triangles } = square(0, 0);
    const { locked, summary } = await readAs(format, twoSheets({ position, triangles }, { position, triangles: [] }));
    expect(locked).toBeUndefined();
    expect(summary).not.toMatch(/seam|touch/);
  });
});
