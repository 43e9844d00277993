import type { Mesh, Variable } from '../../../wasm/types.ts';
import { joined } from '../bytes/joined-arrays.ts';
import { type Polygons, polygonNotes, trianglesIn, trianglesOfStrips, triangulate } from '../faces/polygons.ts';
import { FormatError } from '../format-error.ts';
import type { Labels } from '../surface.ts';
import { counted, grouped, listed } from '../text/wording.ts';
import { withKinds } from '../variables/identifiers.ts';
import { asFloatingPoint } from '../variables/precision.ts';
import { identifies, type Role } from '../variables/roles.ts';
import type { WholeType } from '../variables/whole-types.ts';
import { countCells, type Ghosts, ghostNotes } from './vtk-ghost-counts.ts';
import type { VtkValues } from './vtk-values.ts';

/** A point-data array before it is known whether all pieces have it. */
export interface PointArray {
  name: string;
  components: number;
  values: VtkValues;
  /** Whole numbers in the file. */
  integers: boolean;
  /** Their type, where it is one of writable whole numbers. */
  wholeType?: WholeType;
  /** What the file declares it to be. */
  role?: Role;
}

/** What to do where values belong to cells: nothing here can tell what they would be at the points. */
export const cellDataAdvice = 'Cell data can be made point data first (in ParaView: Cell Data to Point Data).';

/** A part of a surface as VTK's formats hold it. */
export interface Piece {
  /** Named in front of places in messages: "piece 2 ", or nothing where there is only one. */
  prefix: string;
  position: PointArray;
  arrays: PointArray[];
  polygons: Polygons;
  strips: Polygons;
  /** What was left out of it; those polygons and strips have no corners. */
  ghosts?: Ghosts;
}

/** One mesh of all pieces, triangulated; adds to `notes` what was changed or left out on the way. */
export function meshOfPieces(pieces: Piece[], notes: string[]): Mesh {
  const full = pieces.filter((piece) => piece.position.values.length > 0);
  if (full.length === 0) throw new FormatError('no_points', 'The file has no points.');
  const joinedArrays = joinArrays(full, notes);
  const position = joinValues(full.map((piece) => piece.position));
  const triangles = joinTriangles(full, notes);
  const all = (holds: (array: PointArray) => boolean | undefined) => (name: string) =>
    full.every(({ arrays }) => arrays.some((array) => array.name === name && holds(array)));
  const variables = withKinds(
    joinedArrays,
    triangles,
    all(({ integers }) => integers),
    all(({ role }) => identifies(role)),
  );
  if (full.length > 1) notes.push(`${counted(full.length, 'piece')} joined.`);
  return { position, triangles, variables };
}

/** What all pieces say alike of the variables: the types of those that are whole numbers, and what they are declared to be. */
export function declaredIn(pieces: Piece[], variables: Variable[]): Required<Pick<Labels, 'wholeTypes' | 'roles'>> {
  return {
    wholeTypes: saidByAll(pieces, variables, ({ wholeType }) => wholeType),
    roles: saidByAll(pieces, variables, (array) => array.role ?? colourByType(array)),
  };
}

/** Three or four bytes are what VTK draws as a colour, whatever they are called. */
function colourByType({ wholeType, components }: PointArray): Role | undefined {
  return wholeType === 'uint8' && (components === 3 || components === 4) ? 'colour' : undefined;
}

function saidByAll<Said>(
  pieces: Piece[],
  variables: Variable[],
  said: (array: PointArray) => Said | undefined,
): Record<string, Said> {
  const found: Record<string, Said> = Object.create(null);
  const full = pieces.filter((piece) => piece.position.values.length > 0);
  for (const { name } of variables) {
    const arrays = full.map((piece) => piece.arrays.find((array) => array.name === name));
    const [first, ...others] = arrays.map((array) => array && said(array));
    if (first !== undefined && others.every((each) => each === first)) found[name] = first;
  }
  return found;
}

/** The arrays that a variable can be made of; those without a name of their own are said to be left out. */
export function namedArrays<Named extends { name: string }>(arrays: Named[], noun: string, notes: string[]): Named[] {
  const seen = new Set<string>();
  const fit = arrays.filter(({ name }) => name !== '' && !seen.has(name) && seen.add(name));
  const nameless = arrays.filter(({ name }) => name === '').length;
  const twice = new Set(arrays.filter((array) => array.name !== '' && !fit.includes(array)).map(({ name }) => name));
  if (nameless > 0) notes.push(`Not carried: ${counted(nameless, 'array')} of the ${noun} without a name.`);
  if (twice.size > 0) notes.push(`Not carried: what is named ${listed([...twice])} a second time in the ${noun}.`);
  return fit;
}

function joinArrays(pieces: Piece[], notes: string[]): Variable[] {
  const arraysOf = pieces.map(({ arrays }) => new Map(arrays.map((array) => [array.name, array])));
  const matching = ({ name, components }: PointArray) =>
    arraysOf.flatMap((arrays) => arrays.get(name) ?? []).filter((array) => array.components === components);
  const lost = new Set(pieces.flatMap(({ arrays }) => arrays.map((array) => array.name)));
  const integers: string[] = [];
  const variables = pieces[0].arrays.flatMap((array): Variable[] => {
    const parts = matching(array);
    if (parts.length < pieces.length) return [];
    lost.delete(array.name);
    if (parts.every((part) => part.integers)) integers.push(array.name);
    return [{ name: array.name, components: array.components, values: joinValues(parts) }];
  });
  if (lost.size > 0) notes.push(`Not carried, since not every piece has them: the arrays ${listed([...lost])}.`);
  const wholeNumbers = new Set(integers);
  const rounded = variables.filter(({ name, values }) => wholeNumbers.has(name) && values.some(isBeyondDoubles));
  if (rounded.length > 0)
    notes.push(`Rounded, being beyond 2^53: values of ${listed(rounded.map(({ name }) => name))}.`);
  return variables;
}

/** Whole numbers that a double may have been too short for. */
function isBeyondDoubles(value: number): boolean {
  return Math.abs(value) > Number.MAX_SAFE_INTEGER;
}

/** One after the other, in double precision if any of them is. */
function joinValues(parts: PointArray[]): VtkValues {
  const narrow = (values: VtkValues) => (parts.every((part) => part.integers) ? asFloatingPoint(values) : values);
  if (parts.length === 1) return narrow(parts[0].values);
  const single = parts.every(({ values }) => values instanceof Float32Array);
  const values = parts.map((part) => part.values);
  return narrow(single ? joined(values, Float32Array) : joined(values, Float64Array));
}

function joinTriangles(pieces: Piece[], notes: string[]): Uint32Array {
  let [points, split, short, strips, shortStrips] = [0, 0, 0, 0, 0];
  const parts = pieces.flatMap((piece) => {
    const position = piece.position.values;
    const { ghosts = { polygons: 0, strips: 0 } } = piece;
    const ofPolygons = triangulate(piece.polygons, position, `${piece.prefix}polygon`);
    const ofStrips = trianglesOfStrips(piece.strips, position, `${piece.prefix}strip`);
    const shift = points;
    points += position.length / 3;
    const ofKinds = [countCells(piece.polygons, ghosts.polygons), countCells(piece.strips, ghosts.strips)];
    split += ofPolygons.split;
    short += ofKinds[0].short;
    shortStrips += ofKinds[1].short;
    strips += ofKinds[1].full;
    const shifted = (corners: Uint32Array) => (shift === 0 ? corners : corners.map((corner) => corner + shift));
    return [shifted(ofPolygons.triangles), shifted(ofStrips)];
  });
  notes.push(...ghostNotes(pieces), ...polygonNotes('polygon', split, short), ...polygonNotes('strip', 0, shortStrips));
  if (strips > 0) notes.push(`${counted(strips, 'triangle strip')} taken apart into triangles.`);
  const full = parts.filter((part) => part.length > 0);
  const triangles = full.length === 1 ? full[0] : joined(full, Uint32Array);
  if (triangles.length > 0) return triangles;
  throw new FormatError('no_triangles', `The file has ${counted(points, 'point')}, but no polygons or strips.`);
}

/** Numbers of a file as indices; throws on the first that is none. `where` names their array. */
export function asIndices(values: VtkValues, where: string): Uint32Array {
  const wrong = values.findIndex((value: number) => !(value >= 0 && value < 2 ** 32 && Number.isInteger(value)));
  if (wrong < 0) return new Uint32Array(values);
  const message = `Value ${grouped(wrong)} of the ${where} is ${values[wrong]}, which cannot be an index.`;
  throw new FormatError('bad_index', message, where);
}

/** Ends of polygons among their corners, which must not fall. */
export function asEnds(values: VtkValues, where: string): Uint32Array {
  const ends = asIndices(values, where);
  const falling = ends.findIndex((end, index) => index > 0 && end < ends[index - 1]);
  if (falling < 0) return ends;
  throw new FormatError('bad_polygon', `The ${where} falls at ${grouped(falling)}.`, where);
}

/** Which cell has the first value that is no label, and what it is, as a clause; undefined where all are labels. */
export function misfitAmong(values: VtkValues, cell = 'cell'): string | undefined {
  const wrong = values.findIndex((value: number) => !isLabel(value));
  if (wrong < 0) return undefined;
  return `${cell} ${grouped(wrong)}, counted from 0, has ${values[wrong]}, which is no whole number of 32 bits`;
}

function isLabel(value: number): boolean {
  return value === Math.trunc(value) && Math.abs(value) < 2 ** 31;
}

/**
 * Whole numbers of cells as labels of the triangles, polygon by polygon; `before` cells are no surface and come first, and a
 * polygon of n corners is n − 2 triangles. Of
 * each number misfitAmong says nothing.
 */
export function labelsOfTriangles(values: ArrayLike<number>, before: number, { ends }: Polygons): Int32Array {
  const triangles = (polygon: number) => trianglesIn(ends[polygon] - (polygon > 0 ? ends[polygon - 1] : 0));
  const labels = new Int32Array(ends.reduce((sum, _, polygon) => sum + triangles(polygon), 0));
  let triangle = 0;
  for (let polygon = 0; polygon < ends.length; polygon++) {
    const next = triangle + triangles(polygon);
    labels.fill(values[before + polygon], triangle, next);
    triangle = next;
  }
  return labels;
}
