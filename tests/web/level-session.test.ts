import { describe, expect, test, vi } from 'vitest';
import type { Levels, LevelsOptions, Mesh, Reduction } from '../../wasm/types.ts';
import { coarser, LevelSession } from '../../web/session/reducing/level-session.ts';
import { Session } from '../../web/session/session.ts';
import type { Reduced } from '../../web/session/session-state.ts';
import { noDefects } from './no-defects.ts';

const mesh: Mesh = {
  position: new Float32Array(9),
  triangles: Uint32Array.of(0, 1, 2),
  variables: [{ name: 'pressure', components: 1, values: new Float32Array(3) }],
};
const variables = ['position', 'pressure'].map((name) => ({
  name,
  components: 1,
  extent: 1,
  magnitude: 1,
  constant: false,
}));

interface Call {
  options: LevelsOptions;
  finish(): void;
  fail(error: Error): void;
}

/** A session with a surface that reduces at once, and levels that are made when the test says so. */
async function setUp() {
  const session = new Session({
    inspect: async () => ({
      triangles: 1,
      vertices: 3,
      variables,
      defects: noDefects,
    }),
    reduce: async () => ({ mesh }) as Reduction,
    resumeReduction: async () => ({ mesh }) as Reduction,
    read: async () => ({ mesh, notes: [], labels: { units: {}, componentNames: {} } }),
    fetchBytes: async () => new Uint8Array(),
  });
  const calls: Call[] = [];
  const levels = new LevelSession(
    session,
    (_, options) =>
      new Promise((resolve, reject) => {
        options.signal?.addEventListener('abort', () => reject(new DOMException('aborted', 'AbortError')));
        const nested = { levels: options.levels.map(() => ({ mesh }) as Reduction), morphs: [] } as Levels;
        calls.push({ options, finish: () => resolve(nested), fail: reject });
      }),
  );
  await session.openFile(new File(['bytes'], 'a.ply'));
  await vi.waitFor(() => expect(session.state.reduced).not.toBeNull());
  return { session, levels, calls };
}

describe('levels of detail', () => {
  test('are made only when they are asked for, from the bounds of the result up', async () => {
    const { levels, calls } = await setUp();
    expect(calls).toHaveLength(0);
    levels.setCount(3);
    expect(calls[0].options.levels).toEqual([
      { position: { relative: 0.01 }, pressure: { relative: 0.03 } },
      { position: { relative: 0.02 }, pressure: { relative: 0.06 } },
      { position: { relative: 0.04 }, pressure: { relative: 0.12 } },
    ]);
    expect(calls[0].options).toMatchObject({ morphs: true, errors: 'tracked' });
    expect(levels.state).toMatchObject({ nested: null, progress: 0, position: 1 });
    calls[0].finish();
    await vi.waitFor(() => expect(levels.state.nested).not.toBeNull());
    expect(levels.state).toMatchObject({ progress: null, count: 3 });
    expect(levels.state.results).toHaveLength(3);
  });

  test('are made anew of every new result, and dropped until then', async () => {
    const { session, levels, calls } = await setUp();
    levels.setCount(2);
    calls[0].finish();
    await vi.waitFor(() => expect(levels.state.nested).not.toBeNull());
    session.setBound('position', { fraction: 0.1, free: false });
    await vi.waitFor(() => expect(calls).toHaveLength(2));
    expect(levels.state).toMatchObject({ nested: null, results: [] });
    expect(calls[1].options.levels[1].position).toEqual({ relative: 0.2 });
  });

  test('of earlier bounds are given up', async () => {
    const { levels, calls } = await setUp();
    levels.setCount(2);
    levels.setCount(4);
    expect(calls[0].options.signal?.aborted).toBe(true);
    calls[1].finish();
    await vi.waitFor(() => expect(levels.state.results).toHaveLength(4));
    levels.setCount(0);
    expect(levels.state).toMatchObject({ nested: null, progress: null });
    expect(calls).toHaveLength(2);
  });

  test('that cannot be made are told of', async () => {
    const { session, levels, calls } = await setUp();
    levels.setCount(2);
    calls[0].fail(new Error('No room.'));
    await vi.waitFor(() => expect(session.state.notices.map(({ text }) => text)).toEqual(['No room.']));
    expect(levels.state).toMatchObject({ nested: null, progress: null });
  });

  test('are shown at a position; what is saved is the level there or the next coarser one', async () => {
    const { levels, calls } = await setUp();
    expect(levels.shown).toBeNull();
    levels.setCount(3);
    calls[0].finish();
    await vi.waitFor(() => expect(levels.state.nested).not.toBeNull());
    for (const [position, level] of [
      [0, 1],
      [0.5, 1],
      [1, 1],
      [1.01, 2],
      [3, 3],
      [9, 3],
    ]) {
      levels.setPosition(position);
      expect(levels.shown).toBe(levels.state.results[level - 1]);
    }
    levels.setPosition(-1);
    expect(levels.state.position).toBe(0);
  });
});

test('a level chosen by its size on screen is the user’s own again once the slider moves', async () => {
  const { levels, calls } = await setUp();
  levels.setCount(3);
  calls[0].finish();
  await vi.waitFor(() => expect(levels.state.nested).not.toBeNull());
  levels.setPixels(2);
  levels.arriveAt(2.5);
  expect(levels.state).toMatchObject({ pixels: 2, position: 2.5 });
  levels.setPosition(1);
  expect(levels.state).toMatchObject({ pixels: null, position: 1 });
});

test('coarser bounds stay free where they are free', () => {
  const bounds = { position: { fraction: 0.01, free: false }, p: { fraction: 0.03, free: true } };
  expect(coarser(bounds, 4).position.fraction).toBe(0.04);
  expect(coarser(bounds, 4).p.free).toBe(true);
  expect(coarser({ position: { fraction: 0.01, free: true } }, 2).position.free).toBe(true);
});

test('levels are those of no provisional answer: they go with it, and come with what takes its place', () => {
  const bounds = { position: { fraction: 0.01, free: false } };
  const reduced = { result: { mesh }, bounds } as unknown as Reduced;
  const session = Object.assign(new EventTarget(), {
    state: { surface: { mesh }, reduced, provisional: null as Reduced | null },
    report: vi.fn(),
    forget: vi.fn(),
  });
  const made = vi.fn(() => new Promise<Levels>(() => {}));
  const levels = new LevelSession(session as unknown as Session, made);
  const become = (change: Partial<typeof session.state>) => {
    session.state = { ...session.state, ...change };
    session.dispatchEvent(new Event('change'));
  };
  become({ reduced: { ...reduced } });
  levels.setCount(2);
  expect(levels.state.progress).toBe(0);
  become({ provisional: { ...reduced } });
  expect(levels.state).toMatchObject({ nested: null, progress: null });
  become({ provisional: null });
  expect(levels.state.progress).toBe(0);
});

test('where no variable has a bound there are no levels, and that is said instead of a fault', async () => {
  const { session, levels } = await setUp();
  session.setBounds({ '*': 'free' });
  await vi.waitFor(() => expect(session.state.progress).toBeNull());
  levels.setCount(3);
  expect(levels.state).toMatchObject({ unbounded: true, nested: null, progress: null });
  expect(session.state.notices).toEqual([]);
  session.setBounds({ position: { relative: 0.01 } });
  await vi.waitFor(() => expect(levels.state).toMatchObject({ unbounded: false, progress: 0 }));
});
