/** What Emscripten makes of wasm/judge-bindings.cpp. */
declare module '*/judge.mjs' {
  export default function createModule<Module>(settings: {
    wasmBinary?: Uint8Array;
    locateFile?: (name: string) => string;
  }): Promise<Module>;
}
