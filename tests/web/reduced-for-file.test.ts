import { expect, it, vi } from 'vitest';
import { reduce, reduceLevels } from '../../wasm/index.ts';
import type { Mesh, Report } from '../../wasm/types.ts';
import { roundingsOf } from '../../web/formats/file-rounding.ts';
import { readSurface } from '../../web/formats/read.ts';
import { noLabels } from '../../web/formats/surface.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { asBounds } from '../../web/session/bounds/bound-setting.ts';
import { nothingKept } from '../../web/session/constraints/keeping.ts';
import { firstMethod } from '../../web/session/constraints/method.ts';
import { reducedForFile } from '../../web/session/reducing/reduced-for-file.ts';

const side = 25;

/** A flat square whose temperature, in double precision, has a wave of 0.001 at 300. */
function plate(): Mesh {
  const points = Array.from({ length: side * side }, (_, i) => [i % side, Math.floor(i / side)]);
  const triangles = Array.from({ length: (side - 1) ** 2 }, (_, square) => {
    const corner = square + Math.floor(square / (side - 1));
    return [corner, corner + 1, corner + side + 1, corner, corner + side + 1, corner + side];
  });
  const wave = points.map(([x, y]) => 300 + 1e-3 * Math.sin(x / 3) * Math.cos(y / 4));
  return {
    position: Float32Array.from(points.flatMap(([x, y]) => [x, y, 0])),
    triangles: Uint32Array.from(triangles.flat()),
    variables: [{ name: 'temperature', components: 1, values: Float64Array.from(wave) }],
  };
}

const mesh = plate();
const { units, componentNames } = noLabels();
const labels = { units, componentNames };
const surface = { name: 'plate', address: null, mesh, labels, variables: [], locked: undefined };

/** What is in memory, and what is to go into a file. */
async function atBound(temperature: number) {
  const bounds = {
    position: { fraction: 0.01, free: false },
    temperature: { fraction: 0.1, absolute: temperature, free: false },
  };
  const result = await reduce(mesh, { ...firstMethod, bounds: asBounds(bounds) });
  return { result, bounds, method: firstMethod, keeping: nothingKept };
}

it('is the result where the format keeps every number', async () => {
  const reduced = await atBound(1e-4);
  const again = vi.fn(reduce);
  const forFile = await reducedForFile('vtp', surface, [reduced], { reduce: again, reduceLevels });
  expect(forFile).toEqual({ results: [{ mesh: reduced.result.mesh, report: reduced.result.report }], again: false });
  expect(again).not.toHaveBeenCalled();
});

it('is reduced anew where rounding would break a bound, and keeps it in the file', async () => {
  const reduced = await atBound(1e-4);
  const again = vi.fn(reduce);
  const {
    results,
    origin,
    again: isAgain,
  } = await reducedForFile('glb', surface, [reduced], { reduce: again, reduceLevels });
  const [{ mesh: kept, report: inFile }] = results;
  expect(isAgain).toBe(true);
  expect(again).toHaveBeenCalledOnce();
  const [{ bounds }] = again.mock.calls.map(([, options]) => options);
  const left = (bounds.temperature as { absolute: number }).absolute;
  expect(left).toBe(1e-4 - roundingsOf('glb', mesh)[1]);
  const { report } = await (again.mock.results[0].value as ReturnType<typeof reduce>);
  const back = (await readSurface('a.glb', await writeSurface('glb', kept, { ...labels, origin }))).mesh;
  let moved = 0;
  for (const [i, value] of kept.variables[0].values.entries())
    moved = Math.max(moved, Math.abs(back.variables[0].values[i] - value));
  expect(moved).toBeGreaterThan(0);
  expect(report.variables[1].error + moved).toBeLessThanOrEqual(1e-4);
  const [rounding] = roundingsOf('glb', mesh).slice(1);
  expect(inFile.variables[1]).toMatchObject({ bound: 1e-4, rounding, error: report.variables[1].error + rounding });
  expect(inFile.variables[1].ratio).toBeLessThanOrEqual(1);
});

it('is refused by name, before anything is reduced, where the format takes too much', async () => {
  const reduced = await atBound(2e-5);
  const again = vi.fn(reduce);
  await expect(reducedForFile('glb', surface, [reduced], { reduce: again, reduceLevels })).rejects.toThrow(
    /GLB cannot keep the bound 0\.00002 of “temperature”/,
  );
  expect(again).not.toHaveBeenCalled();
});

it('is reduced anew to levels that all keep their bounds in the file', async () => {
  const levels = await Promise.all([1e-4, 2e-4, 4e-4].map(atBound));
  const all = levels.map(({ bounds }) => asBounds(bounds));
  const shown = await reduceLevels(mesh, { ...firstMethod, levels: all });
  const reduced = shown.levels.map((result, i) => ({ ...levels[i], result }));
  const { results, origin, again } = await reducedForFile('glb', surface, reduced, { reduce, reduceLevels });
  expect(again).toBe(true);
  expect(results).toHaveLength(3);
  for (const [i, { mesh: kept, report }] of results.entries()) {
    const back = (await readSurface('a.glb', await writeSurface('glb', kept, { ...labels, origin }))).mesh;
    expect(report.variables[1].bound).toBeCloseTo([1e-4, 2e-4, 4e-4][i], 12);
    expect(report.variables[1].ratio).toBeLessThanOrEqual(1);
    expect(back.triangles).toEqual(kept.triangles);
  }
});

it('has the errors of the file in its report where it need not be reduced anew', async () => {
  const reduced = await atBound(0.01);
  const again = vi.fn(reduce);
  const { results } = await reducedForFile('glb', surface, [reduced], { reduce: again, reduceLevels });
  expect(again).not.toHaveBeenCalled();
  const [rounding] = roundingsOf('glb', reduced.result.mesh).slice(1);
  const before = reduced.result.report.variables[1];
  expect(results[0].report.variables[1]).toMatchObject({ error: before.error + rounding, rounding });
  expect(results[0].report.variables[1].ratio).toBeCloseTo(before.ratio + rounding / before.bound, 12);
});

it('leaves the format its part of a bound that the feature size limits', async () => {
  // Two plates, 0.002 apart: half of that distance is the bound, and GLB rounds thirds by a hundredth of it.
  const [lower, upper] = [0, 0.002];
  const square = [0, 0, 1, 0, 1, 1, 0, 1];
  const corners = (z: number) =>
    [0, 1, 2, 3].flatMap((i) => [(square[2 * i] * 1000) / 3, (square[2 * i + 1] * 1000) / 3, z]);
  const plates: Mesh = {
    position: Float64Array.from([...corners(lower), ...corners(upper)]),
    triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6),
    variables: [],
  };
  const method = { ...firstMethod, limitToFeatureSize: true };
  const bounds = { position: { fraction: 0.01, absolute: 10, free: false } };
  const result = await reduce(plates, { ...method, bounds: asBounds(bounds) });
  const { featureSize = Number.NaN } = result.report;
  expect(featureSize).toBeCloseTo(0.002, 12);
  const open = { ...surface, mesh: plates };
  const reduced = { result: { ...result, report: fullyUsed(result.report) }, bounds, method, keeping: nothingKept };
  const again = vi.fn(reduce);
  const { results } = await reducedForFile('glb', open, [reduced], { reduce: again, reduceLevels });
  const asked = again.mock.calls.map(([, options]) => options.bounds.position);
  const [rounding] = roundingsOf('glb', plates);
  expect(rounding).toBeGreaterThan(0);
  expect(asked).toEqual([{ absolute: 10 - rounding }, { absolute: featureSize / 2 - rounding }]);
  expect(results[0].report.featureSize).toBe(featureSize);
  expect(results[0].report.variables[0].bound).toBeCloseTo(featureSize / 2, 12);
});

/** As of a reduction that used all of its bounds. */
function fullyUsed(report: Report): Report {
  return { ...report, variables: report.variables.map((variable) => ({ ...variable, ratio: 1 })) };
}
