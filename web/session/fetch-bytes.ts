/** An address that gives no bytes. The message is a sentence for people. */
export class LoadError extends Error {
  readonly code = 'cannot_load';
}

/** Fetches bytes; rejects with a LoadError where they are not to be had. */
export async function fetchBytes(address: string): Promise<Uint8Array<ArrayBuffer>> {
  const response = await fetch(address).catch(() => {
    throw new LoadError(`${address} cannot be loaded: it cannot be reached, or does not let other sites read it.`);
  });
  if (!response.ok) throw new LoadError(`${address} cannot be loaded (status ${response.status}).`);
  return new Uint8Array(await response.arrayBuffer());
}
