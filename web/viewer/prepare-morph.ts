import { fromAnyHost } from '../../workers/from-any-host.ts';
import type { Frame, Triangles } from './frame.ts';
import type { MorphArrays, MorphCorners, MorphEnd } from './morph-corners.ts';

/** A morph with the two surfaces that it leads between. */
export interface MorphSource {
  /** Three corners of the morph a triangle. */
  triangles: Uint32Array;
  finer: { end: MorphEnd; surface: Triangles };
  coarser: { end: MorphEnd; surface: Triangles };
}

/** One end of a morph, ready to draw, and where its corners lie on the surface there. */
export interface PreparedEnd {
  arrays: MorphArrays;
  at: MorphCorners;
}

export interface PreparedMorph {
  finer: PreparedEnd;
  coarser: PreparedEnd;
}

export interface PrepareMorphRequest {
  id: number;
  morph: MorphSource;
  frame: Frame;
}

export interface PrepareMorphAnswer {
  id: number;
  prepared: PreparedMorph;
}

/** Makes morphs ready to draw, in a worker that starts with the first. */
export class MorphPreparer {
  #worker: Worker | null = null;
  #waiting = new Map<number, (prepared: PreparedMorph) => void>();
  #lastId = 0;

  prepare({ triangles, finer, coarser }: MorphSource, frame: Frame): Promise<PreparedMorph> {
    const id = ++this.#lastId;
    // Nothing but what is asked for: a message copies all of it.
    const morph = { triangles, finer: plain(finer), coarser: plain(coarser) };
    this.#worker ??= this.#start();
    this.#worker.postMessage({ id, morph, frame } satisfies PrepareMorphRequest);
    return new Promise((resolve) => this.#waiting.set(id, resolve));
  }

  dispose(): void {
    this.#worker?.terminate();
    this.#waiting.clear();
  }

  #start(): Worker {
    const Worker = fromAnyHost(globalThis.Worker);
    const worker = new Worker(new URL('./prepare-morph.worker.ts', import.meta.url), { type: 'module' });
    worker.onmessage = ({ data }: MessageEvent<PrepareMorphAnswer>) => {
      this.#waiting.get(data.id)?.(data.prepared);
      this.#waiting.delete(data.id);
    };
    return worker;
  }
}

function plain({ end, surface }: MorphSource['finer']): MorphSource['finer'] {
  const { triangle, vertices, weights } = end;
  return {
    end: { triangle, vertices, weights },
    surface: { position: surface.position, triangles: surface.triangles },
  };
}
