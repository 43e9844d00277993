import { unzlibSync } from 'fflate';
import { Base64Bytes, type ByteStream, RawBytes } from '../bytes/byte-streams.ts';
import { FormatError } from '../format-error.ts';
import { AsciiNumbers } from '../text/ascii-numbers.ts';
import { counted, foreign, grouped, quoted } from '../text/wording.ts';
import {
  byteLength,
  fromBytes,
  isFloat,
  isVtkType,
  roomFor,
  type VtkType,
  type VtkValues,
} from '../vtk-data/vtk-values.ts';
import type { XmlNode } from './xml-tree.ts';

export interface AppendedData {
  /** As they are, or the letters of base64. */
  bytes: Uint8Array;
  base64: boolean;
}

/** Where the binary data of a VTK XML file is and how it is packed; the same for all its arrays. */
export interface VtkPacking {
  littleEndian: boolean;
  /** 4 or 8: the size of the numbers that stand before binary data. */
  headerSize: number;
  /** As the file calls it; empty where nothing is compressed. Text never is. */
  compressor: string;
  /** What follows the underscore in AppendedData. */
  appended: AppendedData | undefined;
  /** How many more bytes the arrays may take: what stands between a small file and a zlib bomb. */
  budget: { bytes: number };
}

/** Whether an array is of numbers that are read here: others are text, or in a form that VTK writes no more or not yet. */
export function isOfNumbers({ attributes: { type, format = '' } }: XmlNode): boolean {
  return isVtkType(type) && ['ascii', 'binary', 'appended'].includes(format);
}

export function isFloatArray({ attributes }: XmlNode): boolean {
  return isVtkType(attributes.type) && isFloat(attributes.type);
}

/**
 * The numbers of a DataArray: Float32 as it is, everything else in doubles. Throws unless there are exactly `count` of them;
 * `where` names the array in messages. Nothing is allocated that the file cannot fill.
 */
export function readDataArray(node: XmlNode, count: number, packing: VtkPacking, where: string): VtkValues {
  const { type, format } = node.attributes;
  if (!isVtkType(type)) {
    const message = `The ${where} is of type ${quoted(type ?? '')}, which is not read.`;
    throw new FormatError('unsupported_feature', message, where);
  }
  if (format === 'ascii') return readAscii(node.text, count, type, where);
  const bytes = readBytes(node, byteLength(type, count), packing, where);
  return fromBytes(bytes, type, count, packing.littleEndian);
}

function readAscii(text: string, count: number, type: VtkType, where: string): VtkValues {
  // A number takes a digit and a space.
  if (2 * count > text.length + 1) throw wrongCount(where, `fewer than ${grouped(count)} values`, count);
  const numbers = new AsciiNumbers(new TextEncoder().encode(text), 0, () => where);
  const values = roomFor(type, count);
  for (let i = 0; i < count; i++) {
    if (numbers.atEnd()) throw wrongCount(where, counted(i, 'value'), count);
    values[i] = numbers.next();
  }
  if (!numbers.atEnd()) throw wrongCount(where, `more than ${counted(count, 'value')}`, count);
  return values;
}

function wrongCount(where: string, has: string, needed: number): FormatError {
  return new FormatError('count_mismatch', `The ${where} has ${has}, but needs ${grouped(needed)}.`, where);
}

function readBytes(node: XmlNode, size: number, packing: VtkPacking, where: string): Uint8Array<ArrayBuffer> {
  if (size === 0) return new Uint8Array();
  packing.budget.bytes -= size;
  if (packing.budget.bytes < 0) {
    const message = `The ${where} would unpack to ${grouped(size)} bytes, far more than a file of this size holds.`;
    throw new FormatError('too_large', message, where);
  }
  const stream = openStream(node, packing, where);
  if (packing.compressor === '') return takePlain(stream, size, packing, where);
  requireZlib(packing.compressor);
  return takeCompressed(stream, size, packing, where);
}

function requireZlib(compressor: string): void {
  if (compressor === 'vtkZLibDataCompressor') return;
  const message = `The file is compressed by ${quoted(compressor)}; only zlib is read. Save it with zlib or without compression.`;
  throw new FormatError('unsupported_feature', message);
}

function openStream(node: XmlNode, { appended }: VtkPacking, where: string): ByteStream {
  const { format, offset } = node.attributes;
  if (format === 'binary') return new Base64Bytes(new TextEncoder().encode(node.text), 0, where);
  if (format !== 'appended') {
    throw new FormatError('unsupported_feature', `The ${where} has the unknown format ${quoted(format ?? '')}.`, where);
  }
  if (appended === undefined)
    throw new FormatError('truncated', `The ${where} is in AppendedData, which the file lacks.`, where);
  if (!/^\d{1,15}$/.test(offset ?? '')) {
    throw new FormatError('bad_header', `The ${where} has no valid offset into AppendedData.`, where);
  }
  if (appended.base64) return new Base64Bytes(appended.bytes, Number(offset), where);
  return new RawBytes(appended.bytes.subarray(Number(offset)), where);
}

/** Uncompressed data: the number of bytes, then these. */
function takePlain(stream: ByteStream, size: number, packing: VtkPacking, where: string): Uint8Array<ArrayBuffer> {
  const [length] = takeHeader(stream, 1, packing);
  if (length !== size) throw wrongSize(where, length, size);
  return stream.take(size);
}

/**
 * Compressed data: the number of blocks, the size of a block, the size of the last one if it is smaller (else 0), the
 * compressed size of each, then the blocks.
 */
function takeCompressed(stream: ByteStream, size: number, packing: VtkPacking, where: string): Uint8Array<ArrayBuffer> {
  const [blocks, blockSize, lastSize] = takeHeader(stream, 3, packing) as [number, number, number];
  const total = lastSize === 0 ? blocks * blockSize : (blocks - 1) * blockSize + lastSize;
  if (total !== size || blocks < 1) throw wrongSize(where, total, size);
  const sizes = takeHeader(stream, blocks, packing);
  const bytes = new Uint8Array(size);
  for (const [index, compressedSize] of sizes.entries()) {
    const isLast = index === blocks - 1 && lastSize > 0;
    const room = bytes.subarray(index * blockSize, index * blockSize + (isLast ? lastSize : blockSize));
    inflate(stream.take(compressedSize), room, where);
  }
  return bytes;
}

function takeHeader(stream: ByteStream, words: number, { headerSize, littleEndian }: VtkPacking): number[] {
  const bytes = stream.take(words * headerSize);
  const view = new DataView(bytes.buffer);
  return Array.from({ length: words }, (_, word) =>
    headerSize === 8 ? Number(view.getBigUint64(8 * word, littleEndian)) : view.getUint32(4 * word, littleEndian),
  );
}

function wrongSize(where: string, has: number, needed: number): FormatError {
  return new FormatError(
    'count_mismatch',
    `The ${where} has ${grouped(has)} bytes, but needs ${grouped(needed)}.`,
    where,
  );
}

/** Unpacks one zlib stream that must fill `room` exactly. fflate does not look at the checksum, so that is done here. */
function inflate(compressed: Uint8Array, room: Uint8Array, where: string): void {
  const oneMore = new Uint8Array(room.length + 1);
  let unpacked: Uint8Array;
  try {
    unpacked = unzlibSync(compressed, { out: oneMore });
  } catch (error) {
    throw new FormatError(
      'corrupt',
      `The compressed ${where} cannot be unpacked (${foreign((error as Error).message)}).`,
      where,
    );
  }
  const checksum = new DataView(compressed.buffer, compressed.byteOffset + compressed.length - 4).getUint32(0);
  if (unpacked.length !== room.length || adler32(unpacked) !== checksum) {
    throw new FormatError('corrupt', `The compressed ${where} is damaged: its size or checksum is wrong.`, where);
  }
  room.set(unpacked);
}

function adler32(bytes: Uint8Array): number {
  const modulus = 65521;
  // So many bytes at once keep both sums below 2^31, where arithmetic is fastest.
  const run = 3800;
  let [a, b] = [1, 0];
  for (let start = 0; start < bytes.length; start += run) {
    const end = Math.min(start + run, bytes.length);
    for (let i = start; i < end; i++) {
      a += bytes[i];
      b += a;
    }
    a %= modulus;
    b %= modulus;
  }
  return b * 65536 + a;
}
