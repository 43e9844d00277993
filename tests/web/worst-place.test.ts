import { expect, test } from 'vitest';
import { reduce } from '../../wasm/index.ts';
import type { MappedReduction, VertexErrors } from '../../wasm/types.ts';
import { type ErrorHistogram, errorHistograms, histogramBins } from '../../web/probe/error-histogram.ts';
import { probePair } from '../../web/probe/probe.ts';
import { worstPlace } from '../../web/probe/worst-place.ts';
import { bumpyPlate } from '../wasm/bumpy-plate.ts';

const mesh = bumpyPlate(24);
const bounds = { position: { relative: 0.02 }, '*': { relative: 0.05 } };

test('at the worst place of each variable its error is the one reported', async () => {
  const reduction = await reduce(mesh, { bounds });
  const probed = { mesh, reduction, correspondence: null };
  reduction.report.variables.forEach(({ name, error, ratio }, index) => {
    const mapped = reduction as MappedReduction & { vertexErrors: VertexErrors[] };
    const { original, reduced } = worstPlace(mesh, mapped, index);
    const probe = probePair(probed, 'original', original, reduced, 1).variables[index];
    expect(probe.name).toBe(name);
    expect(probe.error as number).toBeCloseTo(error, 6);
    expect(probe.ratio as number).toBeCloseTo(ratio, 5);
  });
});

test('the histogram tells what share of the area has which share of the bound', async () => {
  const tracked = await reduce(mesh, { bounds });
  const all = (errorHistograms(mesh, tracked)[1] as ErrorHistogram).parts;
  expect(all).toHaveLength(histogramBins);
  expect(all.reduce((sum, next) => sum + next)).toBeCloseTo(1, 12);
  // Counted by hand: vertices without an error, by the area around them.
  const errors = (tracked.vertexErrors as VertexErrors[])[1].error;
  const largest = Math.max(...errors) / tracked.report.variables[1].bound;
  expect(all.findLastIndex((share) => share > 0)).toBe(
    Math.min(histogramBins - 1, Math.floor(histogramBins * largest)),
  );

  const propagated = await reduce(mesh, { bounds, errors: 'propagated' });
  const limits = (errorHistograms(mesh, propagated)[1] as ErrorHistogram).parts;
  expect(limits.reduce((sum, next) => sum + next)).toBeCloseTo(1, 12);

  const free = await reduce(mesh, { bounds: { position: { relative: 0.02 } } });
  expect(errorHistograms(mesh, free).map((each) => each === null)).toEqual([false, ...mesh.variables.map(() => true)]);
});

test('a surface of equal triangles, half of it in error, has half of its area there', () => {
  const position = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0]);
  const triangles = new Uint32Array([0, 1, 2, 3, 4, 5]);
  const error = new Float32Array([0, 0, 0, 0.5, 0.5, 1]);
  const reduction = {
    vertexErrors: [{ error }],
    report: { variables: [{ bound: 1 }] },
  } as unknown as Parameters<typeof errorHistograms>[1];
  const {
    parts: shares,
    half,
    most,
  } = errorHistograms({ position, triangles, variables: [] }, reduction)[0] as ErrorHistogram;
  expect(shares[0]).toBeCloseTo(1 / 2, 12);
  expect(shares[histogramBins / 2]).toBeCloseTo(1 / 3, 12);
  expect(shares[histogramBins - 1]).toBeCloseTo(1 / 6, 12);
  expect([half, most]).toEqual([0, 1]);
  // Where the bound is twice as large, the share is half as large.
  const multiplied = Object.assign({}, reduction, { multiplier: Float64Array.of(1, 1, 1, 2, 2, 2) });
  const { parts: halves } = errorHistograms({ position, triangles, variables: [] }, multiplied)[0] as ErrorHistogram;
  expect(halves[histogramBins / 4]).toBeCloseTo(1 / 3, 12);
  expect(halves[histogramBins / 2]).toBeCloseTo(1 / 6, 12);
});

test('an error that is none uses nothing of its bound, over half of the area and over nearly all of it', () => {
  const position = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0]);
  const triangles = new Uint32Array([0, 1, 2, 3, 4, 5]);
  const of = (...errors: number[]) => {
    const reduction = { vertexErrors: [{ error: Float32Array.from(errors) }], report: { variables: [{ bound: 1 }] } };
    const given = reduction as unknown as Parameters<typeof errorHistograms>[1];
    return errorHistograms({ position, triangles, variables: [] }, given)[0] as ErrorHistogram;
  };
  expect(of(0, 0, 0, 0, 0, 0)).toMatchObject({ half: 0, most: 0 });
  expect(of(0, 0, 0, 0, 0, 0.25)).toMatchObject({ half: 0, most: 0.25 });
  expect(of(0.125, 0, 0, 0.125, 0.25, 0.25)).toMatchObject({ half: 0.125, most: 0.25 });
});
