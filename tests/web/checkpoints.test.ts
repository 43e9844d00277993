// While bounds move a session answers from a checkpoint, and the result at rest is the one from the original.
import { afterEach, describe, expect, test, vi } from 'vitest';
import type { Checkpoint, ReduceOptions, Reduction, Report, ResumeOptions } from '../../wasm/types.ts';
import { nothingKept } from '../../web/session/constraints/keeping.ts';
import { firstMethod } from '../../web/session/constraints/method.ts';
import { Checkpoints } from '../../web/session/reducing/checkpoints.ts';
import { Session } from '../../web/session/session.ts';
import { answerOf } from '../../web/session/session-state.ts';
import { noDefects } from './no-defects.ts';

const mesh = {
  position: new Float32Array(9),
  triangles: new Uint32Array([0, 1, 2]),
  variables: [{ name: 'pressure', components: 1, values: new Float32Array(3) }],
};

/** Of extents of 100, so that errors are percentages. */
function reportOf(position: number, pressure: number, seconds = 1): Report {
  const variable = (name: string, error: number) => ({ name, error, extent: 100, magnitude: 100, constant: false });
  return { variables: [variable('position', position), variable('pressure', pressure)], seconds } as unknown as Report;
}

function checkpointOf(triangles: number, report: Report): Checkpoint {
  return { mesh: { ...mesh, triangles: new Uint32Array(3 * triangles) }, vertices: new Uint32Array(), report };
}

const percent = (position: number, pressure: number) => ({
  position: { fraction: position / 100, free: false },
  pressure: { fraction: pressure / 100, free: false },
});
const asked = (position: number, pressure: number, method = firstMethod, keeping = nothingKept) => ({
  bounds: percent(position, pressure),
  method,
  keeping,
});

describe('checkpoints', () => {
  const passed = checkpointOf(50, reportOf(0.125, 0.375));
  const result = checkpointOf(10, reportOf(0.9, 2.9));
  const checkpoints = new Checkpoints();
  checkpoints.keep(result, passed, asked(1, 3));

  test('the coarsest of those that have spent at most half of every bound serves', () => {
    expect(checkpoints.nearest(asked(1, 3))).toBe(passed);
    expect(checkpoints.nearest(asked(2, 6))).toEqual(result);
    expect(checkpoints.nearest(asked(2, 3))).toBe(passed);
    expect(checkpoints.nearest(asked(0.25, 0.75))).toBe(passed);
    expect(checkpoints.nearest(asked(0.24, 0.75))).toBeNull();
    expect(checkpoints.nearest(asked(0.25, 0.74))).toBeNull();
  });

  test('a bound in the unit of the variable counts as it is, and what is free does not', () => {
    const bounds = { ...percent(1, 0.1), position: { fraction: 0, absolute: 0.25, free: false } };
    expect(checkpoints.nearest({ ...asked(1, 1), bounds })).toBeNull();
    bounds.pressure.free = true;
    expect(checkpoints.nearest({ ...asked(1, 1), bounds })).toBe(passed);
  });

  test('what was free counts by its error', () => {
    const free = new Checkpoints();
    free.keep(result, checkpointOf(50, reportOf(0.125, 20)), asked(1, 3));
    expect(free.nearest(asked(1, 30))).toBeNull();
    expect(free.nearest(asked(1, 40))).not.toBeNull();
  });

  test('those of another method, or of something else that was kept, do not serve', () => {
    expect(checkpoints.nearest(asked(1, 3, { ...firstMethod, refusePiercing: true }))).toBeNull();
    expect(checkpoints.nearest(asked(1, 3, firstMethod, { ...nothingKept, lockPoints: [[1, 1]] }))).toBeNull();
  });

  test('who waits for moments only needs none', () => {
    const quick = new Checkpoints();
    quick.keep(checkpointOf(10, reportOf(0.9, 2.9, 0.05)), passed, asked(1, 3));
    expect(quick.nearest(asked(1, 3))).toBeNull();
  });

  test('those of the last two reductions are kept', () => {
    const many = new Checkpoints();
    const all = [0.1, 0.2, 0.4].map((spent, i) => checkpointOf(100 - i, reportOf(spent, spent)));
    for (const each of all) many.keep(checkpointOf(1, reportOf(50, 50)), each, asked(1, 3));
    expect(many.nearest(asked(1, 1))).toBe(all[2]);
    expect(many.nearest(asked(0.4, 0.4))).toBe(all[1]);
    expect(many.nearest(asked(0.2, 0.2))).toBeNull();
    many.clear();
    expect(many.nearest(asked(1, 1))).toBeNull();
  });
});

interface Run<Options> {
  options: Options;
  finish(): Promise<void>;
  fail(): Promise<void>;
}

/** Reductions that end when the test says so; the first one, of 1 % and 3 %, has passed a checkpoint. */
async function opened() {
  const runs: Run<ReduceOptions>[] = [];
  const drafts: (Run<ResumeOptions> & { checkpoint: Checkpoint })[] = [];
  const running = <Options extends { signal?: AbortSignal }>(options: Options, result: Partial<Reduction>) => {
    let [finish, fail] = [() => {}, () => {}];
    const promise = new Promise<Reduction>((resolve, reject) => {
      options.signal?.addEventListener('abort', () => reject(new DOMException('aborted', 'AbortError')));
      finish = () => resolve({ mesh, ...result } as Reduction);
      fail = () => reject(new Error('It failed.'));
    });
    const told = (tell: () => void) => async () => {
      tell();
      await vi.advanceTimersByTimeAsync(0);
    };
    return { promise, run: { options, finish: told(finish), fail: told(fail) } };
  };
  const passed = checkpointOf(50, reportOf(0.125, 0.375));
  const session = new Session({
    inspect: async () => ({
      triangles: 1,
      vertices: 3,
      variables: ['position', 'pressure'].map((name) => {
        return { name, components: 1, extent: 100, magnitude: 100, constant: false };
      }),
      defects: noDefects,
    }),
    reduce: (_, options) => {
      const { promise, run } = running(options, { report: reportOf(0.9, 2.9), checkpoint: passed });
      runs.push(run);
      return promise;
    },
    resumeReduction: (checkpoint, options) => {
      const { promise, run } = running(options, { report: reportOf(1, 3) });
      drafts.push({ ...run, checkpoint });
      return promise;
    },
    read: async () => ({ mesh, notes: [], labels: { units: {}, componentNames: {} } }),
    fetchBytes: async () => new Uint8Array(),
  });
  vi.useFakeTimers();
  await session.openAddress('a.ply');
  return { session, runs, drafts, passed, rest: () => vi.advanceTimersByTimeAsync(100) };
}

describe('a session', () => {
  afterEach(() => {
    vi.useRealTimers();
  });

  async function reduced() {
    const all = await opened();
    await all.runs[0].finish();
    return all;
  }

  test('asks for the checkpoint, and does not keep it in the result', async () => {
    const { session, runs } = await reduced();
    expect(runs[0].options.checkpoint).toBe(true);
    expect(session.state.reduced?.result).not.toHaveProperty('checkpoint');
    expect(session.state.provisional).toBeNull();
  });

  test('answers from the checkpoint at once, marked as provisional, and from the original when the slider rests', async () => {
    const { session, runs, drafts, passed, rest } = await reduced();
    const { reduced: before } = session.state;
    session.setBound('pressure', { fraction: 0.04, free: false });
    expect(runs).toHaveLength(1);
    expect(drafts).toHaveLength(1);
    expect(drafts[0].checkpoint).toBe(passed);
    expect(drafts[0].options.bounds.pressure).toEqual({ relative: 0.04 });
    await drafts[0].finish();
    expect(session.state.provisional?.bounds).toBe(session.state.bounds);
    expect(session.state.reduced).toBe(before);
    expect(session.state.progress).toBe(0);
    expect(answerOf(session.state)).toBe(session.state.provisional);
    await rest();
    expect(runs).toHaveLength(2);
    expect(runs[1].options.bounds).toEqual({ position: { relative: 0.01 }, pressure: { relative: 0.04 } });
    expect(session.state.provisional).not.toBeNull();
    await runs[1].finish();
    expect(session.state).toMatchObject({ provisional: null, progress: null });
    expect(session.state.reduced?.bounds).toBe(session.state.bounds);
  });

  test('answers the newest bounds next, however many there were meanwhile, and reduces once', async () => {
    const { session, runs, drafts, rest } = await reduced();
    for (const fraction of [0.04, 0.041, 0.042, 0.043]) session.setBound('pressure', { fraction, free: false });
    await rest();
    expect(drafts).toHaveLength(1);
    expect(runs).toHaveLength(1);
    await drafts[0].finish();
    expect(session.state.provisional?.bounds.pressure.fraction).toBe(0.04);
    expect(drafts).toHaveLength(2);
    expect(drafts[1].options.bounds.pressure).toEqual({ relative: 0.043 });
    await drafts[1].finish();
    await rest();
    expect(drafts).toHaveLength(2);
    expect(runs).toHaveLength(2);
    expect(runs[1].options.bounds.pressure).toEqual({ relative: 0.043 });
  });

  test('gives up the reduction from the original where the slider moves on', async () => {
    const { session, runs, drafts, rest } = await reduced();
    session.setAllBounds(0.04);
    await drafts[0].finish();
    await rest();
    session.setAllBounds(0.041);
    expect(runs[1].options.signal?.aborted).toBe(true);
    expect(drafts).toHaveLength(2);
    await drafts[1].finish();
    await rest();
    expect(runs).toHaveLength(3);
  });

  test('reduces from the original alone where no checkpoint serves', async () => {
    const { session, runs, drafts } = await reduced();
    session.setAllBounds(0.003);
    expect(drafts).toHaveLength(0);
    expect(runs).toHaveLength(2);
  });

  test('does so, too, where an answer from a checkpoint fails', async () => {
    const { session, runs, drafts, rest } = await reduced();
    session.setAllBounds(0.04);
    await drafts[0].fail();
    expect(session.state).toMatchObject({ provisional: null, notices: [] });
    await rest();
    expect(runs).toHaveLength(2);
  });

  test('shows the last result again where it is cancelled, or fails', async () => {
    const { session, runs, drafts, rest } = await reduced();
    const { reduced: before } = session.state;
    session.setAllBounds(0.04);
    await drafts[0].finish();
    session.cancel();
    expect(session.state).toMatchObject({ provisional: null, progress: null, cancelled: true });
    await rest();
    expect(runs).toHaveLength(1);
    session.setAllBounds(0.05);
    await drafts[1].finish();
    await rest();
    await runs[1].fail();
    expect(session.state).toMatchObject({ provisional: null, progress: null });
    expect(answerOf(session.state)).toBe(before);
  });

  test('stops an answer that is under way where it is cancelled', async () => {
    const { session, runs, drafts, rest } = await reduced();
    session.setAllBounds(0.04);
    session.cancel();
    expect(drafts[0].options.signal?.aborted).toBe(true);
    await rest();
    expect(runs).toHaveLength(1);
    expect(session.state.provisional).toBeNull();
  });

  test('forgets checkpoints with the surface', async () => {
    const { session, runs, drafts } = await reduced();
    await session.openAddress('b.ply');
    session.setAllBounds(0.04);
    expect(drafts).toHaveLength(0);
    expect(runs[1].options.signal?.aborted).toBe(false);
  });

  test('asks for none where only the original can tell', async () => {
    const { session, runs, drafts } = await reduced();
    session.setMethod({ ...firstMethod, dropSmallComponents: true });
    expect(runs[1].options.checkpoint).toBe(false);
    session.setAllBounds(0.04);
    expect(drafts).toHaveLength(0);
  });

  test('gives an answer under way up where another method is wanted', async () => {
    const { session, runs, drafts } = await reduced();
    session.setAllBounds(0.04);
    session.setMethod({ ...firstMethod, refusePiercing: true });
    expect(drafts[0].options.signal?.aborted).toBe(true);
    expect(runs).toHaveLength(2);
  });

  test('answers from the checkpoint of a reduction that ends while the slider moves', async () => {
    const { session, runs, drafts } = await opened();
    session.setAllBounds(0.04);
    await runs[0].finish();
    expect(drafts).toHaveLength(1);
    expect(session.state.progress).toBe(0);
  });
});
