import { printable } from '../../formats/text/wording.ts';

/** Says what the user should know of a file, a line each, on standard error: the results have standard output. */
export function sayNotes(path: string, notes: readonly string[]): void {
  for (const note of notes) console.error(printable(`${path}: ${note}`));
}
