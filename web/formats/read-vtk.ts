import { FormatError } from './format-error.ts';
import { decodeName, LegacyVtkText } from './legacy-vtk-text.ts';
import { noPolygons, type Polygons } from './polygons.ts';
import { type Labels, noLabels, type Surface } from './surface.ts';
import { cutNotes as lineBreakNotes } from './text-lines.ts';
import { asEnds, asIndices, meshOfPieces, type PointArray } from './vtk-pieces.ts';
import { isFloat, type VtkType, type VtkValues } from './vtk-values.ts';
import { counted, grouped, listed, quoted } from './wording.ts';

// Written by hand: no package reads these files with all their arrays (vtk.js: ASCII up to version 4 without FIELD arrays).

const types = new Map<string, VtkType>([
  ['char', 'Int8'],
  ['signed_char', 'Int8'],
  ['unsigned_char', 'UInt8'],
  ['short', 'Int16'],
  ['unsigned_short', 'UInt16'],
  ['int', 'Int32'],
  ['unsigned_int', 'UInt32'],
  // As on every 64-bit system but Windows, where VTK writes long_long instead.
  ['long', 'Int64'],
  ['unsigned_long', 'UInt64'],
  ['long_long', 'Int64'],
  ['unsigned_long_long', 'UInt64'],
  ['vtktypeint64', 'Int64'],
  ['vtktypeuint64', 'UInt64'],
  // Always written as int, whatever its size in memory.
  ['vtkidtype', 'Int32'],
  ['float', 'Float32'],
  ['double', 'Float64'],
]);

/** Attributes with a fixed number of components: KEYWORD name type. */
const fixedAttributes = new Map([
  ['VECTORS', 3],
  ['NORMALS', 3],
  ['TENSORS', 9],
  ['TENSORS6', 6],
  ['GLOBAL_IDS', 1],
  ['PEDIGREE_IDS', 1],
  ['EDGE_FLAGS', 1],
]);

/** Arrays are read alike for points (kept), for cells and for the whole file (only their names are kept). */
interface Attributes {
  noun: string;
  /** How many tuples an array must have; undefined where each says so itself. */
  tuples: number | undefined;
  arrays: PointArray[];
  /** What is skipped: text arrays of points, all arrays of others. */
  lost: string[];
}

interface Parts {
  version: number;
  position: PointArray | undefined;
  polygons: Polygons;
  strips: Polygons;
  verts: number;
  lines: number;
  points: Attributes;
  cells: Attributes;
  file: Attributes;
  labels: Labels;
}

/**
 * Reads a legacy VTK file with DATASET POLYDATA, text or binary, versions 1 to 5.1. Every numeric point-data array
 * (SCALARS, VECTORS, NORMALS, TENSORS, TEXTURE_COORDINATES, ids, FIELD) becomes a variable; units and component names come
 * from METADATA. Precision as in readVtp.
 */
export function readVtk(bytes: Uint8Array): Surface {
  const text = new LegacyVtkText(bytes);
  const parts = newParts(readHead(text));
  let attributes = parts.file;
  for (let words = text.words(); words.length > 0; words = text.words()) {
    attributes = readSection(words, text, parts, attributes);
  }
  const { position, polygons, strips, points, labels } = parts;
  if (!position) throw new FormatError('no_points', 'The file has no POINTS.');
  const notes = lossNotes(parts);
  const mesh = meshOfPieces([{ prefix: '', position, arrays: points.arrays, polygons, strips }], notes);
  notes.push(...cutNotes(bytes, text, points));
  return { mesh, notes, ...labels };
}

function newParts(version: number): Parts {
  const none = (noun: string): Attributes => ({ noun, tuples: undefined, arrays: [], lost: [] });
  const [points, cells, file] = [none('point data'), none('cell data'), none('field data')];
  const shape = { position: undefined, polygons: noPolygons, strips: noPolygons, verts: 0, lines: 0 };
  return { version, ...shape, points, cells, file, labels: noLabels() };
}

/** The four lines that every file begins with; returns the version's first number. */
function readHead(text: LegacyVtkText): number {
  const version = /Version\s+(\d+)/i.exec(text.line() ?? '')?.[1];
  text.line();
  const encoding = (text.line() ?? '').toUpperCase();
  if (encoding !== 'ASCII' && encoding !== 'BINARY') {
    const code = text.atEnd() ? 'truncated' : 'bad_header';
    throw new FormatError(code, `Line 3 should say ASCII or BINARY, but says ${quoted(encoding)}.`, 'line 3');
  }
  const [keyword = '', kind = ''] = text.words();
  if (keyword.toUpperCase() !== 'DATASET') {
    const code = text.atEnd() ? 'truncated' : 'bad_header';
    throw new FormatError(code, `${quoted(keyword)} stands where DATASET should.`, text.place());
  }
  if (kind.toUpperCase() !== 'POLYDATA') {
    if (text.atEnd()) throw new FormatError('truncated', 'The file ends after its first lines.', text.place());
    const advice = 'Extract its surface first (in ParaView: Extract Surface).';
    throw new FormatError('unsupported_format', `This VTK file holds a ${quoted(kind)}, not POLYDATA. ${advice}`);
  }
  text.binary = encoding === 'BINARY';
  return Number(version ?? 1);
}

/** Reads what a keyword announces; returns the attributes that the arrays from here on belong to. */
function readSection(words: string[], text: LegacyVtkText, parts: Parts, attributes: Attributes): Attributes {
  const keyword = words[0].toUpperCase();
  if (keyword === 'POINTS') readPoints(words, text, parts);
  else if (keyword === 'POLYGONS') parts.polygons = readCells(words, text, parts.version);
  else if (keyword === 'TRIANGLE_STRIPS') parts.strips = readCells(words, text, parts.version);
  else if (keyword === 'VERTICES') parts.verts = readCells(words, text, parts.version).ends.length;
  else if (keyword === 'LINES') parts.lines = readCells(words, text, parts.version).ends.length;
  else if (keyword === 'POINT_DATA') return beginPointData(words, text, parts);
  else if (keyword === 'CELL_DATA') return Object.assign(parts.cells, { tuples: countOf(words[1], text) });
  else if (keyword === 'METADATA') skipMetadata(text);
  else if (keyword === 'LOOKUP_TABLE') skipLookupTable(words, text);
  else if (keyword === 'FIELD') readField(words, text, attributes, parts.labels);
  else readAttribute(keyword, words, text, attributes, parts.labels);
  return attributes;
}

function countOf(word: string | undefined, text: LegacyVtkText): number {
  if (/^\d{1,15}$/.test(word ?? '')) return Number(word);
  const message = `${quoted(word ?? '')} stands where a count should (${text.place()}).`;
  throw new FormatError(text.atEnd() ? 'truncated' : 'bad_header', message, text.place());
}

function typeOf(word: string | undefined, text: LegacyVtkText): VtkType {
  const type = types.get(word?.toLowerCase() ?? '');
  if (type) return type;
  const message = `${quoted(word ?? '')} is no type of numbers that is read here (${text.place()}).`;
  throw new FormatError(text.atEnd() ? 'truncated' : 'unsupported_feature', message, text.place());
}

function readPoints([, count, typeWord]: string[], text: LegacyVtkText, parts: Parts): void {
  const type = typeOf(typeWord, text);
  const values = text.numbers(type, 3 * countOf(count, text), 'array “POINTS”');
  parts.position = { name: 'position', components: 3, values, integers: !isFloat(type) };
  readMetadata(text, parts.position, parts.labels);
}

/** Cells are lists with their lengths in one array, from version 5 on two arrays of ends and corners. */
function readCells(words: string[], text: LegacyVtkText, version: number): Polygons {
  const [first, second] = [countOf(words[1], text), countOf(words[2], text)];
  const where = `array “${words[0].toUpperCase()}”`;
  if (version < 5) return splitLists(text.numbers('Int32', second, where), first, where);
  const read = (keyword: string, count: number) => {
    const [found = '', type] = text.words();
    if (found.toUpperCase() === keyword) return text.numbers(typeOf(type, text), count, `${where}, ${keyword}`);
    const message = `${quoted(found)} stands where ${keyword} should (${text.place()}).`;
    throw new FormatError(text.atEnd() ? 'truncated' : 'bad_header', message, text.place());
  };
  const offsets = asEnds(read('OFFSETS', first), `${where}, OFFSETS`);
  const corners = asIndices(read('CONNECTIVITY', second), `${where}, CONNECTIVITY`);
  const last = offsets.at(-1) ?? 0;
  if ((offsets[0] ?? 0) !== 0 || last !== corners.length) {
    const message = `The OFFSETS of the ${where} should run from 0 to ${grouped(corners.length)}.`;
    throw new FormatError('count_mismatch', message, where);
  }
  return { corners, ends: offsets.slice(1) };
}

function splitLists(values: VtkValues, count: number, where: string): Polygons {
  if (count > values.length) {
    throw new FormatError('count_mismatch', `The ${where} has more cells than numbers.`, where);
  }
  const ends = new Uint32Array(count);
  const corners = new Float64Array(values.length - count);
  let [from, to] = [0, 0];
  for (let cell = 0; cell < count; cell++) {
    const length = values[from];
    if (!(Number.isInteger(length) && length >= 0 && from + 1 + length <= values.length)) {
      const message = `Cell ${cell} of the ${where} claims ${length} corners, which do not fit.`;
      throw new FormatError('bad_polygon', message, where);
    }
    for (let corner = 1; corner <= length; corner++) corners[to++] = values[from + corner];
    from += 1 + length;
    ends[cell] = to;
  }
  if (from === values.length) return { corners: asIndices(corners, where), ends };
  const message = `The ${where} has ${counted(values.length, 'number')}, but its cells take ${grouped(from)}.`;
  throw new FormatError('count_mismatch', message, where);
}

function beginPointData(words: string[], text: LegacyVtkText, parts: Parts): Attributes {
  const tuples = countOf(words[1], text);
  const points = (parts.position?.values.length ?? 0) / 3;
  if (tuples !== points) {
    const message = `POINT_DATA is for ${counted(tuples, 'point')}, but the file has ${grouped(points)} (${text.place()}).`;
    throw new FormatError('count_mismatch', message, text.place());
  }
  return Object.assign(parts.points, { tuples });
}

function readAttribute(
  keyword: string,
  words: string[],
  text: LegacyVtkText,
  attributes: Attributes,
  labels: Labels,
): void {
  const { tuples } = attributes;
  const components = componentsOf(keyword, words, text);
  if (components === undefined || tuples === undefined) {
    const message = `${quoted(words[0])} is not known here (${text.place()}).`;
    throw new FormatError('bad_header', message, text.place());
  }
  let type = words[keyword === 'TEXTURE_COORDINATES' ? 3 : 2];
  // Bytes in binary files, numbers from 0 to 1 in text.
  if (keyword === 'COLOR_SCALARS') type = text.binary ? 'unsigned_char' : 'float';
  if (keyword === 'SCALARS' && text.peek()[0]?.toUpperCase() === 'LOOKUP_TABLE') text.words();
  readArray({ name: words[1], components, tuples, type }, text, attributes, labels);
}

function componentsOf(keyword: string, words: string[], text: LegacyVtkText): number | undefined {
  if (keyword === 'SCALARS') return words.length > 3 ? countOf(words[3], text) : 1;
  if (keyword === 'COLOR_SCALARS' || keyword === 'TEXTURE_COORDINATES') return countOf(words[2], text);
  return fixedAttributes.get(keyword);
}

function readField(words: string[], text: LegacyVtkText, attributes: Attributes, labels: Labels): void {
  const count = countOf(words[2], text);
  for (let index = 0; index < count; index++) {
    const [name, components, tuples, type] = text.words();
    const shape = { name, components: countOf(components, text), tuples: countOf(tuples, text), type };
    if (attributes.tuples !== undefined && shape.tuples !== attributes.tuples) {
      const has = `has ${grouped(shape.tuples)} tuples, but needs ${grouped(attributes.tuples)}`;
      throw new FormatError('count_mismatch', `The array ${quoted(name)} of ${attributes.noun} ${has}.`, quoted(name));
    }
    readArray(shape, text, attributes, labels);
  }
}

interface ArrayShape {
  name: string | undefined;
  components: number;
  tuples: number;
  type: string | undefined;
}

function readArray(shape: ArrayShape, text: LegacyVtkText, attributes: Attributes, labels: Labels): void {
  const { components, tuples } = shape;
  const name = decodeName(shape.name ?? '', text.place());
  const where = `array ${quoted(name)}`;
  const type = shape.type?.toLowerCase();
  const isPoints = attributes.noun === 'point data';
  const array: PointArray = { name, components, values: new Float32Array(), integers: false };
  if (type === 'string' || type === 'utf8_string' || type === 'variant') {
    skipTexts(type, components * tuples, text, where);
  } else if (type === 'bit') {
    Object.assign(array, { values: readBits(components * tuples, text, where), integers: true });
  } else {
    const numberType = typeOf(type, text);
    Object.assign(array, {
      values: text.numbers(numberType, components * tuples, where),
      integers: !isFloat(numberType),
    });
  }
  readMetadata(text, array, isPoints ? labels : noLabels());
  if (isPoints && components > 0 && array.values.length === components * tuples) attributes.arrays.push(array);
  else attributes.lost.push(name);
}

function readBits(count: number, text: LegacyVtkText, where: string): VtkValues {
  if (!text.binary) return text.numbers('UInt8', count, where);
  const bytes = text.block(Math.ceil(count / 8), where);
  return Float64Array.from({ length: count }, (_, bit) => (bytes[bit >> 3] >> (7 - (bit & 7))) & 1);
}

/** Texts stand on lines of their own, but in binary files those of plain strings have their lengths before them. */
function skipTexts(type: string, count: number, text: LegacyVtkText, where: string): void {
  for (let index = 0; index < count; index++) {
    if (text.binary && type !== 'variant') text.block(stringLength(text, where), where);
    else if (text.line() === undefined) throw new FormatError('truncated', `The file ends in the ${where}.`, where);
  }
}

/** The two highest bits of the first byte tell how many bytes the length takes: 3 for one, 2 for two, 1 for four, 0 for eight. */
function stringLength(text: LegacyVtkText, where: string): number {
  const [first] = text.block(1, where);
  const more = text.block([7, 3, 1, 0][first >> 6], where);
  return more.reduce((length, byte) => length * 256 + byte, first & 63);
}

/** Colours of a colour map: four bytes each, in text four numbers. */
function skipLookupTable(words: string[], text: LegacyVtkText): void {
  text.numbers(text.binary ? 'UInt8' : 'Float32', 4 * countOf(words[2], text), 'LOOKUP_TABLE');
}

/** The METADATA that may follow an array, up to the next empty line: names of components, and the unit among other things. */
function readMetadata(text: LegacyVtkText, { name, components }: PointArray, { units, componentNames }: Labels): void {
  const [keyword, ...more] = text.peek();
  // An array of a FIELD may have this name too, but then its line goes on.
  if (keyword?.toUpperCase() !== 'METADATA' || more.length > 0) return;
  text.words();
  let key = '';
  for (let line = text.line(); line; line = text.line()) {
    const [word, value = ''] = line.split(/\s+/);
    if (word === 'NAME') key = value;
    if (word === 'DATA' && key === 'UNITS_LABEL') units[name] = decodeName(value, text.place());
    if (word !== 'COMPONENT_NAMES') continue;
    const names: string[] = [];
    for (let next = text.peek()[0]; next && names.length < components; next = text.peek()[0]) {
      names.push(decodeName(text.words()[0], text.place()));
    }
    if (names.length === components) componentNames[name] = names;
  }
}

function skipMetadata(text: LegacyVtkText): void {
  for (let line = text.line(); line; line = text.line());
}

function lossNotes({ points, cells, file, verts, lines }: Parts): string[] {
  const named = [points, cells, file].filter(({ lost }) => lost.length > 0);
  const lost = named.map(({ noun, lost: names }) => `${noun} ${listed(names)}`);
  if (verts > 0) lost.push(counted(verts, 'vertex cell'));
  if (lines > 0) lost.push(counted(lines, 'line'));
  return lost.length > 0 ? [`Not carried: ${lost.join('; ')}.`] : [];
}

/** The format declares no length, so a file that was cut between two arrays looks whole. What can be suspected is said. */
function cutNotes(bytes: Uint8Array, text: LegacyVtkText, points: Attributes): string[] {
  const notes: string[] = [];
  if (points.tuples !== undefined && points.arrays.length + points.lost.length === 0) {
    notes.push('POINT_DATA is empty: the file may have been cut short.');
  }
  if (!text.binary) notes.push(...lineBreakNotes(bytes));
  return notes;
}
