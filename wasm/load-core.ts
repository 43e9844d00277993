import createModule from '../build/wasm/meshbound.mjs';
import type { Inspection } from './inspection.ts';
import type { CoreLevelsOptions, CoreOptions, Outcome } from './messages.ts';
import type { Levels, MappedReduction, Mesh, Reduction, Segmentation } from './types.ts';

/** The functions of wasm/bindings.cpp. They block until they are done. */
export interface Core {
  /** Calls `goOn` every few milliseconds with the progress; `false` cancels. */
  reduce(mesh: Mesh, options: CoreOptions, goOn: (progress: number) => boolean): Outcome<Reduction>;
  reduceLevels(mesh: Mesh, options: CoreLevelsOptions, goOn: (progress: number) => boolean): Outcome<Levels>;
  segment(mesh: Mesh, reduction: MappedReduction, goOn: (progress: number) => boolean): Outcome<Segmentation>;
  inspect(mesh: Mesh): Outcome<Inspection>;
  /** How much memory the module has taken, in bytes; it never gives any back. */
  memorySize(): number;
}

const binary = new URL('../build/wasm/meshbound.wasm', import.meta.url);

/** Loads the WebAssembly module: from its address in a browser, from its file in Node, where fetch knows no files. */
export function loadCore(): Promise<Core> {
  if (binary.protocol === 'file:') {
    return createModule<Core>({ wasmBinary: process.getBuiltinModule('node:fs').readFileSync(binary) });
  }
  return createModule<Core>({ locateFile: () => binary.href });
}
