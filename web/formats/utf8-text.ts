import { FormatError } from './format-error.ts';
import { capitalised } from './wording.ts';

/** The text that these bytes are; `what` names it in messages ("the CSV file"). */
export function utf8Text(bytes: Uint8Array, what: string): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch (error) {
    if (error instanceof TypeError) throw new FormatError('bad_encoding', `${capitalised(what)} is not UTF-8.`);
    // Engines disagree about the class of this one.
    throw new FormatError(
      'too_large',
      `${capitalised(what)} is longer than a text can be (${(error as Error).message}).`,
    );
  }
}
