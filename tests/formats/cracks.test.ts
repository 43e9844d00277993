import { describe, expect, it } from 'vitest';
import type { Mesh, Variable } from '../../wasm/types.ts';
import { addVariables, readSurface } from '../../web/formats/read.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { topologyOf } from '../../web/surface/topology.ts';
import { bytesOf } from './sample-mesh.ts';

const columns = 13;
const rows = 9;

/** Noise that is the same in every run, from −1 to 1. */
function noise(seed: number): number {
  const mixed = Math.imul(seed + 1, 0x9e3779b1) ^ 0x5bd1e995;
  return (((Math.imul(mixed ^ (mixed >>> 15), 0x85ebca77) >>> 8) % 2001) - 1000) / 1000;
}

/** A wavy sheet of `columns` × `rows` points from `from` on, each moved by up to `rounding`. */
function sheet(from: number, rounding: number, scale = 1): { position: number[]; triangles: number[]; p: number[] } {
  const [position, triangles, p]: number[][] = [[], [], []];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const [x, y] = [column / (columns - 1), from + row / (rows - 1)];
      const shift = (axis: number) => rounding * noise(axis + 3 * (row * columns + column) + 1000 * from);
      position.push(scale * (x + shift(0)), scale * (y + shift(1)), scale * (0.1 * Math.sin(7 * x + 3 * y) + shift(2)));
      p.push(x + 2 * y);
      if (row === rows - 1 || column === columns - 1) continue;
      const at = row * columns + column;
      triangles.push(at, at + 1, at + columns + 1, at, at + columns + 1, at + columns);
    }
  }
  return { position, triangles, p };
}

/** Two sheets that end along the same line, where rounding moved their points. */
function cracked(rounding: number, jump = 0, scale = 1): Mesh {
  const [one, other] = [sheet(0, 0, scale), sheet(1, rounding, scale)];
  const points = one.position.length / 3;
  const values = Float64Array.from([...one.p, ...other.p.map((value, i) => value + jump + 1e-8 * noise(i))]);
  const p: Variable = { name: 'p', components: 1, values };
  return {
    position: Float64Array.from([...one.position, ...other.position]),
    triangles: Uint32Array.from([...one.triangles, ...other.triangles.map((corner) => corner + points)]),
    variables: [p],
  };
}

const reread = async (mesh: Mesh, weld?: number, format: 'ply' | 'vtp' | 'vtk' = 'ply') =>
  readSurface('', await writeSurface(format, mesh), undefined, weld === undefined ? {} : { weld });
const componentsOf = ({ triangles, position }: Mesh) => topologyOf(triangles, position.length / 3).components;

describe('a crack of rounding', () => {
  it.each(['ply', 'vtp', 'vtk'] as const)('is said to be there, with its width, in %s', async (format) => {
    for (const [rounding, scale] of [
      [1e-7, 1],
      [3e-7, 1000],
      [1e-9, 1e-6],
    ]) {
      const { notes, mesh } = await reread(cracked(rounding, 0, scale), undefined, format);
      expect(componentsOf(mesh)).toBe(2);
      const note = notes.find((each) => each.startsWith('A crack:')) ?? '';
      expect(note).toContain(`${2 * columns} points`);
      const width = Number(/it is (\S+) wide/.exec(note)?.[1]);
      expect(width / (rounding * scale)).toBeGreaterThan(0.8);
      expect(width / (rounding * scale)).toBeLessThan(Math.sqrt(3) * 1.01);
    }
  });

  it('is none where sheets are farther apart, in one place, joined or closed', async () => {
    const apart = await reread(cracked(1e-3));
    const seam = await reread(cracked(0));
    const single = sheet(0, 0);
    const closed = { position: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1), variables: [] };
    const tetrahedron = await reread({ ...closed, triangles: Uint32Array.of(0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3) });
    const whole = await reread({
      position: Float64Array.from(single.position),
      triangles: Uint32Array.from(single.triangles),
      variables: [],
    });
    for (const { notes } of [apart, seam, tetrahedron, whole]) expect(notes.join(' ')).not.toContain('crack');
    expect(seam.summary).toContain('on seams');
  });

  it('is none between the ends of a short edge, or where a far point makes all others near', async () => {
    const { position, triangles } = sheet(0, 0);
    const short = Float64Array.from(position);
    short.set([short[3] - 1e-9, short[4], short[5]], 0);
    const mesh = { position: short, triangles: Uint32Array.from(triangles), variables: [] };
    expect((await reread(mesh)).summary).not.toContain('crack');
    const far = Float64Array.from([...position, 1e12, 0, 0]);
    const stretched = { ...mesh, position: far, triangles: Uint32Array.from([...triangles, 0, 1, rows * columns]) };
    expect((await reread(stretched)).summary).not.toContain('crack');
    const unused = { ...mesh, position: Float64Array.from([...position, 1e12, 0, 0]) };
    expect((await reread(unused)).summary).not.toContain('crack');
  });

  it('inside one part is found, too', async () => {
    const whole = cracked(1e-7);
    // A bridge at the far ends makes them one part.
    const last = whole.position.length / 3;
    const bridge = Uint32Array.of(0, last - 1, 5);
    const { notes } = await reread({ ...whole, triangles: Uint32Array.of(...whole.triangles, ...bridge) });
    expect(notes.join(' ')).toContain('A crack:');
  });
});

describe('a weld', () => {
  it('makes points one that agree in everything, and the surface whole', async () => {
    const mesh = { ...cracked(1e-7), regions: Int32Array.from({ length: 384 }, (_, i) => i % 7) };
    const { mesh: welded, notes } = await reread(mesh, 1e-6, 'vtp');
    expect(componentsOf(welded)).toBe(1);
    expect(topologyOf(welded.triangles, welded.position.length / 3)).toMatchObject({
      boundaryLoops: 1,
      nonManifoldEdges: 0,
      nonManifoldVertices: 0,
    });
    expect(welded.position).toHaveLength(mesh.position.length - 3 * columns);
    expect(welded.position.subarray(0, 3 * rows * columns)).toEqual(mesh.position.subarray(0, 3 * rows * columns));
    expect(notes.join(' ')).toContain(`${columns} points where sheets end put where others lie`);
    expect(notes.join(' ')).not.toContain('crack');
  });

  it('leaves points whose values differ on a seam, in one place', async () => {
    const { mesh, seamPoints, notes } = await reread(cracked(1e-7, 0.5), 1e-6);
    expect(mesh.position).toHaveLength(cracked(0).position.length);
    expect(seamPoints).toBe(2 * columns);
    expect(notes.join(' ')).toContain('0 of them became one');
    const place = (point: number) => [...mesh.position.subarray(3 * point, 3 * point + 3)];
    for (let column = 0; column < columns; column++) {
      expect(place(rows * columns + column)).toEqual(place((rows - 1) * columns + column));
    }
  });

  it('changes nothing where there is nothing near', async () => {
    const mesh = cracked(1e-3);
    const { mesh: same, notes } = await reread(mesh, 1e-6);
    expect(same).toEqual(mesh);
    expect(notes).toEqual([]);
  });

  it('takes a table of variables for the points of the file', async () => {
    const mesh = cracked(1e-7);
    const file = await reread(mesh, 1e-6);
    const table = ['q', ...Array.from({ length: mesh.position.length / 3 }, (_, i) => String(mesh.position[3 * i]))];
    const { mesh: both } = await addVariables(file, bytesOf(`${table.join('\n')}\n`));
    expect(both.position).toEqual(file.mesh.position);
    expect(both.variables.map(({ name }) => name)).toEqual(['p', 'q']);
    expect(Array.from(both.variables[1].values.subarray(0, 5))).toEqual([0, 3, 6, 9, 12].map((i) => mesh.position[i]));
  });

  it('that reaches over triangles is refused', async () => {
    // Loose triangles: all their points are ends.
    const loose = [0, 2, 4, 6].flatMap((from) => {
      const { position, triangles } = sheet(from, 0);
      return triangles.flatMap((corner) => position.slice(3 * corner, 3 * corner + 3));
    });
    const far = [...loose, 1e9, 0, 0, 1e9, 1, 0, 1e9, 0, 1];
    const mesh = { position: Float64Array.from(far), triangles: new Uint32Array(far.length / 3), variables: [] };
    const corners = mesh.triangles.map((_, i) => i);
    await expect(reread({ ...mesh, triangles: corners }, 1e-3)).rejects.toMatchObject({ code: 'bad_number' });
  });
});
