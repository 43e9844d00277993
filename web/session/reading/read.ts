import type { Mesh } from '../../../wasm/types.ts';
import { fromAnyHost } from '../../../workers/from-any-host.ts';
import type { ReadOptions } from '../../formats/read.ts';
import type { NamedFile } from '../../formats/read-together.ts';
import type { Crack, Labels } from '../../formats/surface.ts';
import type { Watchers } from '../watchers.ts';

/** What a file holds. */
export interface OpenedFile {
  mesh: Mesh;
  /** Vertices that must stay, because sheets only touch there. */
  locked?: Uint32Array;
  /** Labels of the triangles, by the cell data that hold them. */
  regions?: ReadonlyMap<string, Int32Array>;
  /** What the reader did to the file that its owner should know. */
  notes: string[];
  /** Where sheets end beside each other within rounding: what is said of it, and the weld that closes it. */
  crack?: Crack;
  labels: Labels;
}

export type ReadAnswer = { file: OpenedFile } | { code: string; message: string };

/**
 * Reads a surface with the files `beside` it in a worker of its own, which the bytes are handed over to. The worker ends with the file: parsing
 * leaves several times the file's size behind, and a broken file may leave anything.
 */
export function readInWorker(
  name: string,
  bytes: Uint8Array<ArrayBuffer>,
  { signal }: Watchers = {},
  beside: NamedFile[] = [],
  options: ReadOptions = {},
): Promise<OpenedFile> {
  const Worker = fromAnyHost(globalThis.Worker);
  const worker = new Worker(new URL('./read.worker.ts', import.meta.url), { type: 'module' });
  const answer = new Promise<OpenedFile>((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<ReadAnswer>) =>
      'file' in data ? resolve(data.file) : reject(Object.assign(new Error(data.message), { code: data.code }));
    signal?.addEventListener('abort', () => reject(signal.reason), { once: true });
    worker.onerror = ({ message }) => reject(new Error(message || 'The reader could not be started.'));
  });
  worker.postMessage({ name, bytes, beside, options }, [bytes.buffer, ...beside.map((file) => file.bytes.buffer)]);
  return answer.finally(() => worker.terminate());
}
