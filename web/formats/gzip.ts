import { expansionLimit } from './expansion-limit.ts';
import { FormatError } from './format-error.ts';
import { joined } from './joined-arrays.ts';
import { counted, grouped } from './wording.ts';

export function isGzip(bytes: Uint8Array): boolean {
  return bytes[0] === 0x1f && bytes[1] === 0x8b;
}

/** Unpacks a gzip file piece by piece, and stops as soon as it grows beyond what an honest file would. */
export async function gunzip(bytes: Uint8Array): Promise<Uint8Array> {
  const most = expansionLimit(bytes.length);
  return through(new DecompressionStream('gzip'), bytes, (length) => {
    if (length <= most) return;
    const message = `The gzip file of ${counted(bytes.length, 'byte')} unpacks to more than ${grouped(most)}: that is no mesh.`;
    throw new FormatError('too_large', message);
  });
}

export function gzip(bytes: Uint8Array): Promise<Uint8Array> {
  return through(new CompressionStream('gzip'), bytes, () => {});
}

type Transform = ReadableWritablePair<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>;

/** What a transformation makes of the bytes; `check` hears how many came out so far and may throw. */
async function through(transform: Transform, bytes: Uint8Array, check: (length: number) => void): Promise<Uint8Array> {
  const pieces: Uint8Array[] = [];
  let length = 0;
  const reader = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(transform).getReader();
  try {
    for (let piece = await readPiece(reader); piece; piece = await readPiece(reader)) {
      length += piece.length;
      check(length);
      pieces.push(piece);
    }
  } finally {
    await reader.cancel().catch(() => {});
  }
  return joined(pieces, Uint8Array);
}

async function readPiece(reader: ReadableStreamDefaultReader<Uint8Array>): Promise<Uint8Array | undefined> {
  try {
    return (await reader.read()).value;
  } catch (error) {
    throw new FormatError('corrupt', `The gzip file is damaged or cut short (${(error as Error).message}).`);
  }
}
