/** Where workers lie; null where they lie beside the code that starts them. */
let folder: URL | null = null;

/**
 * Loads workers, and the WebAssembly beside them, from `address` instead of from beside this module, for those who serve
 * them from elsewhere; null undoes it. Workers that run already stay.
 */
export function loadWorkersFrom(address: string | URL | null): void {
  folder = address === null ? null : new URL(`${address}`.replace(/\/?$/, '/'), document.baseURI);
}

/**
 * `Worker`, but able to start a module worker from another host than the document's, which browsers refuse: a worker of
 * the document's own imports it. (The host must let others read it, as for any module; the document's content security
 * policy must allow workers from `blob:`.)
 *
 * Call it `Worker` where it is used: by `new Worker(new URL(…))` the bundler finds what to bundle.
 */
export function fromAnyHost(Base: typeof Worker): typeof Worker {
  return class extends Base {
    constructor(address: string | URL, options?: WorkerOptions) {
      const placed = inFolder(new URL(address));
      super(placed.origin === location.origin ? placed : bridgeTo(placed.href), options);
    }
  };
}

function inFolder(address: URL): URL {
  return folder ? new URL(address.pathname.replace(/^.*\//s, ''), folder) : address;
}

/** One for each worker: a blob that a worker may still have to load cannot be taken back. */
const bridges = new Map<string, string>();

function bridgeTo(address: string): string {
  let bridge = bridges.get(address);
  if (bridge === undefined) {
    bridge = URL.createObjectURL(new Blob([`import ${JSON.stringify(address)};`], { type: 'text/javascript' }));
    bridges.set(address, bridge);
  }
  return bridge;
}
