import { FormatError } from '../format-error.ts';
import { capitalised, foreign } from './wording.ts';

/** The text that these bytes are; `what` names it in messages ("the CSV file"). */
export function utf8Text(bytes: Uint8Array, what: string): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch (error) {
    if (error instanceof TypeError) throw new FormatError('bad_encoding', `${capitalised(what)} is not UTF-8.`);
    // Engines disagree about the class of this one.
    throw new FormatError(
      'too_large',
      `${capitalised(what)} is longer than a text can be (${foreign((error as Error).message)}).`,
    );
  }
}

/** What stands in a text in place of bytes that are no UTF-8. */
export const undecoded = '\u{FFFD}';

/** The text that these bytes are as far as they are UTF-8, for what has parts that nobody reads. */
export function looseText(bytes: Uint8Array): { text: string; isUtf8: boolean } {
  const text = new TextDecoder().decode(bytes);
  // The mark may have been there as it is.
  if (!text.includes(undecoded)) return { text, isUtf8: true };
  try {
    new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    return { text, isUtf8: true };
  } catch {
    return { text, isUtf8: false };
  }
}
