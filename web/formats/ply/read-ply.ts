import type { Variable } from '../../../wasm/types.ts';
import { GrowingPolygons } from '../bytes/growing-arrays.ts';
import { noPolygons, type Polygons, polygonNotes, trianglesOfStrips, triangulate } from '../faces/polygons.ts';
import { FormatError } from '../format-error.ts';
import { regionNotes } from '../regions/region-notes.ts';
import { type CellLabels, type Labels, noLabels, type Surface } from '../surface.ts';
import { cutNotes } from '../text/text-lines.ts';
import { undecoded } from '../text/utf8-text.ts';
import { capitalised, counted, grouped, listed, quoted } from '../text/wording.ts';
import { withKinds } from '../variables/identifiers.ts';
import { asFloatingPoint } from '../variables/precision.ts';
import { declareRole, nameOf, type Role, roleOfProperties } from '../variables/roles.ts';
import { isWholeType, type WholeType } from '../variables/whole-types.ts';
import { labelsOfTriangles, misfitAmong } from '../vtk-data/vtk-pieces.ts';
import {
  isFloatType,
  type PlyElement,
  type PlyHeader,
  type PlyProperty,
  type PlyType,
  readPlyHeader,
} from './ply-header.ts';
import { brokenRow, type PlyValues, plyValues } from './ply-values.ts';
import {
  declaredComponentNames,
  declaredRegions,
  declaredUnits,
  groupProperties,
  type PlyVariable,
} from './ply-variables.ts';

// Written by hand although three.js has a PLYLoader. That one converts colours between colour spaces, rounding them; has
// no way to tell a truncated ASCII file from a whole one; drops faces of more than four corners; takes ∞ for NaN and any
// index for a good one; and builds an object for every vertex, which a declared count can drive beyond memory.

const coordinates = ['x', 'y', 'z'];
const cornerLists = ['vertex_indices', 'vertex_index'];

interface Vertices {
  position: Float32Array | Float64Array;
  variables: Variable[];
  notes: string[];
}

/**
 * Reads a PLY file, ASCII or binary of either byte order. Every vertex property of a plain type becomes a variable or a
 * component of one (see groupProperties), in single precision where that holds every value exactly, else in double.
 * Units come from comments `unit NAME UNIT`.
 */
export function readPly(bytes: Uint8Array): Surface {
  const header = readPlyHeader(bytes);
  if (header.encoding !== 'ascii') return readBody(bytes, header, plyValues(bytes, header));
  const values = plyValues(bytes, header);
  try {
    const surface = readBody(bytes, header, values);
    if (values.left > 0 && values.faults.firstInside) throw brokenRow(values.faults);
    return surface;
  } catch (error) {
    if (!(error instanceof FormatError)) throw error;
    const surface = readLines(bytes, header);
    if (!surface) throw withRowHint(error, values);
    return surface;
  }
}

/** The surface of an ASCII file whose rows have a line each, with whatever more numbers; undefined where that does not fit. */
function readLines(bytes: Uint8Array, header: PlyHeader): Surface | undefined {
  try {
    return readBody(bytes, header, plyValues(bytes, header, true));
  } catch (error) {
    if (error instanceof FormatError) return undefined;
    throw error;
  }
}

/** What went wrong may have begun where a row begins inside a line. */
function withRowHint(error: FormatError, { faults }: PlyValues): FormatError {
  const hint = faults.firstInside ? brokenRow(faults).message : '';
  if (hint === '' || error.message === hint) return error;
  return new FormatError(error.code, `${error.message} ${hint}`, error.where);
}

function readBody(bytes: Uint8Array, header: PlyHeader, values: PlyValues): Surface {
  const notes: string[] = [];
  const parts: { vertices?: Vertices; faces?: Faces; strips?: Polygons } = {};
  for (const element of header.elements) {
    values.begin(element);
    if (element.name === 'vertex') parts.vertices = readVertices(element, header.comments, values);
    else if (element.name === 'face') parts.faces = readFaces(element, values);
    else if (element.name === 'tristrips') parts.strips = readStrips(element, values);
    else skipElement(element, values, notes);
  }
  values.finish();
  const { position, variables, notes: vertexNotes } = parts.vertices ?? noPoints();
  const triangles = joinTriangles({ ...parts, faces: parts.faces?.polygons }, position, notes);
  const cellLabels = readRegions(parts.faces, parts.strips, header.comments, notes);
  notes.push(...vertexNotes, ...textureNotes(header), ...endNotes(bytes, header, values));
  const wholeTypes = wholeTypesOf(header);
  const mesh = {
    position,
    triangles,
    variables: withKinds(variables, triangles, (name) => Object.hasOwn(wholeTypes, name)),
  };
  const roles = rolesOf(header);
  return { mesh, notes, ...labels(header, variables), wholeTypes, roles, ...cellLabels };
}

/** What variables are whose properties say so, whatever a comment calls them. */
function rolesOf(header: PlyHeader): Record<string, Role> {
  const roles: Record<string, Role> = Object.create(null);
  for (const { name, properties } of groupsOf(header))
    declareRole(roles, { name, components: properties.length }, roleOfProperties(properties));
  return roles;
}

/** The variables of the vertices, but for the geometry. */
function groupsOf({ elements, comments }: PlyHeader): PlyVariable[] {
  const properties = elements.find(({ name }) => name === 'vertex')?.properties ?? [];
  const plain = properties.filter(({ listLength }) => !listLength).map(({ name }) => name);
  return groupProperties(
    plain.filter((name) => !coordinates.includes(name)),
    comments,
  );
}

/** The types of the variables that the file holds as whole numbers; of components that differ, one that holds them all. */
function wholeTypesOf(header: PlyHeader): Record<string, WholeType> {
  const { elements } = header;
  const properties = elements.find(({ name }) => name === 'vertex')?.properties ?? [];
  const byName = new Map(properties.filter(({ listLength }) => !listLength).map((each) => [each.name, each]));
  const types: Record<string, WholeType> = Object.create(null);
  for (const group of groupsOf(header)) {
    const [first, ...others] = typesOf(group, byName);
    const ofAll = others.every((type) => type === first) ? first : 'int32';
    if (![first, ...others].some(isFloatType) && isWholeType(ofAll)) types[group.name] = ofAll;
  }
  return types;
}

function noPoints(): never {
  throw new FormatError('no_points', 'The file declares no element “vertex”, so it has no points.');
}

/** Where the components of a vertex go: column by column of the file, interleaved into its variable. */
interface Column {
  values: Float32Array | Float64Array;
  step: number;
  offset: number;
}

function readVertices(element: PlyElement, comments: string[], values: PlyValues): Vertices {
  const plain = element.properties.filter((property) => !property.listLength);
  const byName = new Map(plain.map((property) => [property.name, property]));
  if (!coordinates.every((name) => byName.has(name))) {
    throw new FormatError(
      'no_points',
      'The element “vertex” lacks one of the properties x, y and z.',
      'element “vertex”',
    );
  }
  const rest = plain.map((property) => property.name).filter((name) => !coordinates.includes(name));
  const groups = [{ name: 'position', properties: coordinates }, ...groupProperties(rest, comments)];
  const columns = new Map<string, Column>();
  const read = groups.map((group) => allocate(group, byName, element.count, columns));
  readColumns(element, columns, values);
  const finished = read.map(({ variable, integers }) =>
    integers ? { ...variable, values: asFloatingPoint(variable.values) } : variable,
  );
  const [{ values: position }, ...variables] = finished;
  return { position, variables, notes: [...vertexNotes(element), ...guessNotes(groups)] };
}

/** Room for one variable: single precision if the file has it in single precision, else double until all values are known. */
function allocate(group: PlyVariable, byName: Map<string, PlyProperty>, count: number, columns: Map<string, Column>) {
  const types = typesOf(group, byName);
  const components = types.length;
  const single = types.every((type) => type === 'float32');
  const values = single ? new Float32Array(count * components) : new Float64Array(count * components);
  for (const [offset, name] of group.properties.entries()) columns.set(name, { values, step: components, offset });
  return { variable: { name: group.name, components, values }, integers: !types.some(isFloatType) };
}

function typesOf(group: PlyVariable, byName: Map<string, PlyProperty>): PlyType[] {
  return group.properties.flatMap((name) => byName.get(name)?.type ?? []);
}

function readColumns(element: PlyElement, columns: Map<string, Column>, values: PlyValues): void {
  const plan = element.properties.map((property) => ({ property, column: columns.get(property.name) }));
  for (let row = 0; row < element.count; row++) {
    values.startRow(row);
    for (const { property, column } of plan) {
      if (column) column.values[row * column.step + column.offset] = values.next(property.type);
      else values.skip(property);
    }
  }
}

function vertexNotes(element: PlyElement): string[] {
  const notes: string[] = [];
  const lists = element.properties.filter((property) => property.listLength).map((property) => property.name);
  if (lists.length > 0) notes.push(`Not carried: the vertex lists ${listed(lists)}.`);
  return notes;
}

/** Says which properties of one letter were taken for texture coordinates: they may be something else. */
function guessNotes(groups: PlyVariable[]): string[] {
  const guessed = groups.filter(({ name, properties }) => name === nameOf('textureCoordinates') && isGuess(properties));
  return guessed.map(
    ({ name, properties }) =>
      `Taken for texture coordinates, as the variable ${quoted(name)}: the properties ${listed(properties)}.`,
  );
}

function isGuess(properties: string[]): boolean {
  return properties.every((property) => property.length === 1);
}

interface Faces {
  polygons: Polygons | undefined;
  /** By property what could be labels, a number a face. */
  columns: Map<string, Float64Array>;
  /** Everything else. */
  others: string[];
}

/** Colours are no labels, though they are whole numbers; nor are other properties that belong together. */
function readFaces(element: PlyElement, values: PlyValues): Faces {
  const corners = cornerList(element);
  const rest = element.properties.filter((property) => property !== corners);
  const plain = rest.filter(({ listLength }) => !listLength).map(({ name }) => name);
  const alone = groupProperties(plain).filter(({ properties }) => properties.length === 1);
  const columns = new Map(alone.map(({ name }) => [name, new Float64Array(element.count)]));
  const others = rest.map(({ name }) => name).filter((name) => !columns.has(name));
  return { polygons: readCorners(element, values, { columns }), columns, others };
}

/** Face properties of whole numbers as labels of the triangles; of files without strips, whose triangles follow the faces. */
function readRegions(
  faces: Faces | undefined,
  strips: Polygons | undefined,
  comments: string[],
  notes: string[],
): CellLabels {
  const regions = new Map<string, Int32Array>();
  const unfitRegions = new Map<string, string>();
  const names = declaredRegions(comments);
  const lost = [...(faces?.others ?? [])];
  for (const [property, numbers] of faces?.columns ?? []) {
    const misfit = misfitAmong(numbers, 'face');
    if (misfit !== undefined) unfitRegions.set(names.get(property) ?? property, misfit);
    if (faces?.polygons && !strips?.ends.length && misfit === undefined) {
      regions.set(names.get(property) ?? property, labelsOfTriangles(numbers, 0, faces.polygons));
    } else lost.push(property);
  }
  if (lost.length > 0) notes.push(`Not carried: the face properties ${listed(lost)}.`);
  notes.push(...regionNotes(regions));
  return { regions, unfitRegions };
}

function cornerList({ properties }: PlyElement): PlyProperty | undefined {
  return properties.find((property) => property.listLength && cornerLists.includes(property.name));
}

interface CornerOptions {
  /** What ends a strip in place of a corner; a polygon it ends only in error. */
  endMarks?: readonly number[];
  /** Where the numbers of other properties go. */
  columns?: Map<string, Float64Array>;
}

/** The corners of all faces. */
function readCorners(
  element: PlyElement,
  values: PlyValues,
  { endMarks, columns }: CornerOptions,
): Polygons | undefined {
  const list = cornerList(element);
  if (!list) return undefined;
  const collected = new GrowingPolygons();
  for (let row = 0; row < element.count; row++) {
    values.startRow(row);
    for (const property of element.properties) {
      const column = columns?.get(property.name);
      if (property === list) readList(property, values, collected, endMarks);
      else if (column) column[row] = values.next(property.type);
      else values.skip(property);
    }
  }
  return collected.toPolygons();
}

function readList(
  property: PlyProperty,
  values: PlyValues,
  collected: GrowingPolygons,
  endMarks: readonly number[] = [],
): void {
  const length = values.nextLength(property);
  for (let i = 0; i < length; i++) {
    const corner = values.next(property.type);
    if (endMarks.includes(corner)) collected.endPolygon();
    else if (Number.isInteger(corner) && corner >= 0 && corner < 2 ** 32) collected.addCorner(corner);
    else throw new FormatError('bad_index', `${capitalised(values.place())} names point ${corner}.`, values.place());
  }
  collected.endPolygon();
}

/** −1, and what it is where corners have no sign. */
const stripEnds = [-1, 2 ** 32 - 1];

function readStrips(element: PlyElement, values: PlyValues): Polygons | undefined {
  const strips = readCorners(element, values, { endMarks: stripEnds });
  if (!strips) return undefined;
  // A strip that ends with its end mark, as most do, is followed by an empty one.
  const ends = strips.ends.filter((end, index) => end > (index > 0 ? strips.ends[index - 1] : 0));
  return { corners: strips.corners, ends };
}

function skipElement(element: PlyElement, values: PlyValues, notes: string[]): void {
  if (element.count > 0)
    notes.push(`Not carried: the element ${quoted(element.name)} (${counted(element.count, 'row')}).`);
  if (element.properties.length === 0) return;
  for (let row = 0; row < element.count; row++) {
    values.startRow(row);
    for (const property of element.properties) values.skip(property);
  }
}

function joinTriangles(
  parts: { faces?: Polygons; strips?: Polygons },
  position: Float32Array | Float64Array,
  notes: string[],
): Uint32Array {
  const { faces = noPolygons, strips = noPolygons } = parts;
  const { triangles: ofFaces, split, short } = triangulate(faces, position, 'face');
  const ofStrips = trianglesOfStrips(strips, position, 'strip');
  notes.push(...polygonNotes('face', split, short));
  if (strips.ends.length > 0)
    notes.push(`${counted(strips.ends.length, 'triangle strip')} taken apart into triangles.`);
  if (position.length === 0) throw new FormatError('no_points', 'The file has no points.');
  if (ofFaces.length + ofStrips.length === 0) {
    throw new FormatError('no_triangles', `The file has ${counted(position.length / 3, 'point')}, but no faces.`);
  }
  if (ofStrips.length === 0) return ofFaces;
  const triangles = new Uint32Array(ofFaces.length + ofStrips.length);
  triangles.set(ofFaces);
  triangles.set(ofStrips, ofFaces.length);
  return triangles;
}

/** Comments by which MeshLab and others name the pictures on a surface. */
function textureNotes({ comments }: PlyHeader): string[] {
  const textures = comments.flatMap((comment) => /^TextureFile\s+(.+)$/i.exec(comment)?.[1] ?? []);
  return textures.length > 0 ? [`Not carried: the textures ${listed(textures)}.`] : [];
}

function endNotes(bytes: Uint8Array, header: PlyHeader, values: PlyValues): string[] {
  const notes: string[] = [];
  const { longLines, firstLong = 0 } = values.faults;
  if (longLines > 0) {
    const lines = longLines === 1 ? '1 line has' : `${grouped(longLines)} lines have`;
    notes.push(
      `${lines} more than the header declares (first line ${grouped(firstLong)}): what is too much passed over.`,
    );
  }
  if (values.left > 0) notes.push(`${counted(values.left, 'byte')} after the last element passed over.`);
  else if (header.encoding === 'ascii') notes.push(...cutNotes(bytes));
  return notes;
}

function labels({ comments, isUtf8 }: PlyHeader, variables: Variable[]): Labels {
  const { units, componentNames } = noLabels();
  const known = new Map(variables.map((variable) => [variable.name, variable.components]));
  known.set('position', coordinates.length);
  for (const [name, unit] of declaredUnits(comments)) if (known.has(name)) units[name] = unit;
  for (const [name, names] of declaredComponentNames(comments)) {
    if (known.get(name) === names.length) componentNames[name] = names;
  }
  if (!isUtf8) requireDecoded([...known.keys(), ...Object.values(units), ...Object.values(componentNames).flat()]);
  return { units, componentNames };
}

/** Throws where what comments say of names and units is in another encoding than UTF-8. */
function requireDecoded(labels: string[]): void {
  const spoilt = labels.find((label) => label.includes(undecoded));
  if (spoilt === undefined) return;
  throw new FormatError(
    'bad_encoding',
    `The name or unit ${quoted(spoilt)} in a comment is not UTF-8 (header).`,
    'header',
  );
}
