import { describe, expect, it } from 'vitest';
import type { Mesh, Variable } from '../../wasm/types.ts';
import { addVariables, readSurface, withVariables } from '../../web/formats/read.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { topologyOf } from '../../web/surface/topology.ts';
import { fingerprint } from './sample-mesh.ts';

const cells = 8;
const points = (cells + 1) ** 2;

/** A bent square of cells, whose points are those of each cell's corners in turn. */
function looseSquares(): Mesh {
  const corners = [0, 1, 2, 0, 2, 3];
  const position: number[] = [];
  const triangles: number[] = [];
  for (let cell = 0; cell < cells ** 2; cell++) {
    const [x, y] = [cell % cells, Math.floor(cell / cells)];
    triangles.push(...corners.map((corner) => 4 * cell + corner));
    for (const [i, j] of [
      [x, y],
      [x + 1, y],
      [x + 1, y + 1],
      [x, y + 1],
    ])
      position.push(i, j, (i * j) / 50);
  }
  return { position: Float32Array.from(position), triangles: Uint32Array.from(triangles), variables: [] };
}

/** Every corner a point. */
function looseTriangles(): Mesh {
  const { position, triangles } = looseSquares();
  const at = [...triangles].flatMap((corner) => [...position.subarray(3 * corner, 3 * corner + 3)]);
  return { position: Float32Array.from(at), triangles: Uint32Array.from(triangles.keys()), variables: [] };
}

/** By the point's number and its triangle's. */
function scalar({ position }: Mesh, name: string, value: (point: number, x: number) => number): Variable {
  const values = Float32Array.from({ length: position.length / 3 }, (_, point) => value(point, position[3 * point]));
  return { name, components: 1, values };
}

describe.each([
  ['triangles', looseTriangles()],
  ['squares', looseSquares()],
])('%s with points of their own', (_, loose) => {
  const count = loose.position.length / 3;
  const read = async (variables: Variable[], format: 'ply' | 'vtp' | 'vtk' = 'ply') =>
    readSurface(
      '',
      await writeSurface(format, { ...loose, variables, regions: new Int32Array(loose.triangles.length / 3) }),
    );
  const facing = (point: number) => Math.floor(point / (count / cells ** 2)) % 7;

  it.each(['ply', 'vtp', 'vtk'] as const)(
    'are joined where everything agrees, and this is said, %s',
    async (format) => {
      const { mesh, notes, locked, regions } = await read([scalar(loose, 'p', (_point, x) => Math.sin(x))], format);
      expect(mesh.position).toHaveLength(3 * points);
      expect(topologyOf(mesh.triangles, points)).toMatchObject({
        components: 1,
        boundaryLoops: 1,
        nonManifoldVertices: 0,
      });
      expect(locked).toBeUndefined();
      expect(regions?.get('regions')).toHaveLength(mesh.triangles.length / 3);
      expect(notes).toContain(
        `${count - points} repeated points welded: the file has points of its own for every face.`,
      );
      expect(notes.join()).not.toMatch(/seams|Hardly/);
    },
  );

  it('keep a jump between two parts as a seam, with both values', async () => {
    const right = loose.triangles.length / 2; // not by x, which is the same on both sides of the seam
    const side = new Float32Array(count);
    loose.triangles.forEach((corner, i) => {
      side[corner] = i < right ? 0 : 5;
    });
    const { mesh, notes } = await read([{ name: 'side', components: 1, values: side }]);
    expect(mesh.position).toHaveLength(3 * (points + cells + 1));
    expect(notes).toContain(
      `${2 * (cells + 1)} points on seams, where several lie in one place, will be reduced together.`,
    );
    const [{ values }] = mesh.variables;
    expect(new Set(values)).toEqual(new Set([0, 5]));
    mesh.triangles.forEach((corner, i) => {
      expect(values[corner]).toBe(i < right ? 0 : 5);
    });
  });

  it('stay apart where values differ from face to face, and the variable is named', async () => {
    const file = await read([scalar(loose, 'flat', facing), scalar(loose, 'p', (_point, x) => x)]);
    expect(file.notes).toContain(
      'Hardly anything can be removed, since the values at one place differ from face to face: “flat”.',
    );
    const without = withVariables(file, (variables) => variables.filter(({ name }) => name !== 'flat'));
    expect(without.mesh.position).toHaveLength(3 * points);
    expect(without.summary).not.toContain('Hardly');
  });

  it('have as many lines in a CSV file as they have points in their own', async () => {
    const smooth = [...loose.position].filter((_value, i) => i % 3 === 0);
    const table = (values: number[]) => new TextEncoder().encode(['q', ...values].join('\n'));
    const file = await read([]);
    const joined = await addVariables(file, table(smooth));
    expect(joined.mesh.position).toHaveLength(3 * points);
    expect(joined.mesh.variables).toMatchObject([{ name: 'q' }]);
    const apart = await addVariables(file, table(smooth.map((_value, point) => facing(point))));
    expect(apart.mesh.position.length).toBeGreaterThan(6 * points);
    await expect(addVariables(file, table(smooth.slice(1)))).rejects.toThrow();
  });
});

it('a surface of blocks with points of their own keeps its points', async () => {
  const plate = looseSquares();
  const welded = (await readSurface('', await writeSurface('ply', plate))).mesh;
  const moved = { ...welded, position: welded.position.map((value, i) => (i % 3 === 0 ? -value : value)) };
  const both: Mesh = {
    position: Float32Array.of(...welded.position, ...moved.position),
    triangles: Uint32Array.of(...welded.triangles, ...moved.triangles.map((corner) => corner + points)),
    variables: [],
  };
  const back = await readSurface('', await writeSurface('ply', both));
  expect(fingerprint(back.mesh)).toEqual(fingerprint(both));
  expect(back.summary).toMatch(/^18 points on seams/);
});
