import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Worker } from 'node:worker_threads';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { configure, Engine, reduce } from '../../wasm/index.ts';
import { bumpyPlate } from './bumpy-plate.ts';

const bounds = { '*': { relative: 0.01 } };
const small = bumpyPlate(6);
const large = bumpyPlate(150);
const disposed = { name: 'MeshboundError', code: 'disposed' };

afterEach(() => {
  vi.restoreAllMocks();
});

describe('engines', () => {
  test('work beside each other, each in a worker of its own, and give the same', async () => {
    const posts = vi.spyOn(Worker.prototype, 'postMessage');
    const engines = [new Engine(), new Engine()];
    const [one, other] = await Promise.all(engines.map((engine) => engine.reduce(small, { bounds })));
    expect(new Set(posts.mock.contexts).size).toBe(2);
    expect(one.mesh).toEqual(other.mesh);
    expect(one.mesh).toEqual((await reduce(small, { bounds })).mesh);
    for (const engine of engines) engine.dispose();
  });

  test('that are disposed of reject what runs, what waits and what comes later, and end their worker', async () => {
    const terminations = vi.spyOn(Worker.prototype, 'terminate');
    const engine = new Engine();
    const running = new Promise<void>((resolve, reject) => {
      engine.reduce(large, { bounds, onProgress: () => resolve() }).then(
        () => reject(new Error('too late')),
        () => {},
      );
    });
    await running;
    const first = engine.inspect(large);
    const second = engine.reduce(small, { bounds });
    engine.dispose();
    await expect(first).rejects.toMatchObject(disposed);
    await expect(second).rejects.toMatchObject(disposed);
    await expect(engine.reduce(small, { bounds })).rejects.toMatchObject(disposed);
    expect(terminations).toHaveBeenCalledOnce();
    engine.dispose();
  });

  test('load the module from where they are told', async () => {
    const folder = mkdtempSync(join(tmpdir(), 'meshbound-engine-'));
    const binary = join(folder, 'elsewhere.wasm');
    writeFileSync(binary, readFileSync('build/wasm/meshbound.wasm'));
    const engine = new Engine({ wasmUrl: binary });
    expect((await engine.reduce(small, { bounds })).mesh).toEqual((await reduce(small, { bounds })).mesh);
    engine.dispose();
    const lost = new Engine({ wasmUrl: join(folder, 'nowhere.wasm') });
    await expect(lost.inspect(small)).rejects.toThrow(/nowhere\.wasm/);
    lost.dispose();
  });

  test('tell of a worker that is not there', async () => {
    const engine = new Engine({ workerUrl: 'nowhere.mjs' });
    await expect(engine.inspect(small)).rejects.toMatchObject({ code: 'worker_failed' });
    engine.dispose();
  });

  test('that are shared take no settings once they have started', async () => {
    await reduce(small, { bounds });
    expect(() => configure({ threads: 2 })).toThrow(/before the first/);
  });
});

describe('options', () => {
  test('one sweep is not two, and both keep the bounds', async () => {
    const once = await reduce(large, { bounds, sweeps: [1] });
    const usual = await reduce(large, { bounds });
    const same = await reduce(large, { bounds, sweeps: [0.125, 1] });
    expect(same.mesh).toEqual(usual.mesh);
    expect(once.mesh).not.toEqual(usual.mesh);
    for (const { ratio } of once.report.variables) expect(ratio).toBeLessThanOrEqual(1);
  });

  test.each([[[]], [[0.5]], [[1, 0.5]], [[0, 1]], [[Number.NaN, 1]], [['much', 1]]])(
    'sweeps %j are refused',
    async (sweeps) => {
      const wrong = sweeps as number[];
      await expect(reduce(small, { bounds, sweeps: wrong })).rejects.toMatchObject({ code: 'bad_option' });
    },
  );

  test.each([0, -1, 1.5, 65, Number.NaN, 'two'])('%s threads are refused', async (threads) => {
    const wrong = threads as number;
    await expect(reduce(small, { bounds, threads: wrong })).rejects.toMatchObject({ code: 'bad_option' });
  });

  test('any number of threads gives the same', async () => {
    const [one, many] = [await reduce(small, { bounds, threads: 1 }), await reduce(small, { bounds, threads: 64 })];
    expect(one.mesh).toEqual(many.mesh);
  });
});
