import { FormatError } from '../format-error.ts';
import { counted, foreign, grouped } from '../text/wording.ts';
import { expansionLimit } from './expansion-limit.ts';
import { joined } from './joined-arrays.ts';

export function isGzip(bytes: Uint8Array): boolean {
  return bytes[0] === 0x1f && bytes[1] === 0x8b;
}

/** An honest file may begin with one value for every point of as large a mesh as can be reduced: no ratio counts there. */
const longestConstant = 256 << 20;

/**
 * Unpacks a gzip file piece by piece, and stops as soon as that grows beyond what an honest file would make of the bytes so
 * far. One that says beforehand that it grows too much, or goes beyond what it said (several files in one do), is
 * trusted less.
 */
export async function gunzip(bytes: Uint8Array): Promise<Uint8Array> {
  const declared = declaredLength(bytes);
  const isPlausible = declared <= expansionLimit(bytes.length);
  return through(new DecompressionStream('gzip'), bytes, (length, taken) => {
    const most = expansionLimit(taken) + (isPlausible && length <= declared ? longestConstant : 0);
    if (length <= most) return;
    const message = `The first ${counted(taken, 'byte')} of the gzip file unpack to more than ${grouped(most)}: that is no mesh.`;
    throw new FormatError('too_large', message);
  });
}

/** The last four bytes tell the length of what is packed, but for multiples of 4 GB, which no mesh here can have. */
function declaredLength(bytes: Uint8Array): number {
  const size = 4;
  if (bytes.length < size) return 0;
  return new DataView(bytes.buffer, bytes.byteOffset + bytes.length - size).getUint32(0, true);
}

export function gzip(bytes: Uint8Array): Promise<Uint8Array> {
  return through(new CompressionStream('gzip'), bytes, () => {});
}

type Transform = ReadableWritablePair<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>;

/** What a transformation makes of the bytes; `check` hears how many came out so far of how many, and may throw. */
async function through(
  transform: Transform,
  bytes: Uint8Array,
  check: (length: number, taken: number) => void,
): Promise<Uint8Array> {
  const progress = { taken: 0 };
  // What goes wrong with the bytes is seen where they come out.
  feed(transform.writable.getWriter(), bytes as Uint8Array<ArrayBuffer>, progress).catch(() => {});
  const pieces: Uint8Array[] = [];
  let length = 0;
  const reader = transform.readable.getReader();
  try {
    for (let piece = await readPiece(reader); piece; piece = await readPiece(reader)) {
      length += piece.length;
      check(length, progress.taken);
      pieces.push(piece);
    }
  } finally {
    await reader.cancel().catch(() => {});
  }
  return joined(pieces, Uint8Array);
}

const chunkSize = 1 << 16;

/** Writes the bytes, no chunk before the last one is taken; a pipe would run ahead, and nothing could be said of the ratio. */
async function feed(
  writer: WritableStreamDefaultWriter<Uint8Array<ArrayBuffer>>,
  bytes: Uint8Array<ArrayBuffer>,
  progress: { taken: number },
): Promise<void> {
  while (progress.taken < bytes.length) {
    const chunk = bytes.subarray(progress.taken, progress.taken + chunkSize);
    progress.taken += chunk.length;
    await writer.write(chunk);
  }
  await writer.close();
}

async function readPiece(reader: ReadableStreamDefaultReader<Uint8Array>): Promise<Uint8Array | undefined> {
  try {
    return (await reader.read()).value;
  } catch (error) {
    throw new FormatError('corrupt', `The gzip file is damaged or cut short (${foreign((error as Error).message)}).`);
  }
}
