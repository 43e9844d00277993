import { FormatError } from '../format-error.ts';
import { grouped, quoted } from '../text/wording.ts';

/** Bytes that are taken from the front. `where` names them in messages. */
export interface ByteStream {
  /** An upper limit of the bytes that are left. */
  readonly left: number;
  take(length: number): Uint8Array<ArrayBuffer>;
}

export class RawBytes implements ByteStream {
  private readonly bytes: Uint8Array;
  private readonly where: string;

  constructor(bytes: Uint8Array, where: string) {
    this.bytes = bytes;
    this.where = where;
  }

  private at = 0;

  get left(): number {
    return this.bytes.length - this.at;
  }

  /** A copy, so that it is aligned for any type. */
  take(length: number): Uint8Array<ArrayBuffer> {
    if (length > this.left) throw endOfData(this.where, length - this.left);
    this.at += length;
    return this.bytes.slice(this.at - length, this.at) as Uint8Array<ArrayBuffer>;
  }
}

const alphabet = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
const [skipped, padding, invalid] = [64, 65, 66];
const codes = new Uint8Array(256).fill(invalid);
for (const [code, letter] of [...alphabet].entries()) codes[letter.charCodeAt(0)] = code;
for (const space of ' \t\r\n') codes[space.charCodeAt(0)] = skipped;
codes['='.charCodeAt(0)] = padding;

/**
 * Base64 as VTK writes it: several encoded blocks may follow each other, each padded for itself (atob would refuse), and
 * the text ends wherever something else begins, so it is decoded only as far as it is asked for.
 */
export class Base64Bytes implements ByteStream {
  private readonly text: Uint8Array;
  private at: number;
  private readonly where: string;
  /** Bytes of the last group of four letters that were not asked for yet. */
  private spare: number[] = [];

  constructor(text: Uint8Array, start: number, where: string) {
    this.text = text;
    this.at = start;
    this.where = where;
  }

  get left(): number {
    return this.spare.length + Math.ceil(((this.text.length - this.at) * 3) / 4);
  }

  take(length: number): Uint8Array<ArrayBuffer> {
    if (length > this.left) throw endOfData(this.where, length - this.left);
    const bytes = new Uint8Array(length);
    let filled = 0;
    while (filled < length) {
      if (this.spare.length === 0) filled = this.takeWholeGroups(bytes, filled);
      if (filled === length) break;
      if (this.spare.length === 0) this.spare = this.nextGroup(length - filled);
      const taken = this.spare.splice(0, length - filled);
      bytes.set(taken, filled);
      filled += taken.length;
    }
    return bytes;
  }

  /** The fast path: as many groups of four letters as come without space, padding or garbage. */
  private takeWholeGroups(bytes: Uint8Array, start: number): number {
    const { text } = this;
    let filled = start;
    for (; filled + 3 <= bytes.length && this.at + 4 <= text.length; this.at += 4, filled += 3) {
      const a = codes[text[this.at]];
      const b = codes[text[this.at + 1]];
      const c = codes[text[this.at + 2]];
      const d = codes[text[this.at + 3]];
      if ((a | b | c | d) >= skipped) break;
      bytes[filled] = (a << 2) | (b >>> 4);
      bytes[filled + 1] = (b << 4) | (c >>> 2);
      bytes[filled + 2] = (c << 6) | d;
    }
    return filled;
  }

  /** The one, two or three bytes of the next four letters. */
  private nextGroup(missing: number): number[] {
    const group = [this.nextCode(missing), this.nextCode(missing), this.nextCode(missing), this.nextCode(missing)];
    const letters = group.indexOf(padding) < 0 ? 4 : group.indexOf(padding);
    const padded = group.slice(letters).every((code) => code === padding);
    if (letters < 2 || !padded) throw this.garbage('=');
    const bits = group.reduce((sum, code) => (sum << 6) | (code === padding ? 0 : code), 0);
    return [bits >>> 16, (bits >>> 8) & 255, bits & 255].slice(0, letters - 1);
  }

  private nextCode(missing: number): number {
    while (this.at < this.text.length) {
      const letter = this.text[this.at++];
      const code = codes[letter];
      if (code === invalid) throw this.garbage(new TextDecoder().decode(Uint8Array.of(letter)));
      if (code !== skipped) return code;
    }
    throw endOfData(this.where, missing);
  }

  private garbage(letter: string): FormatError {
    const place = `at character ${grouped(this.at)} of the ${this.where}`;
    return new FormatError('corrupt', `${quoted(letter)} does not belong into base64 (${place}).`, this.where);
  }
}

function endOfData(where: string, missing: number): FormatError {
  return new FormatError('truncated', `The data of the ${where} ends ${grouped(missing)} bytes too early.`, where);
}
