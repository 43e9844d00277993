/** What Emscripten makes of wasm/bindings.cpp. */
declare module '*/meshbound.mjs' {
  export default function createModule<Module>(settings: {
    wasmBinary?: Uint8Array;
    locateFile?: (name: string) => string;
    /** With threads: what their workers import, and how many of them there are. */
    mainScriptUrlOrBlob?: string;
    workers?: number;
  }): Promise<Module>;
}
