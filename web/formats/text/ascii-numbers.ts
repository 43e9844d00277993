import { FormatError } from '../format-error.ts';
import { grouped, quoted } from './wording.ts';

/** One way to read each digit, so that no text takes long. */
const plainNumber = /^[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?$/;
const longestToken = 512;
/** Integers below 10^15 and powers of ten up to 10^22 are exact doubles, so their quotient is rounded once, correctly. */
const exactDigits = 15;
const powersOfTen = Array.from({ length: exactDigits + 1 }, (_, exponent) => Number(`1e${exponent}`));

/** How C, C++ and Fortran programs on the usual systems print what is not a finite number. */
const notFinite = /^([+-]?)(nan(\(\w*\))?|inf(inity)?|1\.#(qnan|snan|ind|inf)\d*)$/i;

/** A number as text files write it, NaN and infinity in every usual spelling; undefined for anything else. */
export function parseNumber(token: string): number | undefined {
  if (plainNumber.test(token)) return Number(token);
  const match = notFinite.exec(token);
  if (!match) return undefined;
  if (!/inf/i.test(token)) return Number.NaN;
  return match[1] === '-' ? -Infinity : Infinity;
}

function isBreak(byte: number): boolean {
  return byte === 10 || byte === 13;
}

function isSpace(byte: number): boolean {
  return byte === 32 || (byte >= 9 && byte <= 13);
}

/**
 * The numbers of a text, straight from its bytes: a large file never becomes one large string or millions of small ones.
 * `place` says where the reading is, for messages.
 */
export class AsciiNumbers {
  private readonly bytes: Uint8Array;
  private at: number;
  private readonly place: () => string;
  /** Where the reading ends. */
  private end: number;
  private broke = false;
  private lineOnly = false;
  /** Whether a line break came before the number that was read last. */
  afterBreak = false;

  constructor(bytes: Uint8Array, at: number, place: () => string) {
    this.bytes = bytes;
    this.at = at;
    this.place = place;
    this.end = bytes.length;
  }

  /** Bytes not read yet. */
  get left(): number {
    return this.bytes.length - this.at;
  }

  /** The line of the file in which the reading is, counted from 1, whatever ends lines. */
  get line(): number {
    const { bytes, at } = this;
    let line = 1;
    for (let i = 0; i < at; i++) if (isBreak(bytes[i]) && !(bytes[i] === 10 && bytes[i - 1] === 13)) line++;
    return line;
  }

  /** Goes to the next line that is not empty; until it is left for another one, the reading ends where it ends. */
  enterLine(): void {
    this.leaveLine();
    const { bytes } = this;
    if (this.atEnd()) return;
    let end = this.at;
    while (end < bytes.length && !isBreak(bytes[end])) end++;
    this.end = end;
    this.lineOnly = true;
  }

  /** Whether the reading ends with a line. */
  get inLine(): boolean {
    return this.lineOnly;
  }

  /** Passes over what is left of the line; the reading ends with the file again. */
  leaveLine(): void {
    if (this.lineOnly) this.at = this.end;
    this.end = this.bytes.length;
    this.lineOnly = false;
  }

  /** True when nothing but white space is left. */
  atEnd(): boolean {
    const { bytes, end } = this;
    for (; this.at < end && isSpace(bytes[this.at]); this.at++) if (isBreak(bytes[this.at])) this.broke = true;
    return this.at === end;
  }

  next(): number {
    if (this.atEnd()) throw new FormatError('truncated', `The file ends in ${this.place()}.`, this.place());
    this.afterBreak = this.broke;
    this.broke = false;
    return this.shortDecimal() ?? this.anyNumber();
  }

  /** Digits with at most one point among them, few enough to be exact; undefined (and nothing read) for other tokens. */
  private shortDecimal(): number | undefined {
    const { bytes, end } = this;
    let at = this.at;
    const negative = bytes[at] === 45;
    if (negative) at++;
    let [mantissa, digits, decimals, point] = [0, 0, 0, 0];
    for (; at < end; at++) {
      const byte = bytes[at];
      if (byte >= 48 && byte <= 57) {
        mantissa = mantissa * 10 + (byte - 48);
        digits++;
        decimals += point;
      } else if (byte === 46 && point === 0) {
        point = 1;
      } else break;
    }
    const whole = at === end || isSpace(bytes[at]);
    if (!whole || digits === 0 || digits > exactDigits) return undefined;
    this.at = at;
    const size = mantissa / powersOfTen[decimals];
    return negative ? -size : size;
  }

  private anyNumber(): number {
    const start = this.at;
    while (this.at < this.end && !isSpace(this.bytes[this.at])) this.at++;
    const token = new TextDecoder().decode(this.bytes.subarray(start, Math.min(this.at, start + longestToken)));
    const value = this.at - start < longestToken ? parseNumber(token) : undefined;
    if (value !== undefined) return value;
    const message = `${quoted(token)} in ${this.place()} is not a number (byte ${grouped(start)}).`;
    throw new FormatError('bad_number', message, this.place());
  }
}
