import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { Mesh, ReduceOptions, Reduction } from '../../wasm/types.ts';
import { defaultBounds, moveAll } from '../../web/session/bounds/bound-setting.ts';
import { BoundsCurve, curveFractions } from '../../web/session/bounds/bounds-curve.ts';
import { nothingKept } from '../../web/session/constraints/keeping.ts';
import type { SessionState } from '../../web/session/session-state.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** A surface of which a hundredth of its largest bound's inverse is left. */
async function reduce(_: Mesh, { bounds }: ReduceOptions): Promise<Reduction> {
  const { relative } = bounds.pressure as { relative: number };
  return { report: { triangles: { before: 1000, after: Math.round(1 / relative) } } } as Reduction;
}

const resting = {
  surface: { mesh: { variables: [] } },
  bounds: defaultBounds([{ name: 'position' }, { name: 'pressure' }]),
  method: { errors: 'tracked', cost: 'introduced' },
  keeping: nothingKept,
  reduced: { result: { report: { triangles: { before: 1000, after: 33 } } } },
  progress: null,
  opening: null,
} as unknown as SessionState;

function setUp() {
  const run = vi.fn(reduce);
  return { run, curve: new BoundsCurve(run) };
}

test('measures in the proportions of the session while it rests, and has its result among them', async () => {
  const { curve, run } = setUp();
  curve.follow(resting);
  await vi.runAllTimersAsync();
  expect(run).toHaveBeenCalledTimes(curveFractions.length - 1);
  expect(run.mock.calls[0][1].bounds).toEqual({ position: { relative: 0.00333 }, pressure: { relative: 0.01 } });
  expect(curve.points.map(({ fraction }) => fraction)).toEqual([...curveFractions].sort((a, b) => a - b));
  expect(curve.points.find(({ fraction }) => fraction === 0.001)?.triangles).toBe(1000);
  expect(curve.points.find(({ fraction }) => fraction === 0.03)?.triangles).toBe(33);
});

test('measures nothing while the session works, or nobody looks', async () => {
  const { curve, run } = setUp();
  curve.follow(resting);
  curve.follow({ ...resting, progress: 0.5 });
  await vi.runAllTimersAsync();
  curve.follow(resting);
  curve.follow(null);
  await vi.runAllTimersAsync();
  expect(run).not.toHaveBeenCalled();
});

test('keeps the curve while all bounds move in proportion, and begins another with another mix', async () => {
  const { curve, run } = setUp();
  curve.follow(resting);
  await vi.runAllTimersAsync();
  const measured = run.mock.calls.length;
  curve.follow({ ...resting, bounds: moveAll(resting.bounds, 0.0501) });
  await vi.runAllTimersAsync();
  expect(run).toHaveBeenCalledTimes(measured);
  expect(curve.points).toHaveLength(curveFractions.length + 1);
  curve.follow({ ...resting, bounds: { ...resting.bounds, pressure: { fraction: 0.06, free: false } } });
  expect(curve.points).toHaveLength(1);
});
