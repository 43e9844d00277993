import { expect, it, vi } from 'vitest';
import { reduce } from '../../wasm/index.ts';
import type { Mesh } from '../../wasm/types.ts';
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
  expect((await reducedForFile('vtp', surface, reduced, again)).mesh).toBe(reduced.result.mesh);
  expect(again).not.toHaveBeenCalled();
});

it('is reduced anew where rounding would break a bound, and keeps it in the file', async () => {
  const reduced = await atBound(1e-4);
  const again = vi.fn(reduce);
  const { mesh: kept, origin } = await reducedForFile('glb', surface, reduced, again);
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
});

it('is refused by name, before anything is reduced, where the format takes too much', async () => {
  const reduced = await atBound(2e-5);
  const again = vi.fn(reduce);
  await expect(reducedForFile('glb', surface, reduced, again)).rejects.toThrow(
    /GLB cannot keep the bound 0\.00002 of “temperature”/,
  );
  expect(again).not.toHaveBeenCalled();
});
