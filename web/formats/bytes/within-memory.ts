import { FormatError } from '../format-error.ts';
import { foreign } from '../text/wording.ts';

/** Runs what may need more memory than there is, and says so in a FormatError if it does. */
export async function withinMemory<Result>(work: () => Result | Promise<Result>): Promise<Result> {
  try {
    return await work();
  } catch (error) {
    // Engines report an array or a string that they have no room for as a RangeError.
    if (!(error instanceof RangeError)) throw error;
    throw new FormatError('too_large', `The file needs more memory than there is (${foreign(error.message)}).`);
  }
}
