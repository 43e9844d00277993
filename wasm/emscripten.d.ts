/** What Emscripten makes of wasm/bindings.cpp. */
declare module '*/meshbound.mjs' {
  export default function createModule<Module>(settings: {
    wasmBinary?: Uint8Array;
    locateFile?: (name: string) => string;
  }): Promise<Module>;
}
