import type { Variable } from '../../../wasm/types.ts';
import { expansionLimit } from '../bytes/expansion-limit.ts';
import { joined } from '../bytes/joined-arrays.ts';
import { weld } from '../cracks/weld.ts';
import { sealed } from '../cracks/welded-surface.ts';
import { noPolygons, type Polygons } from '../faces/polygons.ts';
import { FormatError } from '../format-error.ts';
import { regionNotes } from '../regions/region-notes.ts';
import { type CellLabels, type Labels, noLabels, type Surface } from '../surface.ts';
import { counted, listed, quoted } from '../text/wording.ts';
import { type Role, roleSpelled } from '../variables/roles.ts';
import { isGhostArray, withoutGhosts } from '../vtk-data/vtk-ghosts.ts';
import {
  asEnds,
  asIndices,
  cellDataAdvice,
  declaredIn,
  labelsOfTriangles,
  meshOfPieces,
  misfitAmong,
  namedArrays,
  type Piece,
  type PointArray,
} from '../vtk-data/vtk-pieces.ts';
import type { VtkValues } from '../vtk-data/vtk-values.ts';
import { isVtkType, wholeTypeOf } from '../vtk-data/vtk-values.ts';
import { type AppendedData, isFloatArray, isOfNumbers, readDataArray, type VtkPacking } from './vtk-data-array.ts';
import { childrenOf, parseXml, type XmlNode } from './xml-tree.ts';

// Written by hand on top of an XML parser and an inflater, although vtk.js has an XMLPolyDataReader. On files that VTK writes by
// default that one fails (doubles inline behind 32-bit headers) or loses data (64-bit integers beyond 32 bits); it knows
// no big-endian files; and it fills short arrays with zeros, allocates and inflates whatever a header declares.

/**
 * Reads a VTP file (VTK XML PolyData): ASCII, inline base64, appended raw or base64, plain or zlib, either byte order.
 * Polygons and strips are triangulated, pieces joined. Every numeric point-data array becomes a variable: Float32 and Float64 as they
 * are, integers in single precision where that holds every value exactly, else in double. Units come from the information
 * key UNITS_LABEL of an array.
 */
export function readVtp(bytes: Uint8Array): Surface {
  const { root, appended } = openDocument(bytes);
  checkKind(root);
  const data = onlyOne(childrenOf(root, 'PolyData'), 'PolyData');
  const pieceNodes = data ? childrenOf(data, 'Piece') : [];
  const packing = packingOf(root, appended, bytes.length);
  const changes: string[] = [];
  const pieces = pieceNodes.map((node, index) =>
    readPiece(node, packing, pieceNodes.length > 1 ? `piece ${index} ` : '', changes),
  );
  const mesh = meshOfPieces(pieces, changes);
  const { regions, unfitRegions } = readRegions(pieceNodes, pieces, packing);
  const notes = [...notCarried(data, pieceNodes, regions), ...regionNotes(regions), ...changes];
  const labels = { ...labelsOf(pieceNodes, mesh.variables), ...declaredIn(pieces, mesh.variables) };
  // Pieces repeat the points where they meet.
  const joinedPieces = pieces.length > 1 ? sealed(weld(mesh), notes) : { mesh, notes };
  return { ...joinedPieces, ...labels, regions, unfitRegions };
}

/** Cell data of one whole number a cell, as labels of the triangles; of files without strips, whose triangles follow the cells. */
function readRegions(nodes: XmlNode[], pieces: Piece[], packing: VtkPacking): CellLabels {
  const regions = new Map<string, Int32Array>();
  const unfitRegions = new Map<string, string>();
  if (nodes.length === 0 || pieces.some(({ strips }) => strips.ends.length > 0)) return { regions, unfitRegions };
  const arraysOf = nodes.map(labelArrays);
  for (const name of arraysOf[0].keys()) {
    const found = arraysOf.flatMap((arrays) => arrays.get(name) ?? []);
    if (found.length < nodes.length) continue;
    const cells = found.map((node, index) => orDamage(() => cellValues(node, nodes[index], pieces[index], packing)));
    const whole = cells.filter((each) => typeof each !== 'string');
    const damage = cells.find((each) => typeof each === 'string');
    const misfit = damage ?? whole.map(({ values, prefix }) => misfitAmong(values, `${prefix}cell`)).find(Boolean);
    if (misfit !== undefined) unfitRegions.set(name, misfit);
    else regions.set(name, joined(whole.map(labelsInPiece), Int32Array));
  }
  return { regions, unfitRegions };
}

/** What is read, or what is wrong with it as a clause: cell data are not needed for the surface. */
function orDamage<Value>(read: () => Value): Value | string {
  try {
    return read();
  } catch (error) {
    if (!(error instanceof FormatError)) throw error;
    return `it is damaged (${error.message.replace(/\.$/, '')})`;
  }
}

/** The cell-data arrays of one number a cell, by name. */
function labelArrays(piece: XmlNode): Map<string, XmlNode> {
  const arrays = dataArrays(piece, 'CellData');
  const fitting = arrays.filter(isOfOne);
  return new Map(fitting.map((node) => [node.attributes.Name ?? '', node]));
}

function isOfOne(node: XmlNode): boolean {
  const { Name: name = '', NumberOfComponents: components = '1' } = node.attributes;
  return components.trim() === '1' && name !== '' && !isGhostArray(name);
}

/** The arrays of numbers among the data of points or cells. */
function dataArrays(piece: XmlNode, tag: 'PointData' | 'CellData'): XmlNode[] {
  const arrays = childrenOf(piece, tag).flatMap((parent) => childrenOf(parent, 'DataArray'));
  return arrays.filter(isOfNumbers);
}

/** The numbers of an array of cell data, with what they belong to: `before` cells are no surface and come first. */
interface CellValues extends Pick<Piece, 'polygons' | 'prefix'> {
  values: VtkValues;
  before: number;
}

function cellValues(node: XmlNode, piece: XmlNode, { polygons, prefix }: Piece, packing: VtkPacking): CellValues {
  const before = countOf(piece, 'NumberOfVerts') + countOf(piece, 'NumberOfLines');
  const where = `array ${prefix}${quoted(node.attributes.Name ?? '')}`;
  return { values: readDataArray(node, before + polygons.ends.length, packing, where), before, polygons, prefix };
}

/** See labelsOfTriangles. */
function labelsInPiece({ values, before, polygons }: CellValues): Int32Array {
  return labelsOfTriangles(values, before, polygons);
}

function openDocument(bytes: Uint8Array): { root: XmlNode; appended: AppendedData | undefined } {
  const tag = indexOfText(bytes, '<AppendedData', 0);
  const tagEnd = tag < 0 ? -1 : bytes.indexOf('>'.charCodeAt(0), tag);
  if (tagEnd < 0) return { root: parseXml(bytes, false), appended: undefined };
  const root = parseXml(bytes.subarray(0, tagEnd + 1), true);
  const base64 = childrenOf(root, 'AppendedData')[0]?.attributes.encoding === 'base64';
  return { root, appended: { bytes: appendedBytes(bytes.subarray(tagEnd + 1)), base64 } };
}

function indexOfText(bytes: Uint8Array, text: string, from: number): number {
  const codes = Array.from(text, (letter) => letter.charCodeAt(0));
  let at = bytes.indexOf(codes[0], from);
  while (at >= 0 && !codes.every((code, i) => bytes[at + i] === code)) at = bytes.indexOf(codes[0], at + 1);
  return at;
}

/** The data between the underscore and the closing tags, which also tell that the file is whole. */
function appendedBytes(rest: Uint8Array): Uint8Array {
  const tailSize = 256;
  const tail = new TextDecoder('latin1').decode(rest.subarray(-tailSize));
  const closing = /<\/AppendedData\s*>\s*<\/VTKFile\s*>\s*$/.exec(tail);
  if (!closing)
    throw new FormatError('truncated', 'The file ends before </AppendedData> and </VTKFile>.', 'AppendedData');
  const data = rest.subarray(0, rest.length - (tail.length - closing.index));
  const start = data.findIndex((byte) => byte > 32);
  if (data[start] !== '_'.charCodeAt(0)) {
    throw new FormatError('corrupt', 'AppendedData does not begin with an underscore.', 'AppendedData');
  }
  return data.subarray(start + 1);
}

function checkKind(root: XmlNode): void {
  const { type = '' } = root.attributes;
  if (root.tag === 'VTKFile' && type === 'PolyData') return;
  const advice = type.startsWith('P')
    ? 'it only refers to other files'
    : 'extract its surface first (in ParaView: Extract Surface)';
  throw new FormatError('unsupported_format', `This is a VTK file of type ${quoted(type)}, not PolyData: ${advice}.`);
}

function packingOf(root: XmlNode, appended: AppendedData | undefined, fileSize: number): VtkPacking {
  const {
    compressor = '',
    header_type: headerType = 'UInt32',
    byte_order: byteOrder = 'LittleEndian',
  } = root.attributes;
  if (!['UInt32', 'UInt64'].includes(headerType) || !['LittleEndian', 'BigEndian'].includes(byteOrder)) {
    throw new FormatError(
      'bad_header',
      `Unknown header_type ${quoted(headerType)} or byte_order ${quoted(byteOrder)}.`,
    );
  }
  return {
    littleEndian: byteOrder === 'LittleEndian',
    headerSize: headerType === 'UInt64' ? 8 : 4,
    compressor,
    appended,
    budget: { bytes: expansionLimit(fileSize) },
  };
}

function readPiece(node: XmlNode, packing: VtkPacking, prefix: string, notes: string[]): Piece {
  const points = countOf(node, 'NumberOfPoints');
  const position = readPoints(node, points, packing, prefix);
  const named = pointArrays(node).map((array) => ({ array, name: array.attributes.Name ?? '' }));
  const declared = declaredRoles(node);
  const arrays = namedArrays(named, `${prefix}point data`, notes).map(({ array }) => {
    const read = readPointArray(array, points, packing, prefix);
    return { ...read, role: declared.get(read.name) };
  });
  const polygons = readCells(node, 'Polys', packing, prefix);
  const strips = readCells(node, 'Strips', packing, prefix);
  const piece = { prefix, position, arrays, polygons, strips };
  const before = countOf(node, 'NumberOfVerts') + countOf(node, 'NumberOfLines');
  const cells = before + polygons.ends.length + strips.ends.length;
  return withoutGhosts(piece, ghostCells(node, cells, packing, prefix), before);
}

/** The arrays that say which cells are ghosts. */
function ghostCells(node: XmlNode, cells: number, packing: VtkPacking, prefix: string): PointArray[] {
  const arrays = dataArrays(node, 'CellData').filter(({ attributes }) => isGhostArray(attributes.Name ?? ''));
  return arrays.map((array) => readPointArray(array, cells, packing, prefix));
}

function countOf(node: XmlNode, attribute: string): number {
  const text = node.attributes[attribute] ?? '0';
  if (!/^\d{1,15}$/.test(text.trim())) {
    throw new FormatError('bad_header', `${attribute} is ${quoted(text)}, which is not a whole number.`, attribute);
  }
  return Number(text);
}

function componentsOf(node: XmlNode): number {
  return countOf(node, 'NumberOfComponents') || 1;
}

function readPoints(piece: XmlNode, points: number, packing: VtkPacking, prefix: string): PointArray {
  const where = `array ${prefix}“Points”`;
  const nodes = childrenOf(piece, 'Points').flatMap((parent) => childrenOf(parent, 'DataArray'));
  const node = onlyOne(nodes, where);
  if (!node && points > 0) throw new FormatError('no_points', `The ${where} is missing.`, where);
  if (!node) return { name: 'position', components: 3, values: new Float32Array(), integers: false };
  if (points > 0 && componentsOf(node) !== 3) {
    throw new FormatError('count_mismatch', `The ${where} has ${componentsOf(node)} components, but needs 3.`, where);
  }
  const values = readDataArray(node, 3 * points, packing, where);
  return { name: 'position', components: 3, values, integers: !isFloatArray(node) };
}

/** The point-data arrays that are numbers. */
function pointArrays(piece: XmlNode): XmlNode[] {
  return dataArrays(piece, 'PointData');
}

/** What the file declares arrays to be, by their names. */
function declaredRoles(piece: XmlNode): Map<string, Role> {
  const attributes = childrenOf(piece, 'PointData').flatMap((node) => Object.entries(node.attributes));
  const declared = attributes.map(([attribute, name]) => [name, roleSpelled('vtp', attribute)] as const);
  return new Map(declared.filter((each): each is [string, Role] => each[1] !== undefined));
}

function readPointArray(node: XmlNode, points: number, packing: VtkPacking, prefix: string): PointArray {
  const name = node.attributes.Name ?? '';
  const components = componentsOf(node);
  const values = readDataArray(node, points * components, packing, `array ${prefix}${quoted(name)}`);
  const { type } = node.attributes;
  const wholeType = isVtkType(type) ? wholeTypeOf(type) : undefined;
  return { name, components, values, integers: !isFloatArray(node), wholeType };
}

/** The one of its kind; undefined if there is none. Of two, nobody can tell which is meant. */
function onlyOne(nodes: XmlNode[], where: string): XmlNode | undefined {
  if (nodes.length < 2) return nodes[0];
  throw new FormatError('duplicate_name', `The ${where} is there ${nodes.length} times.`, where);
}

/** Polys or Strips of a piece: their corners, and where each cell ends among them. */
function readCells(piece: XmlNode, kind: 'Polys' | 'Strips', packing: VtkPacking, prefix: string): Polygons {
  const count = countOf(piece, `NumberOf${kind}`);
  if (count === 0) return noPolygons;
  const arrays = childrenOf(piece, kind).flatMap((parent) => childrenOf(parent, 'DataArray'));
  const read = (name: string, length: number, convert: (values: VtkValues, where: string) => Uint32Array) => {
    const where = `array ${prefix}“${kind} ${name}”`;
    const node = onlyOne(
      arrays.filter((array) => array.attributes.Name === name),
      where,
    );
    if (!node) throw new FormatError('count_mismatch', `The ${where} is missing.`, where);
    return convert(readDataArray(node, length, packing, where), where);
  };
  const ends = read('offsets', count, asEnds);
  return { corners: read('connectivity', ends[count - 1], asIndices), ends };
}

/** What the file holds beside points, their arrays and triangles. */
function notCarried(data: XmlNode | undefined, pieces: XmlNode[], regions: ReadonlyMap<string, unknown>): string[] {
  const isArray = ({ tag }: XmlNode) => tag === 'DataArray' || tag === 'Array';
  const isUnread = (node: XmlNode) => isArray(node) && !(node.tag === 'DataArray' && isOfNumbers(node));
  const isText = (node: XmlNode) => isUnread(node) && (node.attributes.type ?? 'String').toLowerCase() === 'string';
  const names = (parents: XmlNode[], matches: (node: XmlNode) => boolean = isArray) => [
    ...new Set(
      parents
        .flatMap((parent) => parent.children)
        .filter((node) => matches(node))
        .map(({ attributes }) => attributes.Name ?? '')
        .filter((name) => !isGhostArray(name)),
    ),
  ];
  const inPieces = (tag: string) => pieces.flatMap((piece) => childrenOf(piece, tag));
  const cells = (kind: string) => pieces.reduce((sum, piece) => sum + countOf(piece, `NumberOf${kind}`), 0);
  const cellData = names(inPieces('CellData')).filter((name) => !regions.has(name));
  const arrays: [string, string[]][] = [
    ['cell data', cellData],
    ['field data', names([data, ...pieces].flatMap((parent) => (parent ? childrenOf(parent, 'FieldData') : [])))],
    ['text arrays', names(inPieces('PointData'), isText)],
    ['arrays in a form that is not read', names(inPieces('PointData'), (node) => isUnread(node) && !isText(node))],
  ];
  const lost = arrays.filter(([, found]) => found.length > 0).map(([noun, found]) => `${noun} ${listed(found)}`);
  if (cells('Verts') > 0) lost.push(counted(cells('Verts'), 'vertex cell'));
  if (cells('Lines') > 0) lost.push(counted(cells('Lines'), 'line'));
  const notes = lost.length > 0 ? [`Not carried: ${lost.join('; ')}.`] : [];
  return cellData.length > 0 ? [...notes, cellDataAdvice] : notes;
}

function labelsOf(pieces: XmlNode[], variables: Variable[]): Labels {
  const labels = noLabels();
  const known = new Map(variables.map(({ name, components }) => [name, components]));
  for (const piece of pieces) {
    const points = childrenOf(piece, 'Points').flatMap((parent) => childrenOf(parent, 'DataArray'));
    for (const node of points) addLabels(node, 'position', 3, labels);
    for (const node of pointArrays(piece)) {
      const { Name: name = '' } = node.attributes;
      const components = known.get(name);
      if (components !== undefined) addLabels(node, name, components, labels);
    }
  }
  return labels;
}

/** A component without a name is called by its number. */
function addLabels(node: XmlNode, name: string, components: number, { units, componentNames }: Labels): void {
  const unit = childrenOf(node, 'InformationKey')
    .find(({ attributes }) => attributes.name === 'UNITS_LABEL')
    ?.text.trim();
  if (unit) units[name] = unit;
  const names = Array.from({ length: components }, (_, index) => node.attributes[`ComponentName${index}`]);
  if (names.some(Boolean)) componentNames[name] = names.map((each, index) => each || String(index));
}
