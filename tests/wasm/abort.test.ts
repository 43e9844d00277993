import { Worker } from 'node:worker_threads';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { reduce } from '../../wasm/index.ts';
import type { Answer } from '../../wasm/messages.ts';
import type { Ending } from '../../wasm/tasks.ts';
import { bumpyPlate } from './bumpy-plate.ts';

const bounds = { '*': { relative: 0.01 } };
const aborted = { name: 'AbortError', constructor: DOMException };

/** Large enough to be under way when the abort comes. */
const large = bumpyPlate(150);
const small = bumpyPlate(6);

/** Aborts at the first sign of progress. */
async function abortInFlight(): Promise<void> {
  const controller = new AbortController();
  const running = reduce(large, { bounds, signal: controller.signal, onProgress: () => controller.abort() });
  await expect(running).rejects.toMatchObject(aborted);
}

/** What a worker says when the task that it is at ends, which the caller of an aborted one is not told. */
function endingOf(worker: Worker): Promise<Ending> {
  return new Promise((resolve) => {
    worker.on('message', (answer: Answer) => 'ending' in answer && resolve(answer.ending));
  });
}

afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

describe('progress', () => {
  test('rises from 0 to 1 and never falls', async () => {
    const seen: number[] = [];
    await reduce(large, { bounds, onProgress: (progress) => seen.push(progress) });
    expect(seen.length).toBeGreaterThan(2);
    expect(seen).toEqual(seen.toSorted((a, b) => a - b));
    expect(seen[0]).toBeGreaterThanOrEqual(0);
    expect(seen.at(-1)).toBe(1);
  });
});

describe('abort', () => {
  test('a signal that was aborted before rejects', async () => {
    await expect(reduce(small, { bounds, signal: AbortSignal.abort() })).rejects.toMatchObject(aborted);
  });

  test('ends a running reduction through shared memory, and the worker goes on with the next', async () => {
    const posts = vi.spyOn(Worker.prototype, 'postMessage');
    await abortInFlight();
    const worker = posts.mock.contexts[0] as Worker;
    const { outcome } = await endingOf(worker);
    expect(outcome).toMatchObject({ ok: true, value: { report: { termination: 'cancelled' } } });
    await expect(reduce(small, { bounds })).resolves.toBeDefined();
    expect(new Set(posts.mock.contexts)).toEqual(new Set([worker]));
  });

  test('ends a running reduction where memory cannot be shared, with its worker', async () => {
    vi.stubGlobal('SharedArrayBuffer', undefined);
    const terminations = vi.spyOn(Worker.prototype, 'terminate');
    await abortInFlight();
    expect(terminations).toHaveBeenCalledOnce();
    await expect(reduce(small, { bounds })).resolves.toBeDefined();
  });

  test('takes only the call that was aborted out of the queue', async () => {
    const controller = new AbortController();
    const first = reduce(large, { bounds });
    const second = reduce(small, { bounds, signal: controller.signal });
    const third = reduce(small, { bounds });
    controller.abort();
    await expect(second).rejects.toMatchObject(aborted);
    await expect(Promise.all([first, third])).resolves.toHaveLength(2);
  });

  test('an abort after the end changes nothing', async () => {
    const controller = new AbortController();
    const reduction = await reduce(small, { bounds, signal: controller.signal });
    controller.abort();
    expect(reduction.report.termination).toBe('finished');
    await expect(reduce(small, { bounds })).resolves.toBeDefined();
  });

  test('no progress is told after an abort', async () => {
    const controller = new AbortController();
    let calls = 0;
    const onProgress = () => {
      calls++;
      controller.abort();
    };
    await expect(reduce(large, { bounds, signal: controller.signal, onProgress })).rejects.toMatchObject(aborted);
    await reduce(small, { bounds });
    expect(calls).toBe(1);
  });
});
