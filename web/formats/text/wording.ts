/** `1 face`, `12 000 faces`: a count with its noun. */
export function counted(count: number, noun: string): string {
  return `${grouped(count)} ${noun}${count === 1 ? '' : 's'}`;
}

/** Digits in groups of three, the same in every locale. */
export function grouped(count: number): string {
  return String(count).replace(/\B(?=(\d{3})+$)/g, ' ');
}

/** A text from a file without control characters, which could do anything to a terminal. */
export function printable(text: string): string {
  return text.replace(/\p{Cc}/gu, '\u{FFFD}');
}

/** A name from a file, shortened and without control characters, fit to stand in a sentence. */
export function quoted(name: string): string {
  const longest = 60;
  const shown = printable(name);
  return `“${shown.length > longest ? `${shown.slice(0, longest)}…` : shown}”`;
}

/**
 * What an engine or a package says of a fault, as a part of a sentence of ours: with our quotation marks, and without the piece
 * of the file that some engines add.
 */
export function foreign(message: string): string {
  const [said] = printable(message).split(/, "/);
  return said.replace(/(["'])(.*?)\1/g, '“$2”').replace(/\.$/, '');
}

/** `“a”, “b” and 17 more`: so that a note stays readable whatever a file holds. */
export function listed(names: string[]): string {
  const most = 8;
  const shown = names.slice(0, most).map(quoted).join(', ');
  return names.length > most ? `${shown} and ${names.length - most} more` : shown;
}

/** A text as the beginning of a sentence. */
export function capitalised(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
