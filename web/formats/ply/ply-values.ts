import { FormatError } from '../format-error.ts';
import { AsciiNumbers } from '../text/ascii-numbers.ts';
import { capitalised, counted, grouped, quoted } from '../text/wording.ts';
import { type PlyElement, type PlyHeader, type PlyProperty, type PlyType, plyTypeSizes } from './ply-header.ts';

/** The fewest bytes a number takes in ASCII: a digit and a space. */
const asciiNumberSize = 2;

/** How the rows of an ASCII file lie in its lines, where that is not as it should be. */
export interface RowFaults {
  /** Which row first began in the middle of which line, and where that is. */
  firstInside?: { row: string; line: number };
  /** How many lines have more numbers than their rows, and which is the first. */
  longLines: number;
  firstLong?: number;
}

/** The numbers after a PLY header, one after the other, whatever the encoding. Every reading stays inside the file. */
export abstract class PlyValues {
  private element = '';
  private row = 0;

  /** Bytes not read yet. */
  abstract readonly left: number;
  /** What was odd about the rows read so far. */
  readonly faults: RowFaults = { longLines: 0 };
  abstract next(type: PlyType): number;
  protected abstract leastSize(type: PlyType): number;

  /** Where the reading is: "vertex 7". */
  readonly place = (): string => `${this.element} ${this.row}`;

  /** Begins an element; throws if so many rows cannot be in what is left of the file. */
  begin(element: PlyElement): void {
    this.element = element.name;
    this.row = 0;
    const rowSize = element.properties.reduce((sum, property) => sum + this.leastPropertySize(property), 0);
    const needed = element.count * rowSize;
    // The last number of an ASCII file needs no space after it.
    if (needed <= this.left + 1) return;
    const message =
      `The header declares ${counted(element.count, `row`)} of ${quoted(element.name)}, at least ` +
      `${grouped(needed)} bytes, but the file has only ${grouped(this.left)} bytes left.`;
    throw new FormatError('truncated', message, `element ${quoted(element.name)}`);
  }

  startRow(row: number): void {
    this.row = row;
  }

  /** To be called after the last row. */
  finish(): void {}

  /** The length of a list, checked against the file; its items are to be read next. */
  nextLength(property: PlyProperty): number {
    const length = this.next(property.listLength ?? property.type);
    if (!Number.isInteger(length) || length < 0) {
      const message = `The list ${quoted(property.name)} of ${this.place()} has ${length} items.`;
      throw new FormatError('bad_polygon', message, this.place());
    }
    if (length * this.leastSize(property.type) > this.left + 1) {
      const message =
        `The list ${quoted(property.name)} of ${this.place()} should have ${counted(length, 'item')}, ` +
        `but the file has only ${counted(this.left, 'byte')} left.`;
      throw new FormatError('truncated', message, this.place());
    }
    return length;
  }

  skip(property: PlyProperty): void {
    const length = property.listLength ? this.nextLength(property) : 1;
    for (let i = 0; i < length; i++) this.next(property.type);
  }

  private leastPropertySize(property: PlyProperty): number {
    return this.leastSize(property.listLength ?? property.type);
  }
}

/**
 * In ASCII the rows follow each other wherever lines break, as long as none begins inside a line and ends in another one; `byLine` each of them has a line
 * of its own, and what else stands in that is passed over.
 */
export function plyValues(bytes: Uint8Array, header: PlyHeader, byLine = false): PlyValues {
  if (header.encoding === 'ascii') {
    return byLine ? new LineValues(bytes, header.end) : new AsciiValues(bytes, header.end);
  }
  return new BinaryValues(bytes, header.end, header.encoding === 'binary_little_endian');
}

class AsciiValues extends PlyValues {
  protected readonly numbers: AsciiNumbers;
  /** Whether the row has no number yet, and whether it began where another one ended. */
  private rowBegins = true;
  private inside = false;
  private first = true;

  constructor(bytes: Uint8Array, start: number) {
    super();
    this.numbers = new AsciiNumbers(bytes, start, this.place);
  }

  get left(): number {
    return this.numbers.atEnd() ? 0 : this.numbers.left;
  }

  override startRow(row: number): void {
    super.startRow(row);
    this.rowBegins = true;
  }

  next(_type: PlyType): number {
    const value = this.numbers.next();
    if (this.rowBegins) this.beginRow(this.numbers.afterBreak);
    else if (this.inside && this.numbers.afterBreak) throw brokenRow(this.faults);
    return value;
  }

  private beginRow(onNewLine: boolean): void {
    this.inside = !onNewLine && !this.first;
    this.rowBegins = this.first = false;
    if (this.inside) this.faults.firstInside ??= { row: this.place(), line: this.numbers.line };
  }

  protected leastSize(_type: PlyType): number {
    return asciiNumberSize;
  }
}

/** The error for rows that have not as many numbers as the header declares. */
export function brokenRow({ firstInside = { row: 'a row', line: 0 } }: RowFaults): FormatError {
  const { row, line } = firstInside;
  const where = `line ${grouped(line)}`;
  const begins = `${capitalised(row)} begins in the middle of ${where}`;
  const advice = 'the rows before it may have more or fewer numbers than the header declares';
  return new FormatError('count_mismatch', `${begins}: ${advice}.`, where);
}

class LineValues extends AsciiValues {
  override begin(element: PlyElement): void {
    this.leaveLine();
    super.begin(element);
  }

  override startRow(row: number): void {
    super.startRow(row);
    this.leaveLine();
    this.numbers.enterLine();
  }

  override finish(): void {
    this.leaveLine();
  }

  private leaveLine(): void {
    if (this.numbers.inLine && !this.numbers.atEnd()) {
      this.faults.longLines++;
      this.faults.firstLong ??= this.numbers.line;
    }
    this.numbers.leaveLine();
  }
}

class BinaryValues extends PlyValues {
  private readonly view: DataView;
  private readonly littleEndian: boolean;
  private at: number;

  constructor(bytes: Uint8Array, start: number, littleEndian: boolean) {
    super();
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.at = start;
    this.littleEndian = littleEndian;
  }

  get left(): number {
    return this.view.byteLength - this.at;
  }

  next(type: PlyType): number {
    const { view, at, littleEndian } = this;
    this.at += plyTypeSizes[type];
    if (this.at > view.byteLength)
      throw new FormatError('truncated', `The file ends in ${this.place()}.`, this.place());
    switch (type) {
      case 'int8':
        return view.getInt8(at);
      case 'uint8':
        return view.getUint8(at);
      case 'int16':
        return view.getInt16(at, littleEndian);
      case 'uint16':
        return view.getUint16(at, littleEndian);
      case 'int32':
        return view.getInt32(at, littleEndian);
      case 'uint32':
        return view.getUint32(at, littleEndian);
      case 'float32':
        return view.getFloat32(at, littleEndian);
      case 'float64':
        return view.getFloat64(at, littleEndian);
    }
  }

  protected leastSize(type: PlyType): number {
    return plyTypeSizes[type];
  }
}
