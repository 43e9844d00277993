/** A flag that a running worker sees without receiving messages. */
export type CancelFlag = Int32Array<SharedArrayBuffer>;

/** A lowered flag, or undefined where memory cannot be shared: a page needs cross-origin isolation for it, Node nothing. */
export function createCancelFlag(): CancelFlag | undefined {
  const shareable = typeof SharedArrayBuffer === 'function' && (globalThis.crossOriginIsolated ?? true);
  return shareable ? new Int32Array(new SharedArrayBuffer(Int32Array.BYTES_PER_ELEMENT)) : undefined;
}

export function raise(flag: CancelFlag): void {
  Atomics.store(flag, 0, 1);
}

export function isRaised(flag: CancelFlag | undefined): boolean {
  return flag !== undefined && Atomics.load(flag, 0) === 1;
}
