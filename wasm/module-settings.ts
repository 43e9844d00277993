/** How the WebAssembly module is loaded. */
export interface ModuleSettings {
  /** Where the binary of the module lies, if not beside the worker: that of the module without threads. */
  wasmUrl?: string;
  /** Where the binary of the judge's module lies, if not beside the worker; loaded by the first `verify`. */
  judgeUrl?: string;
  /** How many threads may share the work in a page that is isolated from other origins. Default: as many as there are cores, up to 8. */
  threads?: number;
}
