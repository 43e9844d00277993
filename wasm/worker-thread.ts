import { fromAnyHost } from '../workers/from-any-host.ts';
import type { Answer, Request } from './messages.ts';

/** The caller's end of the line to a worker, the same in a browser and in Node. */
export interface WorkerThread {
  post(request: Request, transfer: ArrayBuffer[]): void;
  terminate(): void;
}

export interface WorkerEvents {
  onAnswer(answer: Answer): void;
  /** The worker could not start, or died. */
  onFailure(reason: string): void;
}

/** `address`: of the worker's script, if not beside this module. */
export function startWorker(address: string | undefined, events: WorkerEvents): WorkerThread {
  return typeof Worker === 'function' ? startInBrowser(address, events) : startInNode(address, events);
}

function startInBrowser(address: string | undefined, { onAnswer, onFailure }: WorkerEvents): WorkerThread {
  const Worker = fromAnyHost(globalThis.Worker);
  const worker =
    address === undefined
      ? new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' }) // as bundlers know it
      : new Worker(new URL(address), { type: 'module' });
  worker.addEventListener('message', ({ data }: MessageEvent<Answer>) => onAnswer(data));
  worker.addEventListener('error', (event) => onFailure(event.message ?? 'it could not be loaded'));
  return {
    post: (request, transfer) => worker.postMessage(request, transfer),
    terminate: () => worker.terminate(),
  };
}

function startInNode(address: string | undefined, { onAnswer, onFailure }: WorkerEvents): WorkerThread {
  const { Worker: NodeWorker } = process.getBuiltinModule('node:worker_threads');
  const worker = new NodeWorker(new URL(/* @vite-ignore */ address ?? './worker.node.mjs', import.meta.url));
  worker.on('message', (answer: Answer) => {
    if ('ending' in answer) {
      worker.unref();
    }
    onAnswer(answer);
  });
  worker.on('error', (error) => onFailure(String(error)));
  // An idle worker must not keep the process alive; a busy one must.
  worker.unref();
  return {
    post: (request, transfer) => {
      worker.ref();
      worker.postMessage(request, transfer);
    },
    terminate: () => void worker.terminate(),
  };
}
