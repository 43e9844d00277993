import createCore, { type Core } from '../build/wasm/meshbound.mjs';

const binary = new URL('../build/wasm/meshbound.wasm', import.meta.url);

/** Loads the WebAssembly module: from its address in a browser, from its file in Node, where fetch knows no files. */
export function loadCore(): Promise<Core> {
  if (binary.protocol === 'file:') {
    return createCore({ wasmBinary: process.getBuiltinModule('node:fs').readFileSync(binary) });
  }
  return createCore({ locateFile: () => binary.href });
}
