import { checkMap, checkMesh, checkNumbers, checkValues, checkVertices, copyMap, copyMesh } from './copy-mesh.ts';
import type { Inspection } from './inspection.ts';
import { TaskQueue } from './task-queue.ts';
import type {
  Checkpoint,
  Levels,
  LevelsOptions,
  Mesh,
  ReduceOptions,
  Reduction,
  ResumeOptions,
  Segmentation,
  Verdict,
  VerifyOptions,
} from './types.ts';

/** How an engine starts its worker, and what that loads. Addresses are relative to the document, in Node to the folder it runs in. */
export interface EngineSettings {
  /** Where the worker's script lies, if not beside this package. */
  workerUrl?: string | URL;
  /** Where the binary of the module lies, if not beside the worker: that of the module without threads. */
  wasmUrl?: string | URL;
  /** Where the binary of the judge's module lies, if not beside the worker; loaded by the first `verify`. */
  judgeUrl?: string | URL;
  /** How many threads the worker may share its work with, itself among them, in a page that is isolated from other origins. */
  threads?: number;
}

function absolute(address: string | URL | undefined): string | undefined {
  if (address === undefined) return undefined;
  const base = globalThis.document?.baseURI ?? globalThis.location?.href ?? `file://${process.cwd()}/`;
  return new URL(address, base).href;
}

/**
 * A worker with the WebAssembly module, and the queue of what it is asked: one task runs at a time. It starts with the first
 * task. Several engines work beside each other; the functions of this package share one.
 *
 *     const engine = new Engine({ threads: 2 });
 *     const reduction = await engine.reduce(mesh, { bounds });
 *     engine.dispose();
 */
export class Engine {
  private readonly queue: TaskQueue;

  constructor({ workerUrl, wasmUrl, judgeUrl, threads }: EngineSettings = {}) {
    this.queue = new TaskQueue({
      workerUrl: absolute(workerUrl),
      wasmUrl: absolute(wasmUrl),
      judgeUrl: absolute(judgeUrl),
      threads,
    });
  }

  /** As the function `reduce`. */
  async reduce(mesh: Mesh, options: ReduceOptions): Promise<Reduction> {
    const { signal, onProgress, locked, transfer, ...rest } = options;
    checkMesh(mesh);
    const input = { mesh: transfer ? mesh : copyMesh(mesh), options: { ...rest, locked: locked?.slice() } };
    return this.queue.run({ kind: 'reduce', input }, { signal, onProgress });
  }

  /** As the function `resumeReduction`. */
  async resumeReduction(checkpoint: Checkpoint, options: ResumeOptions): Promise<Reduction> {
    const { signal, onProgress, locked, ...rest } = options;
    const { mesh, vertices, report } = checkpoint;
    checkMesh(mesh);
    checkVertices(vertices);
    const input = {
      checkpoint: { mesh: copyMesh(mesh), vertices: vertices.slice(), report },
      options: { ...rest, locked: locked?.slice() },
    };
    return this.queue.run({ kind: 'resumeReduction', input }, { signal, onProgress });
  }

  /** As the function `reduceLevels`. */
  async reduceLevels(mesh: Mesh, options: LevelsOptions): Promise<Levels> {
    const { signal, onProgress, locked, transfer, ...rest } = options;
    checkMesh(mesh);
    const input = { mesh: transfer ? mesh : copyMesh(mesh), options: { ...rest, locked: locked?.slice() } };
    return this.queue.run({ kind: 'reduceLevels', input }, { signal, onProgress });
  }

  /** As the function `segment`. */
  async segment(
    mesh: Mesh,
    { mesh: reduced, vertices, map }: Reduction,
    { signal }: { signal?: AbortSignal } = {},
  ): Promise<Segmentation> {
    checkMesh(mesh);
    checkMesh(reduced);
    checkVertices(vertices);
    if (map) checkMap(map);
    if (!map?.triangle.length) throw new TypeError('The reduction has no map: only tracked errors make one.');
    const input = {
      mesh: copyMesh({ ...mesh, variables: [] }),
      reduction: {
        mesh: copyMesh({ ...reduced, variables: [] }),
        vertices: vertices.slice(),
        map: copyMap(map),
      },
    };
    return this.queue.run({ kind: 'segment', input }, { signal });
  }

  /** As the function `verify`. */
  async verify(original: Mesh, reduced: Mesh, options: VerifyOptions): Promise<Verdict> {
    const { signal, onProgress, bounds, multipliers, ...rest } = options;
    checkMesh(original);
    checkMesh(reduced);
    checkNumbers(bounds, 'bounds');
    if (multipliers) checkValues(multipliers, 'multipliers');
    const input = {
      original: copyMesh(original),
      reduced: copyMesh(reduced),
      options: { ...rest, bounds: [...bounds], multipliers: multipliers?.slice() },
    };
    return this.queue.run({ kind: 'verify', input }, { signal, onProgress });
  }

  /** As the function `inspect`. */
  async inspect(mesh: Mesh, { signal }: { signal?: AbortSignal } = {}): Promise<Inspection> {
    checkMesh(mesh);
    return this.queue.run({ kind: 'inspect', input: { mesh: copyMesh(mesh) } }, { signal });
  }

  /** Ends the worker and frees its memory. What is under way, and every later call, rejects with the code `disposed`. */
  dispose(): void {
    this.queue.dispose();
  }
}
