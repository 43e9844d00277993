import { fromAnyHost } from '../../workers/from-any-host.ts';
import type { Frame, Triangles } from './frame.ts';
import type { SurfaceArrays } from './surface-arrays.ts';

export interface PrepareRequest {
  id: number;
  surface: Triangles;
  frame: Frame;
}

export interface PrepareAnswer {
  id: number;
  arrays: SurfaceArrays;
}

/** Makes surfaces ready to draw, in a worker, so that the page stays responsive however large they are. */
export class SurfacePreparer {
  #worker = startWorker();
  #waiting = new Map<number, (arrays: SurfaceArrays) => void>();
  #lastId = 0;

  constructor() {
    this.#worker.onmessage = ({ data }: MessageEvent<PrepareAnswer>) => {
      this.#waiting.get(data.id)?.(data.arrays);
      this.#waiting.delete(data.id);
    };
  }

  prepare(surface: Triangles, frame: Frame): Promise<SurfaceArrays> {
    const id = ++this.#lastId;
    const request: PrepareRequest = {
      id,
      surface: { position: surface.position, triangles: surface.triangles },
      frame,
    };
    this.#worker.postMessage(request);
    return new Promise((resolve) => this.#waiting.set(id, resolve));
  }

  dispose(): void {
    this.#worker.terminate();
    this.#waiting.clear();
  }
}

function startWorker(): Worker {
  const Worker = fromAnyHost(globalThis.Worker);
  return new Worker(new URL('./prepare.worker.ts', import.meta.url), { type: 'module' });
}
