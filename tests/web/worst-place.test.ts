import { describe, expect, test } from 'vitest';
import { reduce } from '../../wasm/index.ts';
import type { MappedReduction, Mesh, VertexErrors } from '../../wasm/types.ts';
import { type ErrorHistogram, errorHistograms, histogramBins } from '../../web/probe/error-histogram.ts';
import { probePair } from '../../web/probe/probe.ts';
import { type TrackedReduction, worstPlace } from '../../web/probe/worst-place.ts';
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

describe('of what is no surface nothing is the worst', () => {
  /** The plate behind points that no triangle uses, and a triangle that names a point twice. */
  const { position, triangles, variables } = bumpyPlate(12);
  const stray = 3;
  const withStray: Mesh = {
    position: Float32Array.of(...Array(3 * stray).fill(Number.NaN), ...position),
    triangles: Uint32Array.of(stray, stray, 0, ...triangles.map((corner) => corner + stray)),
    variables: variables.map((variable) => ({
      ...variable,
      values: Float64Array.of(...Array(stray * variable.components).fill(Number.NaN), ...variable.values),
    })),
  };

  test.each(['tracked', 'propagated'] as const)('with %s errors', async (errors) => {
    const reduction = (await reduce(withStray, { bounds, errors })) as TrackedReduction;
    expect(reduction.report.variables.every(({ error }) => error > 0)).toBe(true);
    for (const histogram of errorHistograms(withStray, reduction)) {
      expect(histogram?.parts.reduce((sum, part) => sum + part)).toBeCloseTo(1, 12);
      expect(histogram?.most).toBeLessThanOrEqual(1);
    }
    if (errors === 'propagated') return;
    reduction.report.variables.forEach(({ error }, index) => {
      const { original, reduced } = worstPlace(withStray, reduction, index);
      const { variables: here } = probePair(
        { mesh: withStray, reduction, correspondence: null },
        'original',
        original,
        reduced,
        1,
      );
      expect(here[index].error as number).toBeCloseTo(error, 6);
    });
  });

  test('where there is no error at all, the place is one of the surface', async () => {
    const flat: Mesh = {
      position: Float64Array.of(9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0),
      triangles: Uint32Array.of(1, 2, 3),
      variables: [],
    };
    const reduction = (await reduce(flat, { bounds: { position: { relative: 0.1 } } })) as TrackedReduction;
    expect(worstPlace(flat, reduction, 0)).toMatchObject({ original: { triangle: 0 }, reduced: { triangle: 0 } });
  });

  test('a multiplier that is no number there changes nothing of the histogram', () => {
    const reduction = {
      vertexErrors: [{ error: Float32Array.of(0, 0.5, 0.25, 1) }],
      report: { variables: [{ bound: 1 }] },
      multiplier: Float64Array.of(Number.NaN, 1, 1, 1),
    } as unknown as Parameters<typeof errorHistograms>[1];
    const flat: Mesh = {
      position: Float64Array.of(9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0),
      triangles: Uint32Array.of(1, 2, 3),
      variables: [],
    };
    expect(errorHistograms(flat, reduction)[0]).toMatchObject({ half: 0.5, most: 1 });
  });
});

describe('a variable that is no number somewhere', async () => {
  const holes = bumpyPlate(24);
  const values = Float64Array.from({ length: holes.position.length / 3 }, (_, i) => Math.sin(i / 9));
  values.fill(Number.NaN, 40, 60);
  values[300] = Number.POSITIVE_INFINITY;
  const withHoles: Mesh = { ...holes, variables: [{ name: 'sst', components: 1, values }, ...holes.variables] };
  const reduction = (await reduce(withHoles, { bounds: { ...bounds, sst: 'free' } })) as TrackedReduction;
  const probed = { mesh: withHoles, reduction, correspondence: null };

  test('has its largest error at a place where it is one', () => {
    const { original, reduced } = worstPlace(withHoles, reduction, 1);
    const { error } = probePair(probed, 'original', original, reduced, 1).variables[1];
    const known = reduction.vertexErrors[1].error.filter(Number.isFinite);
    expect(error).toBeGreaterThanOrEqual(0.999999 * Math.max(...known));
  });

  test('has no error, and no share of a bound, at a place where it is none', () => {
    const hole = withHoles.triangles.indexOf(45);
    const place = { triangle: Math.floor(hole / 3), barycentric: [0, 1, 2].map((i) => Number(i === hole % 3)) };
    const probe = probePair(probed, 'original', place as never, { triangle: 0, barycentric: [1, 0, 0] }, 1);
    expect(probe.variables[1]).toMatchObject({ original: [Number.NaN], error: null, ratio: null });
    const triangle = reduction.triangleErrors[1].largest.findIndex(Number.isNaN);
    const alone = probePair(probed, 'reduced', null, { triangle, barycentric: [1, 0, 0] }, 1);
    expect(alone.variables[1]).toMatchObject({ error: null, ratio: null });
    expect(alone.variables[0].error).not.toBe(null);
  });

  test('has no histogram, and takes nothing from those of others', async () => {
    const plain = await reduce(holes, { bounds });
    const [position, sst, ...others] = errorHistograms(withHoles, reduction);
    expect(sst).toBe(null);
    expect([position, ...others]).toEqual(errorHistograms(holes, plain));
  });
});
