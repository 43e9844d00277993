import { expansionLimit } from './expansion-limit.ts';
import { FormatError } from './format-error.ts';
import { counted, grouped } from './wording.ts';

export function isGzip(bytes: Uint8Array): boolean {
  return bytes[0] === 0x1f && bytes[1] === 0x8b;
}

/** Unpacks a gzip file piece by piece, and stops as soon as it grows beyond what an honest file would. */
export async function gunzip(bytes: Uint8Array): Promise<Uint8Array> {
  const most = expansionLimit(bytes.length);
  const pieces: Uint8Array[] = [];
  let length = 0;
  const packed = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream();
  const reader = packed.pipeThrough(new DecompressionStream('gzip')).getReader();
  for (let piece = await readPiece(reader); piece; piece = await readPiece(reader)) {
    length += piece.length;
    if (length > most) {
      await reader.cancel();
      const message = `The gzip file of ${counted(bytes.length, 'byte')} unpacks to more than ${grouped(most)}: that is no mesh.`;
      throw new FormatError('too_large', message);
    }
    pieces.push(piece);
  }
  const whole = new Uint8Array(length);
  let at = 0;
  for (const piece of pieces) {
    whole.set(piece, at);
    at += piece.length;
  }
  return whole;
}

async function readPiece(reader: ReadableStreamDefaultReader<Uint8Array>): Promise<Uint8Array | undefined> {
  try {
    return (await reader.read()).value;
  } catch (error) {
    throw new FormatError('corrupt', `The gzip file is damaged or cut short (${(error as Error).message}).`);
  }
}
