import { describe, expect, test, vi } from 'vitest';
import type { Mesh, ReduceOptions, Reduction } from '../../wasm/types.ts';
import { type Keeping, nothingKept } from '../../web/session/constraints/keeping.ts';
import type { OpenedFile } from '../../web/session/reading/read.ts';
import type { Services } from '../../web/session/services.ts';
import { Session } from '../../web/session/session.ts';
import { standingOf } from '../../web/session/session-state.ts';

function meshWith(...names: string[]): Mesh {
  const variables = names.map((name) => ({ name, components: 1, values: new Float32Array(3) }));
  return { position: new Float32Array(9), triangles: new Uint32Array([0, 1, 2]), variables };
}

function fileWith(mesh: Mesh): OpenedFile {
  return { mesh, notes: [], labels: { units: {}, componentNames: {} } };
}

const inspect: Services['inspect'] = async ({ variables }) => ({
  triangles: 1,
  vertices: 3,
  variables: ['position', ...variables.map(({ name }) => name)].map((name) => ({
    name,
    components: 1,
    extent: 1,
    magnitude: 1,
    constant: false,
  })),
  defects: {
    repeatedVertexTriangles: 0,
    zeroAreaTriangles: 0,
    unusedVertices: 2,
    flippedTriangles: 0,
    unorientableComponents: 0,
    copiedTriangles: 0,
    twoSidedTriangles: 0,
  },
});

/** A reduction that ends when the test says so. */
interface Run {
  mesh: Mesh;
  options: ReduceOptions;
  finish(): void;
  fail(error: Error): void;
}

function setUp(overrides: Partial<Services> = {}) {
  const runs: Run[] = [];
  const services: Services = {
    inspect,
    reduce: (mesh, options) =>
      new Promise((resolve, reject) => {
        options.signal?.addEventListener('abort', () => reject(new DOMException('aborted', 'AbortError')));
        runs.push({ mesh, options, finish: () => resolve({ mesh } as Reduction), fail: reject });
      }),
    resumeReduction: async () => {
      throw new Error('Nothing gave a checkpoint.');
    },
    read: async () => fileWith(meshWith('pressure')),
    fetchBytes: async () => new Uint8Array(),
    ...overrides,
  };
  return { session: new Session(services), runs };
}

const file = (name: string) => new File(['bytes'], name);
const settled = () => new Promise((resolve) => setTimeout(resolve, 100));
const texts = (session: Session) => session.state.notices.map(({ text }) => text);

describe('opening', () => {
  test('reduces at the first bounds and keeps the result', async () => {
    const { session, runs } = setUp();
    await session.openFile(file('a.ply'));
    expect(runs).toHaveLength(1);
    expect(runs[0].options.bounds).toEqual({ position: { relative: 0.01 }, pressure: { relative: 0.03 } });
    runs[0].finish();
    await settled();
    expect(session.state.reduced?.result.mesh).toBe(session.state.surface?.mesh);
    expect(session.state.progress).toBeNull();
  });

  test('says what is odd about the surface', async () => {
    const { session } = setUp();
    await session.openFile(file('a.ply'));
    expect(texts(session)).toEqual(['2 vertices belong to no triangle: left out of the result.']);
  });

  test('a file that cannot be read leaves everything as it was, and says why', async () => {
    const read = vi.fn<Services['read']>();
    read.mockResolvedValueOnce(fileWith(meshWith('pressure'))).mockRejectedValueOnce(new Error('The file is empty.'));
    const { session, runs } = setUp({ read });
    await session.openFile(file('good.ply'));
    runs[0].finish();
    await settled();
    const { surface, reduced, bounds } = session.state;
    await session.openFile(file('bad.ply'));
    expect(session.state).toMatchObject({
      opening: null,
      notices: [{ kind: 'error', text: 'bad.ply: The file is empty.' }],
    });
    expect(session.state.surface).toBe(surface);
    expect(session.state.reduced).toBe(reduced);
    expect(session.state.bounds).toBe(bounds);
  });

  test('of two files the one that was chosen last stays', async () => {
    const slow = meshWith('slow');
    const fast = meshWith('fast');
    const read: Services['read'] = async (name) => {
      if (name === 'slow.ply') await settled();
      return fileWith(name === 'slow.ply' ? slow : fast);
    };
    const { session } = setUp({ read });
    await Promise.all([session.openFile(file('slow.ply')), session.openFile(file('fast.ply'))]);
    expect(session.state.surface?.mesh).toBe(fast);
    expect(session.state.opening).toBeNull();
  });

  test('a crack is closed by reading again, with the bounds as they are', async () => {
    const crack = { note: 'A crack: 2 points.', weld: 1e-6 };
    const read = vi.fn<Services['read']>(async () => ({ ...fileWith(meshWith('pressure')), crack }));
    const { session } = setUp({ read });
    await session.openFile(file('a.ply'));
    session.setBound('pressure', { fraction: 0.2, free: false });
    const [notice] = session.state.notices.filter(({ text }) => text === crack.note);
    expect(notice.remedy?.label).toBe('Join them');
    notice.remedy?.take();
    await settled();
    expect(read.mock.lastCall?.[4]).toEqual({ weld: 1e-6 });
    expect(session.state.bounds.pressure).toMatchObject({ fraction: 0.2 });
  });

  describe('a variable that is no number somewhere', () => {
    const nonFinite = { vertices: 2, first: 1 };
    const withHoles: Services['inspect'] = async (mesh) => {
      const { variables, ...rest } = await inspect(mesh);
      return { ...rest, variables: variables.map((each) => (each.name === 'sst' ? { ...each, nonFinite } : each)) };
    };
    const read: Services['read'] = async () => fileWith(meshWith('sst', 'pressure'));

    async function opened() {
      const { session, runs } = setUp({ inspect: withHoles, read });
      await session.openFile(file('a.ply'));
      const notices = session.state.notices.filter(({ text }) => text.includes('“sst”'));
      return { session, runs, notices };
    }

    test('starts free, which one note says, with what may be done', async () => {
      const { session, runs, notices } = await opened();
      expect(runs[0].options.bounds).toMatchObject({ sst: 'free', pressure: { relative: 0.03 } });
      expect(notices).toMatchObject([{ kind: 'note', remedy: { label: 'Leave out “sst”' } }]);
      expect(notices[0].text).toContain('holds NaN or infinity (at 2 points, the first of which is 1)');
      expect(texts(session).join()).not.toContain('“pressure”');
    });

    test('can be left out', async () => {
      const { session, notices } = await opened();
      notices[0].remedy?.take();
      await settled();
      expect(session.state.surface?.mesh.variables.map(({ name }) => name)).toEqual(['pressure']);
      expect(texts(session)).toContain('The variable “sst” was left out.');
      expect(texts(session).join()).not.toContain('NaN');
    });

    test('takes no other bounds with it when it is left out', async () => {
      const { session, notices } = await opened();
      session.setBound('pressure', { fraction: 0.2, free: false });
      notices[0].remedy?.take();
      await settled();
      expect(session.state.bounds).toMatchObject({ pressure: { fraction: 0.2, free: false } });
      expect(session.state.bounds).not.toHaveProperty('sst');
    });

    test('is refused by the core where it gets a bound, which is said; without it, all is well again', async () => {
      const { session, runs } = await opened();
      runs[0].finish();
      await settled();
      const refusal = Object.assign(new Error('“sst” can have no bound.'), { code: 'non_finite_value' });
      session.setBound('sst', { fraction: 0.1, free: false });
      runs[1].fail(refusal);
      await settled();
      expect(session.state).toMatchObject({
        refusal: '“sst” can have no bound.',
        reduced: { bounds: { sst: { free: true } } },
      });
      session.setBound('sst', { fraction: 0.1, free: true });
      runs[2].finish();
      await settled();
      expect(standingOf(session.state)).toBe('asked');
      expect(texts(session)).not.toContain('“sst” can have no bound.');
    });
  });
});

describe('changing a bound', () => {
  async function opened() {
    const { session, runs } = setUp();
    await session.openFile(file('a.ply'));
    return { session, runs };
  }

  test('starts a reduction at once where none runs', async () => {
    const { session, runs } = await opened();
    runs[0].finish();
    await settled();
    session.setBound('pressure', { fraction: 0.1, free: false });
    expect(runs).toHaveLength(2);
  });

  test('aborts the running reduction once the slider rests, and starts one with the new bound', async () => {
    const { session, runs } = await opened();
    session.setBound('pressure', { fraction: 0.1, free: false });
    expect(runs[0].options.signal?.aborted).toBe(false);
    await settled();
    expect(runs[0].options.signal?.aborted).toBe(true);
    expect(runs).toHaveLength(2);
    expect(runs[1].options.bounds.pressure).toEqual({ relative: 0.1 });
  });

  test('many changes in a row start one reduction, with the last of them', async () => {
    const { session, runs } = await opened();
    for (const fraction of [0.04, 0.05, 0.06]) session.setBound('pressure', { fraction, free: false });
    await settled();
    expect(runs).toHaveLength(2);
    expect(runs[1].options.bounds.pressure).toEqual({ relative: 0.06 });
  });

  test('moving all, there and back, changes no proportion', async () => {
    const { session } = await opened();
    const { bounds } = session.state;
    for (const fraction of [0.0731, 0.00117, 0.2, 0.0003, 0.03]) session.setAllBounds(fraction);
    expect(session.state.bounds).toEqual(bounds);
  });

  test('what a reduction gives while the slider moves is shown as not the last, and the next one starts', async () => {
    const { session, runs } = await opened();
    session.setAllBounds(0.1);
    runs[0].finish();
    await vi.waitFor(() => expect(runs).toHaveLength(2));
    expect(session.state.reduced).not.toBeNull();
    expect(session.state.progress).toBe(0);
    expect(runs[1].options.bounds.pressure).toEqual({ relative: 0.1 });
    runs[1].finish();
    await settled();
    expect(runs).toHaveLength(2);
    expect(session.state.progress).toBeNull();
  });

  test('a reduction that fails while the slider moves makes room for the next one', async () => {
    const { session, runs } = await opened();
    session.setAllBounds(0.1);
    runs[0].fail(new Error('The bound is too fine.'));
    await vi.waitFor(() => expect(runs).toHaveLength(2));
    expect(session.state.progress).toBe(0);
    expect(texts(session)).not.toContain('The bound is too fine.');
  });

  test('the outcome of an aborted reduction is never shown', async () => {
    const { session, runs } = await opened();
    session.setAllBounds(0.1);
    await settled();
    runs[0].finish();
    await settled();
    expect(session.state.reduced).toBeNull();
    runs[0].options.onProgress?.(0.9);
    expect(session.state.progress).toBe(0);
  });

  test('a bound that the reduction refuses leaves the last result', async () => {
    const { session, runs } = await opened();
    runs[0].finish();
    await settled();
    const { reduced } = session.state;
    session.setBound('pressure', { fraction: 1e-30, free: false });
    await settled();
    runs[1].fail(new Error('The bound is too fine.'));
    await settled();
    expect(session.state.reduced).toBe(reduced);
    expect(session.state.progress).toBeNull();
    expect(texts(session)).toContain('The bound is too fine.');
  });

  test('a fault of a reduction goes when the next one starts, and nothing else does', async () => {
    const { session, runs } = await opened();
    session.report(new Error('Not saved.'));
    runs[0].fail(new Error('The bound is too fine.'));
    await settled();
    expect(texts(session)).toContain('The bound is too fine.');
    session.setBound('pressure', { fraction: 0.05, free: false });
    await settled();
    expect(texts(session)).toEqual(['2 vertices belong to no triangle: left out of the result.', 'Not saved.']);
  });

  test('a notice goes when it is dismissed', async () => {
    const { session } = await opened();
    session.dismiss(session.state.notices[0].id);
    expect(session.state.notices).toEqual([]);
  });
});

describe('the method', () => {
  const anotherMethod = {
    errors: 'propagated',
    cost: 'maximum',
    refusePiercing: true,
    limitToFeatureSize: true,
    dropSmallComponents: true,
  } as const;

  test('is tracked at first, and another one starts a reduction', async () => {
    const { session, runs } = setUp();
    await session.openFile(file('a.ply'));
    expect(runs[0].options).toMatchObject({ errors: 'tracked' });
    session.setMethod(anotherMethod);
    expect(runs[0].options.signal?.aborted).toBe(true);
    await settled();
    expect(runs[1].options).toMatchObject({
      errors: 'propagated',
      cost: 'maximum',
      refusePiercing: true,
      limitToFeatureSize: true,
    });
  });

  test('stays when another surface is opened', async () => {
    const { session, runs } = setUp();
    session.setMethod(anotherMethod);
    await session.openFile(file('a.ply'));
    expect(runs).toHaveLength(1);
    expect(runs[0].options).toMatchObject({
      errors: 'propagated',
      cost: 'maximum',
      refusePiercing: true,
      limitToFeatureSize: true,
    });
  });
});

describe('what is kept', () => {
  const box = { lowest: [0, 0, 0], highest: [1, 1, 1] } as const;
  const keeping: Keeping = { ...nothingKept, lockBox: { lowest: [...box.lowest], highest: [...box.highest] } };

  test('starts a reduction where it is another, and is told with its result', async () => {
    const { session, runs } = setUp();
    await session.openFile(file('a.ply'));
    session.setKeeping({ ...nothingKept });
    expect(runs).toHaveLength(1);
    session.setKeeping(keeping);
    await settled();
    expect(runs).toHaveLength(2);
    expect(runs[0].options.signal?.aborted).toBe(true);
    expect(runs[1].options.lockedBoxes).toEqual([box]);
    runs[1].finish();
    await settled();
    expect(session.state.reduced?.keeping).toBe(keeping);
  });

  test('waits for a surface that is being opened, and holds for the one before where that fails', async () => {
    const read = vi.fn<Services['read']>(async () => fileWith(meshWith('pressure')));
    const { session, runs } = setUp({ read });
    await session.openFile(file('a.ply'));
    runs[0].finish();
    await settled();
    const opening = session.openFile(file('b.ply'));
    session.setKeeping(keeping);
    expect(runs).toHaveLength(1);
    await opening;
    expect(runs).toHaveLength(2);
    expect(runs[1].options.lockedBoxes).toEqual([box]);
    runs[1].finish();
    await settled();
    read.mockRejectedValue(new Error('broken'));
    const failing = session.openFile(file('c.ply'));
    session.setKeeping(nothingKept);
    await failing;
    await settled();
    expect(runs).toHaveLength(3);
    expect(runs[2].options.lockedBoxes).toEqual([]);
  });

  test('is refused where the surface has not what it names, and a reduction that runs ends', async () => {
    const { session, runs } = setUp();
    await session.openFile(file('a.ply'));
    session.setKeeping({ ...nothingKept, regions: 'material' });
    await settled();
    expect(runs[0].options.signal?.aborted).toBe(true);
    expect(runs).toHaveLength(1);
    expect(session.state.progress).toBeNull();
    expect(session.state.notices.at(-1)).toMatchObject({ kind: 'error', code: 'unknown_regions', ofReduction: true });
  });

  test('takes the notice about cell data away once some of them part the surface into regions', async () => {
    const regions = new Map(['material', 'part'].map((name) => [name, Int32Array.of(1)]));
    const { session } = setUp({ read: async () => ({ ...fileWith(meshWith('pressure')), regions }) });
    await session.openFile(file('a.vtp'));
    const notice = (names: string) => expect.stringContaining(`Cell data ${names} can part the surface into regions`);
    expect(texts(session)).toContainEqual(notice('“material”, “part”'));
    const others = texts(session).length - 1;
    session.setKeeping({ ...nothingKept, lockRegions: [1] });
    expect(texts(session)).toContainEqual(notice('“material”, “part”'));
    session.setKeeping({ ...nothingKept, regions: 'material' });
    expect(texts(session)).not.toContainEqual(expect.stringContaining('Cell data'));
    expect(texts(session)).toHaveLength(others);
    // Of the next file it names what is not chosen.
    await session.openFile(file('b.vtp'));
    expect(texts(session)).toContainEqual(notice('“part”'));
  });
});

describe('cancelling', () => {
  test('ends the reduction and leaves the last result', async () => {
    const { session, runs } = setUp();
    await session.openFile(file('a.ply'));
    runs[0].finish();
    await settled();
    const { reduced } = session.state;
    session.setAllBounds(0.1);
    await settled();
    session.cancel();
    expect(runs[1].options.signal?.aborted).toBe(true);
    await settled();
    expect(session.state).toMatchObject({ progress: null, cancelled: true, notices: [{ kind: 'note' }] });
    expect(session.state.reduced).toBe(reduced);
  });

  test('ends one that has not started yet', async () => {
    const { session, runs } = setUp();
    await session.openFile(file('a.ply'));
    session.setAllBounds(0.1);
    session.cancel();
    await settled();
    expect(runs).toHaveLength(1);
  });

  test('is over when the reduction is asked for again', async () => {
    const { session, runs } = setUp();
    await session.openFile(file('a.ply'));
    session.cancel();
    session.reduceAgain();
    expect(session.state).toMatchObject({ progress: 0, cancelled: false });
    await settled();
    runs[1].finish();
    await settled();
    expect(session.state.reduced).not.toBeNull();
  });

  test('means nothing where nothing runs', () => {
    const { session } = setUp();
    session.cancel();
    expect(session.state.cancelled).toBe(false);
  });
});

test('vertices that a reader wants to stay are locked', async () => {
  const locked = Uint32Array.of(1);
  const { session, runs } = setUp({ read: async () => ({ ...fileWith(meshWith('pressure')), locked }) });
  await session.openFile(file('touching.glb'));
  expect(runs[0].options.locked).toBe(locked);
});

function errorsOf({ state }: Session): string[] {
  return state.notices.filter(({ kind }) => kind === 'error').map(({ text }) => text);
}

describe('what is shown and what is asked for', () => {
  test('a refused bound leaves the result before, which is said to be none of what is asked for', async () => {
    const { session, runs } = setUp();
    await session.openAddress('a.ply');
    runs[0].finish();
    await vi.waitFor(() => expect(session.state.reduced).not.toBeNull());
    expect(standingOf(session.state)).toBe('asked');
    session.setBound('pressure', { fraction: 1e-9, free: false });
    expect(standingOf(session.state)).toBe('running');
    runs[1].fail(new Error('It is too fine.'));
    await vi.waitFor(() => expect(session.state.progress).toBeNull());
    for (const { id } of session.state.notices) session.dismiss(id);
    expect(standingOf(session.state)).toBe('refused');
    expect(session.state.refusal).toBe('It is too fine.');
    expect(session.state.reduced?.bounds).not.toBe(session.state.bounds);
    session.setBound('pressure', { fraction: 0.05, free: false });
    expect(session.state.refusal).toBeNull();
    runs[2].finish();
    await vi.waitFor(() => expect(standingOf(session.state)).toBe('asked'));
  });

  test('a cancelled one likewise', async () => {
    const { session, runs } = setUp();
    await session.openAddress('a.ply');
    runs[0].finish();
    await vi.waitFor(() => expect(session.state.progress).toBeNull());
    session.setBound('pressure', { fraction: 0.5, free: false });
    session.cancel();
    expect(standingOf(session.state)).toBe('cancelled');
    session.undo();
    expect(standingOf(session.state)).not.toBe('cancelled');
  });

  test('each try of the same is one message, gone when its cause is gone', async () => {
    const { session, runs } = setUp();
    await session.openAddress('a.ply');
    runs[0].finish();
    await vi.waitFor(() => expect(session.state.progress).toBeNull());
    for (const fraction of [1e-9, 1e-10, 1e-11]) {
      session.setBound('pressure', { fraction, free: false });
      runs[runs.length - 1].fail(new Error(`It is too fine: ${fraction}.`));
      await vi.waitFor(() => expect(session.state.progress).toBeNull());
    }
    expect(errorsOf(session)).toEqual(['It is too fine: 1e-11.']);
    for (let time = 0; time < 3; time++) session.report('It cannot be copied.');
    expect(errorsOf(session)).toHaveLength(2);
    session.setBound('pressure', { fraction: 0.1, free: false });
    expect(errorsOf(session)).toEqual(['It cannot be copied.']);
  });
});

describe('bounds that are no bounds of the surface', () => {
  test('are refused: nothing is reduced, and the surface is there', async () => {
    const { session, runs } = setUp();
    session.wantBounds({ posit: { relative: 0.01 } });
    await session.openAddress('a.ply');
    expect(runs).toHaveLength(0);
    expect(session.state.surface?.name).toBe('a.ply');
    expect(session.state).toMatchObject({ progress: null, reduced: null });
    expect(session.state.refusal).toContain('“posit”');
    session.reduceAgain();
    expect(runs).toHaveLength(0);
    session.wantBounds({ position: { relative: 0.01 } });
    expect(runs).toHaveLength(1);
    expect(session.state.refusal).toBeNull();
    expect(errorsOf(session)).toEqual([]);
  });

  test('of one surface may be those of the next', async () => {
    const read = vi.fn(async () => fileWith(meshWith('pressure')));
    const { session, runs } = setUp({ read });
    session.wantBounds({ heat: { relative: 0.01 }, position: { relative: 0.01 } });
    await session.openAddress('a.ply');
    expect(runs).toHaveLength(0);
    read.mockResolvedValue(fileWith(meshWith('heat')));
    await session.openAddress('b.ply');
    expect(runs).toHaveLength(1);
    expect(session.state.refusal).toBeNull();
    expect(errorsOf(session)).toEqual([]);
  });

  test('make room for those that the user chooses', async () => {
    const { session, runs } = setUp();
    session.setFault('bounds', new Error('“one” is not a number.'));
    await session.openAddress('a.ply');
    expect(runs).toHaveLength(0);
    session.setBound('pressure', { fraction: 0.1, free: false });
    expect(runs).toHaveLength(1);
    expect(errorsOf(session)).toEqual([]);
  });

  test('stop what runs, and leave what was reduced before', async () => {
    const { session, runs } = setUp();
    await session.openAddress('a.ply');
    runs[0].finish();
    await vi.waitFor(() => expect(session.state.progress).toBeNull());
    const { reduced } = session.state;
    session.setFault('keeping', new Error('lock-points cannot be “x”.'));
    session.setMethod({ ...session.state.method, refusePiercing: true });
    expect(runs).toHaveLength(1);
    expect(session.state).toMatchObject({ reduced, progress: null });
    expect(standingOf(session.state)).toBe('refused');
    session.setFault('keeping', null);
    expect(runs).toHaveLength(2);
  });
});
