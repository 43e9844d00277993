/** The module that Emscripten makes of wasm/bindings.cpp. */
declare module '*/meshbound.mjs' {
  import type { Inspection } from '../wasm/inspection.ts';
  import type { CoreOptions, Outcome } from '../wasm/messages.ts';
  import type { Mesh, Reduction } from '../wasm/types.ts';

  export interface Core {
    /** Calls `goOn` every few milliseconds with the progress; `false` cancels. */
    reduce(mesh: Mesh, options: CoreOptions, goOn: (progress: number) => boolean): Outcome<Reduction>;
    inspect(mesh: Mesh): Outcome<Inspection>;
  }

  export default function createCore(settings: {
    wasmBinary?: Uint8Array;
    locateFile?: (name: string) => string;
  }): Promise<Core>;
}
