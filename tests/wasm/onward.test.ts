import { describe, expect, test } from 'vitest';
import { reduce, reduceOnward } from '../../wasm/index.ts';
import type { Bound, Reduction, Waypoint } from '../../wasm/types.ts';
import { bumpyPlate } from './bumpy-plate.ts';

const percent = (share: number): Record<string, Bound> => ({
  position: { relative: share / 100 },
  '*': { relative: (3 * share) / 100 },
});
const mesh = bumpyPlate(40);

async function passed(): Promise<Reduction & { waypoint: Waypoint }> {
  const reduction = await reduce(mesh, { bounds: percent(1), waypoint: true });
  expect(reduction.waypoint).toBeDefined();
  return reduction as Reduction & { waypoint: Waypoint };
}

describe('a waypoint', () => {
  test('is given out where it is asked for, and has spent an eighth of the bounds', async () => {
    expect((await reduce(mesh, { bounds: percent(1) })).waypoint).toBeUndefined();
    const { waypoint, report } = await passed();
    expect(waypoint.report.stopped).toBe('on_the_way');
    expect(waypoint.report.triangles).toEqual({ before: 3200, after: waypoint.mesh.triangles.length / 3 });
    expect(waypoint.report.triangles.after).toBeGreaterThan(report.triangles.after);
    for (const { bound, error } of waypoint.report.variables) expect(error / bound).toBeLessThanOrEqual(1 / 8);
    expect(Math.max(...waypoint.report.variables.map(({ ratio }) => ratio))).toBeCloseTo(1 / 8);
  });
});

describe('reduceOnward', () => {
  test('keeps other bounds to the original, without a map', async () => {
    const { waypoint } = await passed();
    const before = structuredClone(waypoint);
    const onward = await reduceOnward(waypoint, { bounds: percent(3) });
    expect(waypoint).toEqual(before);
    expect(onward.map).toBeUndefined();
    expect(onward.vertexErrors).toBeUndefined();
    expect(onward.report.summed).toBe(true);
    expect(onward.report.stopped).toBe('finished');
    expect(onward.report.triangles).toEqual({ before: 3200, after: onward.mesh.triangles.length / 3 });
    const { report } = await reduce(mesh, { bounds: percent(3) });
    onward.report.variables.forEach(({ bound, ratio }, i) => {
      expect(bound).toBe(report.variables[i]?.bound);
      expect(ratio).toBeLessThanOrEqual(1);
      expect(ratio).toBeGreaterThan(0);
    });
    const place = (vertex: number) => mesh.position.slice(3 * vertex, 3 * vertex + 3);
    onward.vertices.forEach((vertex, i) => {
      expect(onward.mesh.position.slice(3 * i, 3 * i + 3)).toEqual(place(vertex));
    });
  });

  test('goes on from a result', async () => {
    const first = await passed();
    const onward = await reduceOnward(first, { bounds: percent(4) });
    expect(onward.report.triangles.after).toBeLessThan(first.report.triangles.after);
  });

  test('names the variable whose bound is spent', async () => {
    const { waypoint } = await passed();
    const tight = reduceOnward(waypoint, { bounds: percent(0.1) });
    await expect(tight).rejects.toMatchObject({ code: 'bad_waypoint', variable: 'position' });
  });

  test('names a locked vertex that is gone', async () => {
    const { waypoint } = await passed();
    const gone = Array.from(waypoint.vertices).findIndex((vertex, i) => vertex !== i);
    const locked = Uint32Array.of(gone);
    const refused = reduceOnward(waypoint, { bounds: percent(3), locked });
    await expect(refused).rejects.toMatchObject({ code: 'bad_waypoint', index: gone });
    expect(locked).toHaveLength(1);
  });

  test('refuses a waypoint that contradicts itself', async () => {
    const { waypoint } = await passed();
    const { report } = waypoint;
    const bounds = percent(3);
    const broken: Waypoint[] = [
      { ...waypoint, vertices: waypoint.vertices.slice(1) },
      { ...waypoint, report: { ...report, variables: report.variables.slice(1) } },
      { ...waypoint, report: { ...report, variables: report.variables.map((one) => ({ ...one, error: Number.NaN })) } },
      { ...waypoint, report: { ...report, vertices: { before: 1, after: 1 } } },
    ];
    for (const each of broken) {
      await expect(reduceOnward(each, { bounds })).rejects.toMatchObject({ code: 'bad_waypoint' });
    }
  });

  test('names the vertex that cannot be of the original', async () => {
    const { waypoint } = await passed();
    const vertices = waypoint.vertices.slice();
    vertices[3] = 2 ** 31;
    const refused = reduceOnward({ ...waypoint, vertices }, { bounds: percent(3) });
    await expect(refused).rejects.toMatchObject({ code: 'bad_waypoint', index: 3 });
  });

  test('refuses a waypoint of another shape', async () => {
    const { waypoint } = await passed();
    const { report } = waypoint;
    const bounds = percent(3);
    for (const part of ['triangles', 'vertices', 'variables', 'oddities', 'dropped', 'regions'] as const) {
      const refused = reduceOnward({ ...waypoint, report: { ...report, [part]: undefined } }, { bounds });
      const message = `The waypoint has no “${part}” where it should.`;
      await expect(refused).rejects.toMatchObject({ code: 'bad_waypoint', message });
    }
    const unreported = { ...waypoint, report: undefined } as unknown as Waypoint;
    await expect(reduceOnward(unreported, { bounds })).rejects.toMatchObject({ code: 'bad_waypoint' });
    const listed = { ...waypoint, vertices: Array.from(waypoint.vertices) } as unknown as Waypoint;
    await expect(reduceOnward(listed, { bounds })).rejects.toThrow(
      new TypeError('The vertices must be a Uint32Array.'),
    );
  });

  test('reads of a waypoint’s report only what it goes by', async () => {
    const { waypoint } = await passed();
    const bounds = percent(3);
    const whole = await reduceOnward(waypoint, { bounds });
    const { triangles, vertices, variables, candidates, oddities, dropped, regions, nonManifoldVertices } =
      waypoint.report;
    const spent = variables.map(({ name, extent, magnitude, constant, error }) => ({
      name,
      extent,
      magnitude,
      constant,
      error,
    }));
    const report = {
      ...{ candidates, oddities, dropped, regions, nonManifoldVertices, variables: spent },
      ...{ triangles: { before: triangles.before }, vertices: { before: vertices.before } },
    };
    const onward = await reduceOnward({ ...waypoint, report } as unknown as Waypoint, { bounds });
    expect({ ...onward.report, seconds: 0 }).toEqual({ ...whole.report, seconds: 0 });
  });

  test('can be aborted', async () => {
    const { waypoint } = await passed();
    const refused = reduceOnward(waypoint, { bounds: percent(3), signal: AbortSignal.abort() });
    await expect(refused).rejects.toMatchObject({ name: 'AbortError' });
  });
});
