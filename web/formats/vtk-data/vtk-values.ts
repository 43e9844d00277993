import { isWholeType, type WholeType } from '../variables/whole-types.ts';

/** What a variable's values are read as: single precision as it is, everything else in doubles. */
export type VtkValues = Float32Array | Float64Array;

/** The number types of VTK files, by the names that the XML formats give them. */
export type VtkType =
  | 'Bit'
  | 'Int8'
  | 'UInt8'
  | 'Int16'
  | 'UInt16'
  | 'Int32'
  | 'UInt32'
  | 'Int64'
  | 'UInt64'
  | 'Float32'
  | 'Float64';

/** Arrays of the size of each type; bits and 64-bit integers are put together separately. */
const arrays = {
  Bit: Uint8Array,
  Int8: Int8Array,
  UInt8: Uint8Array,
  Int16: Int16Array,
  UInt16: Uint16Array,
  Int32: Int32Array,
  UInt32: Uint32Array,
  Int64: Float64Array,
  UInt64: Float64Array,
  Float32: Float32Array,
  Float64: Float64Array,
};

export function isVtkType(name: string | undefined): name is VtkType {
  return name !== undefined && Object.hasOwn(arrays, name);
}

export function isFloat(type: VtkType): boolean {
  return type === 'Float32' || type === 'Float64';
}

/** The type as files of all formats may have it; undefined for floating point and bits. */
export function wholeTypeOf(type: VtkType): WholeType | undefined {
  const name = type.toLowerCase();
  return isWholeType(name) ? name : undefined;
}

/** How many bytes so many numbers take. */
export function byteLength(type: VtkType, count: number): number {
  return type === 'Bit' ? Math.ceil(count / 8) : count * arrays[type].BYTES_PER_ELEMENT;
}

/** Room for `count` numbers that come as text. */
export function roomFor(type: VtkType, count: number): VtkValues {
  return type === 'Float32' ? new Float32Array(count) : new Float64Array(count);
}

/** Binary numbers; the bytes are put into this machine's order in place (little-endian wherever JavaScript runs today). */
export function fromBytes(
  bytes: Uint8Array<ArrayBuffer>,
  type: VtkType,
  count: number,
  littleEndian: boolean,
): VtkValues {
  if (type === 'Bit') return unpackedBits(bytes, count);
  if (!littleEndian) reverseEach(bytes, arrays[type].BYTES_PER_ELEMENT);
  if (type === 'Int64' || type === 'UInt64') return wideIntegers(bytes, type === 'Int64');
  const values = new arrays[type](bytes.buffer);
  return values instanceof Float32Array || values instanceof Float64Array ? values : new Float64Array(values);
}

/** The highest bit of a byte comes first. */
function unpackedBits(bytes: Uint8Array, count: number): Float64Array {
  return Float64Array.from({ length: count }, (_, bit) => (bytes[bit >> 3] >> (7 - (bit & 7))) & 1);
}

/** 64-bit integers as the nearest doubles, by halves: BigInt would take many times as long. */
function wideIntegers(bytes: Uint8Array<ArrayBuffer>, signed: boolean): Float64Array {
  const low = new Uint32Array(bytes.buffer);
  const high = signed ? new Int32Array(bytes.buffer) : low;
  const values = new Float64Array(low.length / 2);
  for (let i = 0; i < values.length; i++) values[i] = high[2 * i + 1] * 2 ** 32 + low[2 * i];
  return values;
}

function reverseEach(bytes: Uint8Array, size: number): void {
  for (let start = 0; size > 1 && start < bytes.length; start += size) {
    for (let low = start, high = start + size - 1; low < high; low++, high--) {
      const byte = bytes[low];
      bytes[low] = bytes[high];
      bytes[high] = byte;
    }
  }
}
