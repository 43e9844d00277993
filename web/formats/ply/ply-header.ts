import { FormatError } from '../format-error.ts';
import { looseText, undecoded } from '../text/utf8-text.ts';
import { quoted } from '../text/wording.ts';

export type PlyType = 'int8' | 'uint8' | 'int16' | 'uint16' | 'int32' | 'uint32' | 'float32' | 'float64';

export interface PlyProperty {
  name: string;
  type: PlyType;
  /** The type of a list's length; undefined for a plain number. */
  listLength?: PlyType;
}

export interface PlyElement {
  name: string;
  count: number;
  properties: PlyProperty[];
}

export interface PlyHeader {
  encoding: 'ascii' | 'binary_little_endian' | 'binary_big_endian';
  comments: string[];
  /** Comments need not be, and are no fault unless they have names or units. */
  isUtf8: boolean;
  elements: PlyElement[];
  /** Where the data begins, in bytes. */
  end: number;
}

const types: Record<string, PlyType> = {
  char: 'int8',
  uchar: 'uint8',
  short: 'int16',
  ushort: 'uint16',
  int: 'int32',
  uint: 'uint32',
  float: 'float32',
  double: 'float64',
};
const typeNames = new Map([...Object.entries(types), ...Object.values(types).map((type) => [type, type] as const)]);
const encodings = ['ascii', 'binary_little_endian', 'binary_big_endian'] as const;
const longestHeader = 1 << 20;

export const plyTypeSizes: Record<PlyType, number> = {
  int8: 1,
  uint8: 1,
  int16: 2,
  uint16: 2,
  int32: 4,
  uint32: 4,
  float32: 4,
  float64: 8,
};

export function isFloatType(type: PlyType): boolean {
  return type === 'float32' || type === 'float64';
}

/** Reads the header, from `ply` to `end_header`. Names are as in the file, types by their sized names. */
export function readPlyHeader(bytes: Uint8Array): PlyHeader {
  const { lines, isUtf8, end } = headerLines(bytes);
  const header: PlyHeader = { encoding: 'ascii', comments: [], isUtf8, elements: [], end };
  let encoding: PlyHeader['encoding'] | undefined;
  for (const [index, line] of lines.entries()) {
    const where = `header line ${index + 1}`;
    const words = line.trim().split(/\s+/);
    if (words[0] === 'format') encoding = parseEncoding(words[1] ?? '', where);
    else if (words[0] === 'comment') header.comments.push(line.trim().slice('comment'.length).trim());
    else if (words[0] === 'element') addElement(header, words, where);
    else if (words[0] === 'property') addProperty(header, words, where);
    else if (words[0] !== 'ply' && words[0] !== 'obj_info' && words[0] !== '') {
      throw badHeader(`${quoted(line.trim())} is not a line of a PLY header`, where);
    }
  }
  if (!encoding) throw badHeader('There is no format line', 'header');
  checkNamesDiffer(header.elements, 'element', 'header');
  for (const { name, properties } of header.elements)
    checkNamesDiffer(properties, 'property', `element ${quoted(name)}`);
  return { ...header, encoding };
}

const lineBreak = /\r\n|\n|\r/;

/**
 * Lines may end in \n, \r\n or \r, each in its own way. Only where all before the last one end in \r is a \n behind that
 * one not part of it: binary data may begin with any of these bytes.
 */
function headerLines(bytes: Uint8Array): { lines: string[]; isUtf8: boolean; end: number } {
  const oneByteACharacter = new TextDecoder('latin1').decode(bytes.subarray(0, longestHeader));
  const last = /[\r\n]end_header[ \t]*(?:\r\n|\n|\r)/.exec(oneByteACharacter);
  if (!last) {
    const message = 'The PLY header does not end: there is no line “end_header”.';
    throw new FormatError(bytes.length > longestHeader ? 'bad_header' : 'truncated', message, 'header');
  }
  const { text, isUtf8 } = looseText(bytes.subarray(0, last.index));
  const onlyReturns = !oneByteACharacter.slice(0, last.index + 1).includes('\n');
  const end = last.index + last[0].length - (onlyReturns && last[0].endsWith('\r\n') ? 1 : 0);
  return { lines: text.split(lineBreak), isUtf8, end };
}

function badHeader(sentence: string, where: string): FormatError {
  return new FormatError('bad_header', `${sentence} (${where}).`, where);
}

function checkNamesDiffer(things: { name: string }[], noun: string, where: string): void {
  const seen = new Set<string>();
  for (const { name } of things) {
    if (seen.has(name)) {
      throw new FormatError('duplicate_name', `The ${noun} ${quoted(name)} is declared twice in the ${where}.`, where);
    }
    seen.add(name);
  }
}

function parseEncoding(word: string, where: string): PlyHeader['encoding'] {
  const encoding = encodings.find((known) => known === word);
  if (!encoding) throw badHeader(`${quoted(word)} is no PLY encoding; known are ${encodings.join(', ')}`, where);
  return encoding;
}

function addElement(header: PlyHeader, words: string[], where: string): void {
  const [, name = '', count = ''] = words;
  if (words.length !== 3 || !/^\d{1,15}$/.test(count)) {
    throw badHeader('An element needs a name and a count that is a whole number', where);
  }
  header.elements.push({ name, count: Number(count), properties: [] });
}

function addProperty(header: PlyHeader, words: string[], where: string): void {
  const element = header.elements.at(-1);
  if (!element) throw badHeader('A property stands before the first element', where);
  const isList = words[1] === 'list';
  if (words.length !== (isList ? 5 : 3)) throw badHeader('A property needs a type and a name', where);
  const [type, name] = words.slice(-2);
  if (name.includes(undecoded)) {
    throw new FormatError('bad_encoding', `The name of a property is not UTF-8 (${where}).`, where);
  }
  const property: PlyProperty = { name, type: parseType(type, where) };
  if (isList) property.listLength = parseLengthType(words[2], where);
  element.properties.push(property);
}

function parseType(word: string, where: string): PlyType {
  const type = typeNames.get(word);
  if (!type) throw badHeader(`${quoted(word)} is no PLY type`, where);
  return type;
}

function parseLengthType(word: string, where: string): PlyType {
  const type = parseType(word, where);
  if (isFloatType(type)) throw badHeader(`The length of a list cannot be a ${word}`, where);
  return type;
}
