import type { Watchers } from '../watchers.ts';

/** An address that gives no bytes. The message is a sentence for people. */
export class LoadError extends Error {
  readonly code = 'cannot_load';
}

/** Fetches bytes; rejects with a LoadError where they are not to be had. */
export async function fetchBytes(
  address: string,
  { signal, onProgress }: Watchers = {},
): Promise<Uint8Array<ArrayBuffer>> {
  const response = await fetch(address, { signal }).catch((error) => {
    if (signal?.aborted) throw error;
    throw new LoadError(`${address} cannot be loaded: it cannot be reached, or does not let other sites read it.`);
  });
  if (!response.ok || !response.body) throw new LoadError(`${address} cannot be loaded (status ${response.status}).`);
  return new Uint8Array(await new Response(counted(response, onProgress)).arrayBuffer());
}

/** The body as it comes in, telling how much of it has come, where its length is known. */
function counted({ body, headers }: Response, onProgress: Watchers['onProgress']) {
  const length = Number(headers.get('Content-Length'));
  let received = 0;
  const count = new TransformStream<Uint8Array, Uint8Array>({
    transform(chunk, controller) {
      received += chunk.length;
      // Packed bodies grow beyond their length.
      if (length > 0) onProgress?.(Math.min(1, received / length));
      controller.enqueue(chunk);
    },
  });
  return (body as ReadableStream<Uint8Array>).pipeThrough(count);
}
