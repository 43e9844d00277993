import { FormatError } from '../format-error.ts';
import { AsciiNumbers } from '../text/ascii-numbers.ts';
import { undecoded } from '../text/utf8-text.ts';
import { grouped, quoted } from '../text/wording.ts';
import { byteLength, fromBytes, roomFor, type VtkType, type VtkValues } from '../vtk-data/vtk-values.ts';

const newLine = 10;
const longestLine = 1 << 16;

/** The words, lines and numbers of a legacy VTK file, whose numbers are text or big-endian bytes between lines of text. */
export class LegacyVtkText {
  /** Whether numbers are bytes; the third line of the file says so. */
  binary = false;
  private readonly bytes: Uint8Array;
  private at = 0;
  private lineNumber = 0;

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
  }

  /** The place of the last line that was read, for messages. Binary data makes line numbers useless, so bytes are given there. */
  place(): string {
    return this.binary ? `byte ${grouped(this.at)}` : `line ${grouped(this.lineNumber)}`;
  }

  atEnd(): boolean {
    return this.at >= this.bytes.length;
  }

  /** The next line without its break; undefined at the end of the file. */
  line(): string | undefined {
    if (this.atEnd()) return undefined;
    const found = this.bytes.indexOf(newLine, this.at);
    const end = found < 0 ? this.bytes.length : found;
    if (end - this.at > longestLine) {
      throw new FormatError('bad_header', `There is no line break after ${this.place()}.`, this.place());
    }
    const text = new TextDecoder().decode(this.bytes.subarray(this.at, end));
    this.at = end + 1;
    this.lineNumber++;
    return text.trim();
  }

  /** The words of the next line that is not empty; none at the end of the file. */
  words(): string[] {
    for (let line = this.line(); line !== undefined; line = this.line()) {
      if (line !== '') return line.split(/\s+/);
    }
    return [];
  }

  /** Looks at the words of the next line that is not empty without taking it. */
  peek(): string[] {
    const { at, lineNumber } = this;
    const words = this.words();
    this.at = at;
    this.lineNumber = lineNumber;
    return words;
  }

  /** As many numbers; throws if they cannot be in what is left of the file. `where` names their array. */
  numbers(type: VtkType, count: number, where: string): VtkValues {
    return this.binary
      ? fromBytes(this.block(byteLength(type, count), where), type, count, false)
      : this.text(type, count, where);
  }

  /** Binary data as it is. */
  block(size: number, where: string): Uint8Array<ArrayBuffer> {
    const left = this.bytes.length - this.at;
    if (size > left) {
      const message = `The ${where} needs ${grouped(size)} bytes, but the file has only ${grouped(left)} left.`;
      throw new FormatError('truncated', message, where);
    }
    this.at += size;
    return this.bytes.slice(this.at - size, this.at) as Uint8Array<ArrayBuffer>;
  }

  private text(type: VtkType, count: number, where: string): VtkValues {
    const numbers = new AsciiNumbers(this.bytes, this.at, () => where);
    // A number takes a digit and a space, the last one only a digit.
    if (2 * count > numbers.left + 1) {
      const message = `The ${where} needs ${grouped(count)} numbers, but the file has only ${grouped(numbers.left)} bytes left.`;
      throw new FormatError('truncated', message, where);
    }
    const values = roomFor(type, count);
    const from = this.at;
    for (let i = 0; i < count; i++) values[i] = numbers.next();
    this.at = this.bytes.length - numbers.left;
    for (let at = from; at < this.at; at++) if (this.bytes[at] === newLine) this.lineNumber++;
    return values;
  }
}

/** Names are written with %XX for what is neither letter nor digit nor sign. */
export function decodeName(word: string, place: string): string {
  const notUtf8 = () => new FormatError('bad_encoding', `The name ${quoted(word)} is not UTF-8 (${place}).`, place);
  if (word.includes(undecoded)) throw notUtf8();
  const parts = word.match(/(%[0-9A-Fa-f]{2})+|[^%]+|%/g) ?? [];
  try {
    return parts.map((part) => (/^%../.test(part) ? decodeURIComponent(part) : part)).join('');
  } catch {
    throw notUtf8();
  }
}

/** A name as the word that decodeName takes back. Throws where it is no text: halves of characters have no UTF-8. */
export function encodeName(name: string): string {
  if (/\p{Surrogate}/u.test(name)) {
    throw new FormatError('bad_name', `A legacy VTK file cannot hold the name ${quoted(name)}.`, quoted(name));
  }
  const bytes = new TextEncoder().encode(name);
  const isPlain = (byte: number) => byte > 32 && byte < 127 && byte !== 34 && byte !== 37;
  const hex = (byte: number) => `%${byte.toString(16).toUpperCase().padStart(2, '0')}`;
  return Array.from(bytes, (byte) => (isPlain(byte) ? String.fromCharCode(byte) : hex(byte))).join('');
}
