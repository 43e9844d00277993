import { FormatError } from '../format-error.ts';
import { parseNumber } from './ascii-numbers.ts';
import { capitalised, counted, grouped, quoted } from './wording.ts';

const chunkSize = 1 << 20;
/** Room for a polygon of a million corners. */
const longestLine = 1 << 24;

/** A line of a text as words, with its number, counted from 1. */
export interface TextLine {
  words: string[];
  number: number;
}

/** The lines of any system that are not empty, decoded piece by piece: the whole text need not fit into one string. */
export function* textLines(bytes: Uint8Array): Generator<TextLine> {
  const decoder = new TextDecoder();
  let rest = '';
  // A break may be of two letters, of which the second is yet to come.
  let half = '';
  let number = 0;
  for (let at = 0; at < bytes.length; at += chunkSize) {
    const piece = half + decoder.decode(bytes.subarray(at, at + chunkSize), { stream: true });
    half = piece.endsWith('\r') ? '\r' : '';
    const lines = piece.slice(0, piece.length - half.length).split(/\r\n?|\n/);
    lines[0] = rest + lines[0];
    rest = lines.pop() ?? '';
    if (rest.length > longestLine) throw endlessLine(number + lines.length + 1);
    for (const line of lines) {
      number++;
      const text = line.trim();
      if (text !== '') yield { words: text.split(/\s+/), number };
    }
  }
  const last = (rest + decoder.decode()).trim();
  if (last !== '') yield { words: last.split(/\s+/), number: number + 1 };
}

function endlessLine(number: number): FormatError {
  const where = `line ${grouped(number)}`;
  return new FormatError('bad_header', `There is no line break in sight after ${where} begins.`, where);
}

/** `count` numbers from the words of a line, from word `from` on. */
export function numbersFrom({ words, number }: TextLine, from: number, count: number): number[] {
  const where = `line ${number}`;
  if (words.length < from + count) {
    const message = `${quoted(words.join(' '))} needs ${counted(count, 'number')} (${where}).`;
    throw new FormatError('bad_number', message, where);
  }
  return words.slice(from, from + count).map((word) => {
    const value = parseNumber(word);
    if (value !== undefined) return value;
    throw new FormatError('bad_number', `${quoted(word)} in ${where} is not a number.`, where);
  });
}

/** What is to be said of a text (“the file”) that declares no length and may have lost its end. */
export function cutNotes(bytes: Uint8Array, what = 'the file'): string[] {
  if (bytes.length === 0 || bytes[bytes.length - 1] <= 32) return [];
  return [`${capitalised(what)} does not end with a line break: if it was cut short, its last number may be wrong.`];
}
