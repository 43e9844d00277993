import { noPolygons, type Polygons } from '../faces/polygons.ts';
import { FormatError } from '../format-error.ts';
import { regionNotes } from '../regions/region-notes.ts';
import { type CellLabels, type Labels, noLabels, type Surface } from '../surface.ts';
import { cutNotes as lineBreakNotes } from '../text/text-lines.ts';
import { counted, grouped, listed, quoted } from '../text/wording.ts';
import { isGhostArray, withoutGhosts } from '../vtk-data/vtk-ghosts.ts';
import {
  cellDataAdvice,
  declaredIn,
  labelsOfTriangles,
  meshOfPieces,
  misfitAmong,
  namedArrays,
  type PointArray,
} from '../vtk-data/vtk-pieces.ts';
import { isFloat } from '../vtk-data/vtk-values.ts';
import { type Attributes, readAttribute, readField, readMetadata } from './legacy-vtk-arrays.ts';
import { readCells } from './legacy-vtk-cells.ts';
import { decodeName, LegacyVtkText } from './legacy-vtk-text.ts';
import { countOf, typeOf } from './legacy-vtk-words.ts';

// Written by hand: no package reads these files with all their arrays (vtk.js: ASCII up to version 4 without FIELD arrays).

interface Parts {
  version: number;
  /** Keywords of what has been read and cannot come again. */
  found: Set<string>;
  position: PointArray | undefined;
  polygons: Polygons;
  strips: Polygons;
  verts: number;
  lines: number;
  colourMaps: string[];
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
  const changes: string[] = [];
  const arrays = namedArrays(points.arrays, points.noun, changes);
  const ghosts = parts.cells.arrays.filter(({ name }) => isGhostArray(name) && areForCells(parts));
  const piece = withoutGhosts({ prefix: '', position, arrays, polygons, strips }, ghosts, parts.verts + parts.lines);
  const mesh = meshOfPieces([piece], changes);
  const { regions, unfitRegions } = readRegions(parts, piece.polygons);
  const notes = [...lossNotes(parts, regions), ...regionNotes(regions), ...changes, ...cutNotes(bytes, text, points)];
  return { mesh, notes, ...labels, ...declaredIn([piece], mesh.variables), regions, unfitRegions };
}

/** Cell data of one whole number a cell, as labels of the triangles; of files without strips, whose triangles follow the cells. */
function readRegions(parts: Parts, shown: Polygons): CellLabels {
  const { cells, strips, verts, lines } = parts;
  const regions = new Map<string, Int32Array>();
  const unfitRegions = new Map<string, string>();
  const before = verts + lines;
  if (strips.ends.length > 0 || !areForCells(parts)) return { regions, unfitRegions };
  for (const { name, values } of cells.arrays.filter((array) => array.name !== '' && !isGhostArray(array.name))) {
    const misfit = misfitAmong(values);
    if (misfit === undefined) regions.set(name, labelsOfTriangles(values, before, shown));
    else unfitRegions.set(name, misfit);
  }
  return { regions, unfitRegions };
}

/** Whether there are as many values of cells as cells. */
function areForCells({ cells, polygons, strips, verts, lines }: Parts): boolean {
  return cells.tuples === verts + lines + polygons.ends.length + strips.ends.length;
}

function newParts(version: number): Parts {
  const none = (noun: string): Attributes => ({ noun, tuples: undefined, arrays: [], lost: [] });
  const [points, cells, file] = [none('point data'), none('cell data'), none('field data')];
  const shape = { position: undefined, polygons: noPolygons, strips: noPolygons, verts: 0, lines: 0 };
  return { version, found: new Set(), ...shape, colourMaps: [], points, cells, file, labels: noLabels() };
}

/** The four lines that every file begins with; returns the version's first number. */
function readHead(text: LegacyVtkText): number {
  const version = /Version\s+(\d+)/i.exec(text.words().join(' '))?.[1];
  const encoding = readEncoding(text);
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

/** The line behind the title. Either may have empty lines around it, and the title may be empty itself. */
function readEncoding(text: LegacyVtkText): 'ASCII' | 'BINARY' {
  const encodingOf = (words: string[]) => {
    const word = words.join(' ').toUpperCase();
    return word === 'ASCII' || word === 'BINARY' ? word : undefined;
  };
  const title = encodingOf(text.words());
  // A title may be one of these words as well.
  if (title && text.peek()[0]?.toUpperCase() === 'DATASET') return title;
  const words = text.words();
  const encoding = encodingOf(words);
  if (encoding) return encoding;
  const code = text.atEnd() ? 'truncated' : 'bad_header';
  const message = `ASCII or BINARY should stand behind the title, but ${quoted(words.join(' '))} does (${text.place()}).`;
  throw new FormatError(code, message, text.place());
}

/** What a surface has once: a second one would contradict the first. */
const single = new Set(['POINTS', 'POLYGONS', 'TRIANGLE_STRIPS', 'VERTICES', 'LINES']);

/** Reads what a keyword announces; returns the attributes that the arrays from here on belong to. */
function readSection(words: string[], text: LegacyVtkText, parts: Parts, attributes: Attributes): Attributes {
  const keyword = words[0].toUpperCase();
  if (single.has(keyword)) requireFirst(keyword, text, parts.found);
  if (keyword === 'POINTS') readPoints(words, text, parts);
  else if (keyword === 'POLYGONS') parts.polygons = readCells(words, text, parts.version);
  else if (keyword === 'TRIANGLE_STRIPS') parts.strips = readCells(words, text, parts.version);
  else if (keyword === 'VERTICES') parts.verts = readCells(words, text, parts.version).ends.length;
  else if (keyword === 'LINES') parts.lines = readCells(words, text, parts.version).ends.length;
  else if (keyword === 'POINT_DATA') return beginPointData(words, text, parts);
  else if (keyword === 'CELL_DATA') return Object.assign(parts.cells, { tuples: countOf(words[1], text) });
  else if (keyword === 'METADATA') skipMetadata(text);
  else if (keyword === 'LOOKUP_TABLE') skipLookupTable(words, text, parts.colourMaps);
  else if (keyword === 'FIELD') readField(words, text, attributes, parts.labels);
  else readAttribute(keyword, words, text, attributes, parts.labels);
  return attributes;
}

function requireFirst(keyword: string, text: LegacyVtkText, found: Set<string>): void {
  if (found.has(keyword)) {
    throw new FormatError('bad_header', `There are ${keyword} a second time (${text.place()}).`, text.place());
  }
  found.add(keyword);
}

function readPoints([, count, typeWord]: string[], text: LegacyVtkText, parts: Parts): void {
  const type = typeOf(typeWord, text);
  const values = text.numbers(type, 3 * countOf(count, text), 'array “POINTS”');
  parts.position = { name: 'position', components: 3, values, integers: !isFloat(type) };
  readMetadata(text, parts.position, parts.labels);
}

function beginPointData(words: string[], text: LegacyVtkText, parts: Parts): Attributes {
  if (!parts.position) {
    throw new FormatError('bad_header', `POINT_DATA stands before the POINTS (${text.place()}).`, text.place());
  }
  const tuples = countOf(words[1], text);
  const points = parts.position.values.length / 3;
  if (tuples !== points) {
    const message = `POINT_DATA is for ${counted(tuples, 'point')}, but the file has ${grouped(points)} (${text.place()}).`;
    throw new FormatError('count_mismatch', message, text.place());
  }
  return Object.assign(parts.points, { tuples });
}

/** Colours of a colour map: four bytes each, in text four numbers. */
function skipLookupTable(words: string[], text: LegacyVtkText, names: string[]): void {
  names.push(decodeName(words[1] ?? '', text.place()));
  text.numbers(text.binary ? 'UInt8' : 'Float32', 4 * countOf(words[2], text), 'LOOKUP_TABLE');
}

function skipMetadata(text: LegacyVtkText): void {
  for (let line = text.line(); line; line = text.line());
}

function lossNotes(
  { points, cells, file, verts, lines, colourMaps }: Parts,
  regions: ReadonlyMap<string, unknown>,
): string[] {
  const unfit = cells.arrays.map(({ name }) => name).filter((name) => !regions.has(name) && !isGhostArray(name));
  const ofCells = { noun: cells.noun, lost: [...cells.lost, ...unfit] };
  const named = [points, ofCells, file].filter(({ lost }) => lost.length > 0);
  const lost = named.map(({ noun, lost: names }) => `${noun} ${listed(names)}`);
  if (verts > 0) lost.push(counted(verts, 'vertex cell'));
  if (lines > 0) lost.push(counted(lines, 'line'));
  if (colourMaps.length > 0) lost.push(`colour maps ${listed(colourMaps)}`);
  const notes = lost.length > 0 ? [`Not carried: ${lost.join('; ')}.`] : [];
  return ofCells.lost.length > 0 ? [...notes, cellDataAdvice] : notes;
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
