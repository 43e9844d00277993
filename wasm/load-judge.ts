import type { ModuleSettings } from './module-settings.ts';
import type { CoreVerifyOptions, Outcome } from './tasks.ts';
import type { Mesh, Verdict } from './types.ts';

/** The functions of wasm/judge-bindings.cpp. They block until they are done. */
export interface Judge {
  /** Calls `goOn` every few milliseconds with the progress; `false` cancels. */
  verify(
    original: Mesh,
    reduced: Mesh,
    options: CoreVerifyOptions,
    goOn: (progress: number) => boolean,
  ): Outcome<Verdict>;
  /** How much memory the module has taken, in bytes; it never gives any back. */
  memorySize(): number;
}

const binary = new URL('../build/wasm/judge.wasm', import.meta.url);

/** Loads the judge's WebAssembly module and its code: from its address in a browser, from its file in Node. */
export async function loadJudge({ judgeUrl }: ModuleSettings = {}): Promise<Judge> {
  const address = judgeUrl === undefined ? binary : new URL(judgeUrl);
  const { default: create } = await import('../build/wasm/judge.mjs');
  if (address.protocol === 'file:') {
    return create<Judge>({ wasmBinary: process.getBuiltinModule('node:fs').readFileSync(address) });
  }
  return create<Judge>({ locateFile: () => address.href });
}
