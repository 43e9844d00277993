import type { Answer, Request } from './messages.ts';

/** The worker's end of its line to the thread that started it, the same in a browser and in Node. */
export interface ParentPort {
  post(answer: Answer, transfer?: ArrayBuffer[]): void;
  onRequest(handle: (request: Request) => void): void;
}

export function parentPort(): ParentPort {
  if ('WorkerGlobalScope' in globalThis) {
    return {
      post: (answer, transfer = []) => self.postMessage(answer, { transfer }),
      onRequest: (handle) => self.addEventListener('message', ({ data }: MessageEvent<Request>) => handle(data)),
    };
  }
  const port = process.getBuiltinModule('node:worker_threads').parentPort;
  if (!port) {
    throw new Error('This module runs in a worker.');
  }
  return {
    post: (answer, transfer = []) => port.postMessage(answer, transfer),
    onRequest: (handle) => port.on('message', handle),
  };
}
