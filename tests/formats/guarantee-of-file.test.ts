import { WebIO } from '@gltf-transform/core';
import { validateBytes } from 'gltf-validator';
import { describe, expect, it } from 'vitest';
import { reduce, verify } from '../../wasm/index.ts';
import type { Bound, Mesh } from '../../wasm/types.ts';
import { originIn, roundingsOf } from '../../web/formats/file-rounding.ts';
import { readSurface } from '../../web/formats/read.ts';
import type { Format } from '../../web/formats/surface.ts';
import { lossesOf, writeLevels, writeSurface } from '../../web/formats/write.ts';
import { boundsForFile, isKept, reportOfFile } from '../../web/session/bounds/bounds-for-file.ts';

const side = 21;

/** A waved square of doubles at this place, with a temperature far from zero and a velocity. */
function wavedSquare(x: number, y: number, z: number): Mesh {
  const points = side * side;
  const position = new Float64Array(3 * points);
  const temperature = new Float64Array(points);
  const velocity = new Float64Array(3 * points);
  for (let i = 0; i < points; i++) {
    const [u, v] = [(i % side) / 7, Math.floor(i / side) / 7];
    position.set([x + u, y + v, z + 0.05 * Math.sin(3 * u) * Math.cos(2 * v)], 3 * i);
    temperature[i] = 300 + Math.sin(u + v) / 3;
    velocity.set([Math.cos(u) / 3, Math.sin(v) / 3, u / 3], 3 * i);
  }
  const triangles = Uint32Array.from({ length: 6 * (side - 1) ** 2 }, (_, k) => {
    const square = Math.floor(k / 6);
    const corner = square + Math.floor(square / (side - 1));
    return corner + [0, 1, side + 1, 0, side + 1, side][k % 6];
  });
  const variables = [
    { name: 'temperature', components: 1, values: temperature },
    { name: 'velocity', components: 3, values: velocity },
  ];
  return { position, triangles, variables };
}

const limits = { position: 0.02, temperature: 0.01, velocity: 0.02 };
const bounds: Record<string, Bound> = Object.fromEntries(
  Object.entries(limits).map(([name, absolute]) => [name, { absolute }]),
);

/** The largest distance between two surfaces, in bounds, of the variables that both have. */
async function judged(original: Mesh, reduced: Mesh): Promise<number> {
  const held = original.variables.filter(({ name }) => reduced.variables.some((each) => each.name === name));
  const names = ['position', ...held.map(({ name }) => name)] as (keyof typeof limits)[];
  const options = { bounds: names.map((name) => limits[name]), samples: 20000 };
  return (await verify({ ...original, variables: held }, reduced, options)).ratio;
}

const placed = wavedSquare(6_000_000.1, 2_000_000.06, 305);
const near = wavedSquare(0.1, 0.06, 3);

describe('what is guaranteed is guaranteed of the file', () => {
  it.each<[Format, Mesh]>([
    ['ply', placed],
    ['vtp', placed],
    ['vtk', placed],
    ['obj', placed],
    ['glb', placed],
    ['stl', near],
    ['glb', near],
  ])('%s', async (format, mesh) => {
    const part = boundsForFile(format, mesh, bounds);
    const result = await reduce(mesh, { bounds: part.bounds });
    const file = await writeSurface(format, result.mesh, { origin: originIn(format, mesh) });
    const back = await readSurface(`file.${format}`, file);
    expect(back.mesh.triangles.length).toBe(result.mesh.triangles.length);
    expect(back.mesh.triangles.length).toBeLessThan(mesh.triangles.length / 2);
    expect(await judged(mesh, back.mesh)).toBeLessThanOrEqual(1);
    for (const { name, bound, ratio } of reportOfFile(result.report, part).variables) {
      expect(bound).toBeCloseTo(limits[name as keyof typeof limits], 12);
      expect(ratio).toBeLessThanOrEqual(1);
    }
  });

  it('counts the largest distance by which a file moves a point', async () => {
    const [moved] = roundingsOf('glb', placed);
    const { mesh } = await readSurface('a.glb', await writeSurface('glb', { ...placed, variables: [] }));
    let largest = 0;
    for (let at = 0; at < mesh.position.length; at += 3) {
      const [x, y, z] = [0, 1, 2].map((axis) => mesh.position[at + axis] - placed.position[at + axis]);
      largest = Math.max(largest, Math.hypot(x, y, z));
    }
    expect(mesh.position.length).toBe(placed.position.length);
    expect(largest).toBe(moved);
    expect(moved).toBeGreaterThan(0);
    expect(moved).toBeLessThan(1e-6);
  });

  it('refuses a format by name that cannot keep a bound, and says which can', () => {
    expect(() => boundsForFile('stl', placed, bounds)).toThrow(
      /STL cannot keep the bound 0\.02 of “position”.*VTP, PLY/,
    );
    const tight = { ...bounds, temperature: { absolute: 1e-6 } };
    expect(() => boundsForFile('glb', placed, tight)).toThrow(/GLB cannot keep the bound 0\.000001 of “temperature”/);
    expect(boundsForFile('vtp', placed, tight).bounds).toBe(tight);
    // What the format has no place for is lost, and takes nothing.
    expect(() => boundsForFile('stl', near, tight)).not.toThrow();
  });

  it('tells a finished result that the rounding of a format puts beyond a bound', async () => {
    const { mesh, report } = await reduce(placed, { bounds });
    expect(isKept('stl', mesh, report)).toBe(false);
    expect(isKept('vtp', mesh, report)).toBe(true);
    const [position, ...others] = report.variables;
    const full = { ...report, variables: [{ ...position, ratio: 1 }, ...others] };
    expect(isKept('glb', mesh, full)).toBe(false);
  });

  it('leaves bounds alone where the format holds every number', () => {
    const single = { ...near, position: Float32Array.from(near.position), variables: [] };
    for (const format of ['ply', 'glb', 'stl', 'obj'] as const) {
      expect(boundsForFile(format, single, bounds).bounds).toBe(bounds);
    }
  });

  it('asks for more of the format where bounds are multiplied by less than 1', () => {
    const [whole, tenth] = [1, 0.1].map((least) => boundsForFile('glb', placed, bounds, least).bounds.position);
    const left = (bound: Bound) => (bound as { absolute: number }).absolute;
    expect(limits.position - left(tenth)).toBeCloseTo(10 * (limits.position - left(whole)), 14);
  });

  it('says the largest error of each variable that is changed', async () => {
    const [loss] = await lossesOf('glb', placed);
    const shown = roundingsOf('glb', placed).map((rounding) => rounding.toPrecision(2));
    expect(loss).toContain(`“position” (by up to ${shown[0]}), “temperature” (by up to ${shown[1]})`);
  });
});

describe('GLB far from the origin', () => {
  it('passes the validator, and other programs see the right place', async () => {
    const file = await writeSurface('glb', placed);
    const { issues } = await validateBytes(file);
    expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
    const [node] = (await new WebIO().readBinary(file)).getRoot().listNodes();
    const local = node.getMesh()?.listPrimitives()[0].getAttribute('POSITION')?.getElement(0, []) ?? [];
    const world = node.getWorldTranslation().map((value, axis) => value + local[axis]);
    for (const axis of [0, 1, 2]) expect(Math.abs(world[axis] - placed.position[axis])).toBeLessThan(1e-6);
  });

  it('holds levels of detail in the same place', async () => {
    const origin = originIn('glb', placed);
    const result = await reduce(placed, { bounds });
    const { mesh } = await readSurface('l.glb', await writeLevels([result, result], { origin }));
    expect(await judged(placed, mesh)).toBeLessThanOrEqual(1);
  });
});
