import { expect } from 'vitest';
import { FormatError, type FormatFault } from '../../web/formats/format-error.ts';
import { readSurface } from '../../web/formats/read.ts';
import { bytesOf } from './sample-mesh.ts';

/** The error that reading throws; fails if it throws none, or one that is no FormatError. */
export async function faultOf(file: string | Uint8Array): Promise<FormatError> {
  const bytes = typeof file === 'string' ? bytesOf(file) : file;
  const error = await readSurface('file', bytes).then(
    () => expect.fail('no error'),
    (thrown: unknown) => thrown,
  );
  if (error instanceof FormatError) return error;
  throw error;
}

/** Expects an error with this code, whose sentence says all of `words`. */
export async function expectFault(file: string | Uint8Array, code: FormatFault, ...words: string[]): Promise<void> {
  const { code: found, message } = await faultOf(file);
  expect({ code: found, message }).toEqual({ code, message: expect.stringMatching(/^[A-Z“].*[.?!]$/s) });
  for (const word of words) expect(message).toContain(word);
}
