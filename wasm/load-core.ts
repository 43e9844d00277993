import type createModule from '../build/wasm/meshbound.mjs';
import type { Inspection } from './inspection.ts';
import type { ModuleSettings } from './module-settings.ts';
import type { CoreLevelsOptions, CoreOptions, CoreResumeOptions, Outcome } from './tasks.ts';
import type { Checkpoint, Levels, MappedReduction, Mesh, Reduction, Segmentation } from './types.ts';

/** The functions of wasm/bindings.cpp. They block until they are done. */
export interface Core {
  /** Calls `goOn` every few milliseconds with the progress; `false` cancels. */
  reduce(mesh: Mesh, options: CoreOptions, goOn: (progress: number) => boolean): Outcome<Reduction>;
  resumeReduction(
    checkpoint: Checkpoint,
    options: CoreResumeOptions,
    goOn: (progress: number) => boolean,
  ): Outcome<Reduction>;
  reduceLevels(mesh: Mesh, options: CoreLevelsOptions, goOn: (progress: number) => boolean): Outcome<Levels>;
  segment(mesh: Mesh, reduction: MappedReduction, goOn: (progress: number) => boolean): Outcome<Segmentation>;
  inspect(mesh: Mesh): Outcome<Inspection>;
  /** How much memory the module has taken, in bytes; it never gives any back. */
  memorySize(): number;
}

const binary = new URL('../build/wasm/meshbound.wasm', import.meta.url);

/** The same with threads, in files that find each other by what they are told here; never bundled. */
const threaded = {
  module: new URL('../build/wasm-threads/meshbound.mjs', import.meta.url),
  binary: new URL('../build/wasm-threads/meshbound.wasm', import.meta.url),
  worker: new URL('../build/wasm-threads/meshbound.worker.js', import.meta.url),
};

/** More threads hardly help, and each takes a worker from the page's beginning. */
const mostThreads = 8;

/**
 * Loads the WebAssembly module: from its address in a browser, from its file in Node, where fetch knows no files. With
 * threads where the page is isolated from other origins, which shared memory needs, and the module comes from its own.
 */
export function loadCore({ wasmUrl, threads = mostThreads }: ModuleSettings = {}): Promise<Core> {
  const address = wasmUrl === undefined ? binary : new URL(wasmUrl);
  if (address.protocol === 'file:') {
    return loadSingle({ wasmBinary: process.getBuiltinModule('node:fs').readFileSync(address) });
  }
  const alone = () => loadSingle({ locateFile: () => address.href });
  // A browser that is short of memory may refuse to share so much of it.
  return address === binary && threads > 1 && mayShareMemory() ? loadThreaded(threads).catch(alone) : alone();
}

/** Its code is loaded only where it is needed. */
async function loadSingle(settings: Parameters<typeof createModule>[0]): Promise<Core> {
  const { default: create } = await import('../build/wasm/meshbound.mjs');
  return create<Core>(settings);
}

function mayShareMemory(): boolean {
  return globalThis.crossOriginIsolated && threaded.module.origin === location.origin;
}

async function loadThreaded(threads: number): Promise<Core> {
  const { default: createThreaded }: { default: typeof createModule } = await import(
    /* @vite-ignore */ threaded.module.href
  );
  return createThreaded<Core>({
    locateFile: (name) => (name.endsWith('.wasm') ? threaded.binary.href : threaded.worker.href),
    mainScriptUrlOrBlob: threaded.module.href,
    workers: Math.min(navigator.hardwareConcurrency, mostThreads, threads) - 1,
  });
}
