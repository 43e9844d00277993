// The judge from TypeScript: in a worker, by its own module, with the faults, progress and cancelling of other calls.
import { afterAll, describe, expect, test } from 'vitest';
import { Engine, type Mesh, reduce, verify } from '../../wasm/index.ts';

import { bumpyPlate } from './bumpy-plate.ts';

const plate = bumpyPlate(40);

/** The plate with one value of its first variable changed by this. */
function withPeak(height: number): Mesh {
  const [first, ...others] = plate.variables;
  const values = first.values.slice();
  values[Math.floor(values.length / 2)] += height;
  return { ...plate, variables: [{ ...first, values }, ...others] };
}

const free = plate.variables.slice(1).map(() => Number.POSITIVE_INFINITY);

test('passes what reduce makes, within the errors of its report', async () => {
  const { mesh, report } = await reduce(plate, { bounds: { '*': { relative: 0.02 } } });
  const verdict = await verify(plate, mesh, { bounds: report.variables.map(({ bound }) => bound) });
  expect(report.triangles.after).toBeLessThan(report.triangles.before / 2);
  expect(verdict.withinBounds).toBe(true);
  expect(verdict.ratio).toBeGreaterThan(0.5);
  expect(verdict.ratio).toBeLessThanOrEqual(1 + 1e-6);
  expect(verdict.surface.fromOriginal.samples).toBeGreaterThan(10000);
});

test('finds a bound broken, where and by which variable', async () => {
  const verdict = await verify(plate, withPeak(100), { bounds: [1e-3, 1, ...free] });
  expect(verdict.withinBounds).toBe(false);
  expect(verdict.surface.fromReduced.variable).toBe(1);
  const vertex = Math.floor(plate.position.length / 6);
  const place = Array.from(plate.position.slice(3 * vertex, 3 * vertex + 3));
  for (const [axis, coordinate] of verdict.surface.fromReduced.position.entries())
    expect(coordinate).toBeCloseTo(place[axis], 1);
});

test('multiplies bounds', async () => {
  const multipliers = new Float32Array(plate.position.length / 3).fill(1000);
  const verdict = await verify(plate, withPeak(100), { bounds: [1e-3, 1, ...free], multipliers });
  expect(verdict.withinBounds).toBe(true);
});

describe('of bad input it says what is wrong and where', () => {
  const bounds = [1, 1, ...free];

  test.each([
    ['a bound of zero', plate, { bounds: [0, 1, ...free] }, { code: 'bad_bound', variable: 'position' }],
    ['too few bounds', plate, { bounds: [1] }, { code: 'bad_bound' }],
    ['no sample', plate, { bounds, samples: 0 }, { code: 'bad_option' }],
    ['half a sample', plate, { bounds, samples: 0.5 }, { code: 'bad_option' }],
    ['too few multipliers', plate, { bounds, multipliers: new Float32Array(2) }, { code: 'bad_option' }],
    ['no variable', { ...plate, variables: [] }, { bounds }, { code: 'unknown_variable' }],
    ['no triangle', { ...plate, triangles: new Uint32Array() }, { bounds }, { code: 'no_triangles' }],
    [
      'a triangle too far',
      { ...plate, triangles: Uint32Array.of(0, 1, 1e6) },
      { bounds },
      { code: 'bad_index', index: 0 },
    ],
  ])('%s', async (_, reduced, options, fault) => {
    await expect(verify(plate, reduced, options)).rejects.toMatchObject({ name: 'MeshboundError', ...fault });
  });

  test('arrays of another type', async () => {
    const text = { bounds: 'all' } as unknown as { bounds: number[] };
    await expect(verify(plate, plate, text)).rejects.toThrow(TypeError);
    const whole = { bounds, multipliers: new Int8Array(2) } as unknown as { bounds: number[] };
    await expect(verify(plate, plate, whole)).rejects.toThrow(TypeError);
  });
});

describe('an engine', () => {
  const engine = new Engine();
  afterAll(() => engine.dispose());

  test('reports progress, and is cancelled', async () => {
    const steps: number[] = [];
    const stopping = new AbortController();
    const options = { bounds: [1e-3, 1, ...free], samples: 1e8, signal: stopping.signal };
    const running = engine.verify(plate, plate, {
      ...options,
      onProgress: (progress) => {
        steps.push(progress);
        if (steps.length === 5) stopping.abort();
      },
    });
    await expect(running).rejects.toMatchObject({ name: 'AbortError' });
    expect(steps).toEqual([...steps].sort((a, b) => a - b));
    await expect(engine.inspect(plate)).resolves.toBeDefined();
  });

  test('says where the module of the judge is not', async () => {
    const lost = new Engine({ judgeUrl: 'nowhere.wasm' });
    await expect(lost.inspect(plate)).resolves.toBeDefined();
    await expect(lost.verify(plate, plate, { bounds: [1, 1, ...free] })).rejects.toThrow(/nowhere\.wasm/);
    lost.dispose();
  });
});
