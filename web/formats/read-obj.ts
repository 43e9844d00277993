import type { Mesh, Variable } from '../../wasm/types.ts';
import { asBytes } from './colours.ts';
import { FormatError } from './format-error.ts';
import { GrowingIndices, GrowingNumbers, GrowingPolygons } from './growing-arrays.ts';
import { checkCorners, type Polygons, triangulate } from './polygons.ts';
import { regionNotes } from './region-notes.ts';
import type { Surface } from './surface.ts';
import { cutNotes, numbersFrom, type TextLine, textLines } from './text-lines.ts';
import { labelsOfTriangles } from './vtk-pieces.ts';
import { gather } from './weld.ts';
import { weldedSurface } from './welded-surface.ts';
import { counted, quoted } from './wording.ts';

// Written by hand although three.js has an OBJLoader: that one takes points that do not exist for NaN, makes up normals,
// converts colours between colour spaces, forgets which corners share a point, and keeps single precision only.

/** What stands at the corners of faces beside the points; `f v/vt/vn` names them in this order. */
interface CornerData {
  variable: string;
  keyword: string;
  components: number;
  values: GrowingNumbers;
  /** For each corner of each face, an index into the values. */
  indices: GrowingIndices;
}

const missing = 0xffffffff;
/** Lines that draw, group or refine without changing the surface. */
const ignored = new Set(['s', 'mg', 'bevel', 'c_interp', 'd_interp', 'lod', 'shadow_obj', 'trace_obj', 'end', '#']);
/** Lines whose loss the user should know of. */
const lossy = new Map([
  ['o', 'object names'],
  ['g', 'groups'],
  ['mtllib', 'what materials look like'],
  ['usemap', 'textures'],
  ['maplib', 'textures'],
  ['l', 'lines'],
  ['p', 'single points'],
]);
const freeForm = 'vp deg bmat step cstype curv curv2 surf parm trim hole scrv sp con ctech stech call csh'.split(' ');
for (const keyword of freeForm) lossy.set(keyword, 'curves and free-form surfaces');

/** The array of labels that says which faces are of which material. */
const materialArray = 'material';

/** Which material each face is of, as a number: from 1 on in the order in which faces use them, 0 where none is named yet. */
class Materials {
  private current = '';
  private labels = new Map<string, number>();
  ofFaces = new GrowingIndices();

  use(name: string): void {
    this.current = name;
  }

  endFace(): void {
    const label = this.current === '' ? 0 : (this.labels.get(this.current) ?? 1 + this.labels.size);
    if (label > this.labels.size) this.labels.set(this.current, label);
    this.ofFaces.push(label);
  }

  /** What each label stands for. */
  names(): Map<number, string> {
    const names = new Map([...this.labels].map(([name, label]) => [label, name]));
    if (this.ofFaces.toArray().includes(0)) names.set(0, this.noName());
    return names;
  }

  /** What no material is called. */
  private noName(): string {
    let name = 'none';
    while (this.labels.has(name)) name += '_';
    return name;
  }
}

class ObjFile {
  points = new GrowingNumbers();
  colours = new GrowingNumbers();
  faces = new GrowingPolygons();
  corners: CornerData[] = [
    { variable: 'uv', keyword: 'vt', components: 2, values: new GrowingNumbers(), indices: new GrowingIndices() },
    { variable: 'normal', keyword: 'vn', components: 3, values: new GrowingNumbers(), indices: new GrowingIndices() },
  ];
  materials = new Materials();
  lost = new Set<string>();

  read(line: TextLine): void {
    const keyword = line.words[0];
    const data = this.corners.find((corner) => corner.keyword === keyword);
    if (keyword === 'v') this.readPoint(line);
    else if (data) this.readCornerData(line, data);
    else if (keyword === 'f' || keyword === 'fo') this.readFace(line);
    else if (keyword === 'usemtl') this.materials.use(line.words.slice(1).join(' '));
    else if (lossy.has(keyword)) this.lost.add(lossy.get(keyword) ?? keyword);
    else if (!ignored.has(keyword) && !keyword.startsWith('#')) {
      const where = `line ${line.number}`;
      throw new FormatError('bad_header', `${quoted(keyword)} begins no line of an OBJ file (${where}).`, where);
    }
  }

  /** `v x y z`, `v x y z w` with a weight that is 1 but for free forms or, with a colour, `v x y z r g b`. */
  private readPoint(line: TextLine): void {
    for (const coordinate of numbersFrom(line, 1, 3)) this.points.push(coordinate);
    const more = line.words.length - 4;
    if (more >= 3) for (const part of numbersFrom(line, 4, 3)) this.colours.push(part);
    const isCarried = more === 0 || more === 3 || (more === 1 && numbersFrom(line, 4, 1)[0] === 1);
    if (!isCarried) this.lost.add('numbers of points beyond places and colours');
  }

  /** `vn x y z` or `vt u v w`, of which v and w may be missing and are 0 then. */
  private readCornerData(line: TextLine, { keyword, components, values }: CornerData): void {
    const isFlat = keyword === 'vt' && line.words.length === 2;
    for (const number of numbersFrom(line, 1, isFlat ? 1 : components)) values.push(number);
    if (isFlat) values.push(0);
    const depth = keyword === 'vt' && line.words.length > 3 ? numbersFrom(line, 3, 1)[0] : 0;
    if (depth !== 0) this.lost.add('third texture coordinates');
  }

  private readFace(line: TextLine): void {
    for (const word of line.words.slice(1)) {
      const indices = word.split('/');
      this.faces.addCorner(resolve(indices[0], this.points.length / 3, line));
      for (const [place, { values, components, indices: list }] of this.corners.entries()) {
        const index = indices[place + 1];
        list.push(index ? resolve(index, values.length / components, line) : missing);
      }
    }
    this.faces.endPolygon();
    this.materials.endFace();
  }
}

/** Indices count from 1, or backwards from the last with −1. Whether a later line makes them valid is not known yet. */
function resolve(word: string, count: number, { number }: TextLine): number {
  const index = /^-?\d{1,10}$/.test(word) ? Number(word) : 0;
  const resolved = index > 0 ? index - 1 : count + index;
  if (index !== 0 && resolved >= 0 && resolved < missing) return resolved;
  const where = `line ${number}`;
  throw new FormatError(
    'bad_index',
    `${quoted(word)} in ${where} is no index of one of ${counted(count, 'point')}.`,
    where,
  );
}

/**
 * Reads an OBJ file in double precision, since text has none of its own. Points that agree in everything are welded.
 * Colours at the points become the variable `color`, texture coordinates `uv`, normals `normal` (where they agree). Several
 * materials become labels of the triangles.
 */
export function readObj(bytes: Uint8Array): Surface {
  const file = new ObjFile();
  for (const line of wholeLines(bytes)) file.read(line);
  const points = file.points.length / 3;
  const polygons = file.faces.toPolygons();
  if (points === 0) throw new FormatError('no_points', 'The file has no points.');
  if (polygons.ends.length === 0) {
    throw new FormatError('no_triangles', `The file has ${counted(points, 'point')}, but no faces.`);
  }
  checkCorners(polygons, points, 'face');
  const materials = file.materials.names();
  if (materials.size === 1 && !materials.has(0)) file.lost.add('the material');
  const notes = file.lost.size > 0 ? [`Not carried: ${[...file.lost].join(', ')}.`] : [];
  const { position, variables, ends, corners, copies } = spread(file, polygons, notes);
  const { triangles, split } = triangulate({ corners, ends }, position, 'face');
  if (split > 0) notes.push(`${counted(split, 'face')} with more than three corners split into triangles.`);
  const surface = weldedSurface({ position, triangles, variables }, notes, copies);
  const labels = materials.size > 1 ? materialLabels(file, polygons, materials) : {};
  return { ...surface, ...labels, notes: [...surface.notes, ...regionNotes(labels.regions), ...cutNotes(bytes)] };
}

function materialLabels({ materials }: ObjFile, polygons: Polygons, names: Map<number, string>): Partial<Surface> {
  const labels = labelsOfTriangles(materials.ofFaces.toArray(), 0, polygons);
  return { regions: new Map([[materialArray, labels]]), regionNames: new Map([[materialArray, names]]) };
}

/** Lines put together where a backslash says that one goes on. */
function* wholeLines(bytes: Uint8Array): Generator<TextLine> {
  const begun: string[][] = [];
  for (const { words, number } of textLines(bytes)) {
    const last = words[words.length - 1];
    const goesOn = last.endsWith('\\');
    if (goesOn || begun.length > 0) begun.push(goesOn ? words.with(-1, last.slice(0, -1)) : words);
    if (!goesOn) yield { words: begun.length > 0 ? begun.splice(0).flat().filter(Boolean) : words, number };
  }
  if (begun.length > 0) throw new FormatError('truncated', 'The file ends in a line that should go on.');
}

/** What becomes of the points of a file before it is welded; `copies` says how many were added. */
interface Spread extends Polygons, Pick<Mesh, 'position' | 'variables'> {
  copies: number;
}

/** One point for each corner of a face, in the order of the points, if corners have values of their own. */
function spread(file: ObjFile, polygons: Polygons, notes: string[]): Spread {
  const points = file.points.length / 3;
  const perPoint = pointColours(file, points, notes);
  const perCorner = file.corners.filter((data) => isComplete(data, notes));
  const position = file.points.toArray();
  if (perCorner.length === 0) return { ...polygons, position, variables: perPoint, copies: 0 };
  const { order, place, used } = sortedByPoint(polygons.corners, points);
  if (used < points) notes.push(`${counted(points - used, 'point')} that no face uses left out.`);
  const ofPoints = order.map((corner) => polygons.corners[corner]);
  const variables = [
    ...perPoint.map((variable) => ({ ...variable, values: gather(variable.values, variable.components, ofPoints) })),
    ...perCorner.map(({ variable: name, components, values, indices }) => {
      const list = indices.toArray();
      const ofCorners = order.map((corner) => list[corner]);
      return { name, components, values: gather(values.toArray(), components, ofCorners) };
    }),
  ];
  const copies = order.length - used;
  return { ends: polygons.ends, corners: place, position: gather(position, 3, ofPoints), variables, copies };
}

/** The corners in the order of their points, where each of them stands in this order, and how many points have corners. */
function sortedByPoint(corners: Uint32Array, points: number) {
  const next = new Uint32Array(points + 1);
  for (const point of corners) next[point + 1]++;
  const used = next.reduce((sum, count) => sum + (count > 0 ? 1 : 0), 0);
  for (let point = 0; point < points; point++) next[point + 1] += next[point];
  const place = corners.map((point) => next[point]++);
  const order = new Uint32Array(corners.length);
  for (const [corner, at] of place.entries()) order[at] = corner;
  return { order, place, used };
}

function pointColours({ colours }: ObjFile, points: number, notes: string[]): Variable[] {
  if (colours.length === 3 * points) return [{ name: 'color', components: 3, values: asBytes(colours.toArray()) }];
  if (colours.length > 0) notes.push('Not carried: colours, since not every point has one.');
  return [];
}

/** Whether every corner has a value; throws if one names a value that does not exist. */
function isComplete({ keyword, variable, components, values, indices }: CornerData, notes: string[]): boolean {
  const all = indices.toArray();
  const count = values.length / components;
  const wrong = all.find((index) => index >= count && index !== missing);
  if (wrong !== undefined) {
    throw new FormatError('bad_index', `A face names ${keyword} ${wrong + 1}, but the file has only ${count}.`, 'face');
  }
  if (!all.includes(missing)) return true;
  if (all.some((index) => index !== missing)) notes.push(`Not carried: ${variable}, since not every corner has one.`);
  return false;
}
