import { describe, expect, test } from 'vitest';
import { reduce, resumeReduction } from '../../wasm/index.ts';
import type { Bound, Checkpoint, Reduction } from '../../wasm/types.ts';
import { bumpyPlate } from './bumpy-plate.ts';

const percent = (share: number): Record<string, Bound> => ({
  position: { relative: share / 100 },
  '*': { relative: (3 * share) / 100 },
});
const mesh = bumpyPlate(40);

async function passed(): Promise<Reduction & { checkpoint: Checkpoint }> {
  const reduction = await reduce(mesh, { bounds: percent(1), checkpoint: true });
  expect(reduction.checkpoint).toBeDefined();
  return reduction as Reduction & { checkpoint: Checkpoint };
}

describe('a checkpoint', () => {
  test('is given out where it is asked for, and has spent an eighth of the bounds', async () => {
    expect((await reduce(mesh, { bounds: percent(1) })).checkpoint).toBeUndefined();
    const { checkpoint, report } = await passed();
    expect(checkpoint.report.termination).toBe('intermediate');
    expect(checkpoint.report.triangles).toEqual({ before: 3200, after: checkpoint.mesh.triangles.length / 3 });
    expect(checkpoint.report.triangles.after).toBeGreaterThan(report.triangles.after);
    for (const { bound, error } of checkpoint.report.variables) expect(error / bound).toBeLessThanOrEqual(1 / 8);
    expect(Math.max(...checkpoint.report.variables.map(({ ratio }) => ratio))).toBeCloseTo(1 / 8);
  });
});

describe('resumeReduction', () => {
  test('keeps other bounds to the original, without a map', async () => {
    const { checkpoint } = await passed();
    const before = structuredClone(checkpoint);
    const onward = await resumeReduction(checkpoint, { bounds: percent(3) });
    expect(checkpoint).toEqual(before);
    expect(onward.map).toBeUndefined();
    expect(onward.vertexErrors).toBeUndefined();
    expect(onward.report.errorsAreUpperBounds).toBe(true);
    expect(onward.report.termination).toBe('finished');
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
    const onward = await resumeReduction(first, { bounds: percent(4) });
    expect(onward.report.triangles.after).toBeLessThan(first.report.triangles.after);
  });

  test('names the variable whose bound is spent', async () => {
    const { checkpoint } = await passed();
    const tight = resumeReduction(checkpoint, { bounds: percent(0.1) });
    await expect(tight).rejects.toMatchObject({ code: 'bad_checkpoint', variable: 'position' });
  });

  test('names a locked vertex that is gone', async () => {
    const { checkpoint } = await passed();
    const gone = Array.from(checkpoint.vertices).findIndex((vertex, i) => vertex !== i);
    const locked = Uint32Array.of(gone);
    const refused = resumeReduction(checkpoint, { bounds: percent(3), locked });
    await expect(refused).rejects.toMatchObject({ code: 'bad_checkpoint', index: gone });
    expect(locked).toHaveLength(1);
  });

  test('refuses a checkpoint that contradicts itself', async () => {
    const { checkpoint } = await passed();
    const { report } = checkpoint;
    const bounds = percent(3);
    const broken: Checkpoint[] = [
      { ...checkpoint, vertices: checkpoint.vertices.slice(1) },
      { ...checkpoint, report: { ...report, variables: report.variables.slice(1) } },
      {
        ...checkpoint,
        report: { ...report, variables: report.variables.map((one) => ({ ...one, error: Number.NaN })) },
      },
      { ...checkpoint, report: { ...report, vertices: { before: 1, after: 1 } } },
    ];
    for (const each of broken) {
      await expect(resumeReduction(each, { bounds })).rejects.toMatchObject({ code: 'bad_checkpoint' });
    }
  });

  test('names the vertex that cannot be of the original', async () => {
    const { checkpoint } = await passed();
    const vertices = checkpoint.vertices.slice();
    vertices[3] = 2 ** 31;
    const refused = resumeReduction({ ...checkpoint, vertices }, { bounds: percent(3) });
    await expect(refused).rejects.toMatchObject({ code: 'bad_checkpoint', index: 3 });
  });

  test('refuses a checkpoint of another shape', async () => {
    const { checkpoint } = await passed();
    const { report } = checkpoint;
    const bounds = percent(3);
    for (const part of ['triangles', 'vertices', 'variables', 'defects', 'dropped', 'regions'] as const) {
      const refused = resumeReduction({ ...checkpoint, report: { ...report, [part]: undefined } }, { bounds });
      const message = `The checkpoint has no “${part}” where it should.`;
      await expect(refused).rejects.toMatchObject({ code: 'bad_checkpoint', message });
    }
    const unreported = { ...checkpoint, report: undefined } as unknown as Checkpoint;
    await expect(resumeReduction(unreported, { bounds })).rejects.toMatchObject({ code: 'bad_checkpoint' });
    const listed = { ...checkpoint, vertices: Array.from(checkpoint.vertices) } as unknown as Checkpoint;
    await expect(resumeReduction(listed, { bounds })).rejects.toThrow(
      new TypeError('The vertices must be a Uint32Array.'),
    );
  });

  test('reads of a checkpoint’s report only what it goes by', async () => {
    const { checkpoint } = await passed();
    const bounds = percent(3);
    const whole = await resumeReduction(checkpoint, { bounds });
    const { triangles, vertices, variables, candidates, defects, dropped, regions, nonManifoldVertices } =
      checkpoint.report;
    const spent = variables.map(({ name, extent, magnitude, constant, error }) => ({
      name,
      extent,
      magnitude,
      constant,
      error,
    }));
    const report = {
      ...{ candidates, defects, dropped, regions, nonManifoldVertices, variables: spent },
      ...{ triangles: { before: triangles.before }, vertices: { before: vertices.before } },
    };
    const onward = await resumeReduction({ ...checkpoint, report } as unknown as Checkpoint, { bounds });
    expect({ ...onward.report, seconds: 0 }).toEqual({ ...whole.report, seconds: 0 });
  });

  test('can be aborted', async () => {
    const { checkpoint } = await passed();
    const refused = resumeReduction(checkpoint, { bounds: percent(3), signal: AbortSignal.abort() });
    await expect(refused).rejects.toMatchObject({ name: 'AbortError' });
  });
});
