import type { Mesh, Variable } from '../../../wasm/types.ts';
import { GrowingIndices, GrowingNumbers, GrowingPolygons } from '../bytes/growing-arrays.ts';
import { gather } from '../cracks/weld.ts';
import { weldedSurface } from '../cracks/welded-surface.ts';
import { checkCorners, type Polygons, polygonNotes, triangulate } from '../faces/polygons.ts';
import { FormatError } from '../format-error.ts';
import { regionNotes } from '../regions/region-notes.ts';
import type { Surface } from '../surface.ts';
import { parseNumber } from '../text/ascii-numbers.ts';
import { cutNotes, numbersFrom, type TextLine, textLines } from '../text/text-lines.ts';
import { counted, listed, quoted } from '../text/wording.ts';
import { asBytes } from '../variables/colours.ts';
import { labelsOfTriangles } from '../vtk-data/vtk-pieces.ts';

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
  /** Which of the values are no numbers in the file. */
  broken: Set<number>;
}

function cornerData(variable: string, keyword: string, components: number): CornerData {
  const [values, indices] = [new GrowingNumbers(), new GrowingIndices()];
  return { variable, keyword, components, values, indices, broken: new Set() };
}

/** A corner without an index, and one whose index is of nothing. */
const [missing, broken] = [0xffffffff, 0xfffffffe];
/** Lines that draw, group or refine without changing the surface. */
const ignored = new Set(['s', 'mg', 'bevel', 'c_interp', 'd_interp', 'lod', 'shadow_obj', 'trace_obj', 'end']);
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
/** Lines of numbers, which may go on in the next line behind a backslash and have comments at their ends; others have names. */
const numeric = new Set(['v', 'vt', 'vn', 'f', 'fo', 'l', 'p', ...freeForm]);
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
  corners: CornerData[] = [cornerData('uv', 'vt', 2), cornerData('normal', 'vn', 3)];
  materials = new Materials();
  lost = new Set<string>();
  /** How many lines begin with each keyword that is not known. */
  unknown = new Map<string, number>();
  /** How many faces have too few corners to be one. */
  shortFaces = 0;

  read(line: TextLine): void {
    const keyword = line.words[0];
    const data = this.corners.find((corner) => corner.keyword === keyword);
    if (keyword === 'v') this.readPoint(line);
    else if (data) this.readCornerData(line, data);
    else if (keyword === 'f' || keyword === 'fo') this.readFace(line);
    else if (keyword === 'usemtl') this.materials.use(line.words.slice(1).join(' '));
    else if (lossy.has(keyword)) this.lost.add(lossy.get(keyword) ?? keyword);
    else if (!ignored.has(keyword)) this.unknown.set(keyword, 1 + (this.unknown.get(keyword) ?? 0));
  }

  /** `v x y z`, `v x y z w` with a weight that is 1 but for free forms or, with a colour, `v x y z r g b`. */
  private readPoint(line: TextLine): void {
    for (const coordinate of numbersFrom(line, 1, 3)) this.points.push(coordinate);
    const more = line.words.slice(4).map((word) => parseNumber(word) ?? Number.NaN);
    if (more.length >= 3) for (const part of more.slice(0, 3)) this.colours.push(part);
    const isCarried = more.length === 0 || more.length === 3 || (more.length === 1 && more[0] === 1);
    if (!isCarried) this.lost.add('numbers of points beyond places and colours');
  }

  /** `vn x y z` or `vt u v w`, of which v and w may be missing and are 0 then. */
  private readCornerData({ words }: TextLine, { keyword, components, values, broken }: CornerData): void {
    const numbers = words.slice(1, 1 + components).map(parseNumber);
    if (keyword === 'vt' && numbers.length === 1) numbers.push(0);
    if (numbers.length < components || numbers.includes(undefined)) broken.add(values.length / components);
    for (let i = 0; i < components; i++) values.push(numbers[i] ?? Number.NaN);
    if (keyword === 'vt' && words.length > 3 && parseNumber(words[3]) !== 0) this.lost.add('third texture coordinates');
  }

  private readFace(line: TextLine): void {
    const words = line.words.slice(1);
    if (words.length < 3) {
      this.shortFaces++;
      return;
    }
    for (const word of words) {
      const indices = word.split('/');
      this.faces.addCorner(resolve(indices[0], this.points.length / 3, line));
      for (const [place, { values, components, indices: list }] of this.corners.entries()) {
        const index = indices[place + 1];
        list.push(index ? (indexOf(index, values.length / components) ?? broken) : missing);
      }
    }
    this.faces.endPolygon();
    this.materials.endFace();
  }
}

/**
 * Indices count from 1, or backwards from the last with −1; undefined for what is none. Whether a later line makes them valid
 * is not known yet.
 */
function indexOf(word: string, count: number): number | undefined {
  const index = /^-?\d{1,10}$/.test(word) ? Number(word) : 0;
  const resolved = index > 0 ? index - 1 : count + index;
  return index !== 0 && resolved >= 0 && resolved < broken ? resolved : undefined;
}

/** The same for what must be one. */
function resolve(word: string, count: number, { number }: TextLine): number {
  const index = indexOf(word, count);
  if (index !== undefined) return index;
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
    const none = file.shortFaces > 0 ? 'no faces of three corners' : 'no faces';
    throw new FormatError('no_triangles', `The file has ${counted(points, 'point')}, but ${none}.`);
  }
  checkCorners(polygons, points, 'face');
  const materials = file.materials.names();
  if (materials.size === 1 && !materials.has(0)) file.lost.add('the material');
  const notes = file.lost.size > 0 ? [`Not carried: ${[...file.lost].join(', ')}.`] : [];
  notes.push(...unknownNotes(file));
  const { position, variables, ends, corners, copies } = spread(file, polygons, notes);
  const { triangles, split } = triangulate({ corners, ends }, position, 'face');
  notes.push(...polygonNotes('face', split, file.shortFaces));
  const surface = weldedSurface({ position, triangles, variables }, notes, copies);
  const labels = materials.size > 1 ? materialLabels(file, polygons, materials) : {};
  return { ...surface, ...labels, notes: [...surface.notes, ...regionNotes(labels.regions), ...cutNotes(bytes)] };
}

function materialLabels({ materials }: ObjFile, polygons: Polygons, names: Map<number, string>): Partial<Surface> {
  const labels = labelsOfTriangles(materials.ofFaces.toArray(), 0, polygons);
  return { regions: new Map([[materialArray, labels]]), regionNames: new Map([[materialArray, names]]) };
}

/** What began lines that no OBJ file should have: a sentence, or none. */
function unknownNotes({ unknown }: ObjFile): string[] {
  if (unknown.size === 0) return [];
  const lines = [...unknown.values()].reduce((sum, count) => sum + count, 0);
  return [`${counted(lines, 'line')} passed over that no OBJ file has, beginning with ${listed([...unknown.keys()])}.`];
}

/** What may stand in a line that another one goes on in. */
const continuation = /^[-+.\d\\/#]/;

/** Lines without their comments, put together where a backslash says that one goes on. In names a backslash is a letter. */
function* wholeLines(bytes: Uint8Array): Generator<TextLine> {
  let begun: { parts: string[][]; last: number } | undefined;
  for (const { words, number } of textLines(bytes)) {
    if (begun && !(number === begun.last + 1 && continuation.test(words[0]))) {
      yield joined(begun);
      begun = undefined;
    }
    const isNumeric = begun !== undefined || numeric.has(words[0]);
    const plain = isNumeric ? withoutComment(words) : words[0].startsWith('#') ? [] : words;
    const goesOn = isNumeric && (plain.at(-1)?.endsWith('\\') ?? false);
    if (goesOn || begun) {
      begun = { parts: begun?.parts ?? [], last: number };
      begun.parts.push(goesOn ? plain.with(-1, (plain.at(-1) ?? '').slice(0, -1)) : plain);
    } else if (plain.length > 0) yield { words: plain, number };
    if (begun && !goesOn) {
      yield joined(begun);
      begun = undefined;
    }
  }
  if (begun) throw new FormatError('truncated', 'The file ends in a line that should go on.');
}

function joined({ parts, last }: { parts: string[][]; last: number }): TextLine {
  return { words: parts.flat().filter(Boolean), number: last };
}

/** The words of a line of numbers up to a comment. */
function withoutComment(words: string[]): string[] {
  const at = words.findIndex((word) => word.includes('#'));
  if (at < 0) return words;
  const before = words[at].slice(0, words[at].indexOf('#'));
  return [...words.slice(0, at), ...(before === '' ? [] : [before])];
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

/** Whether every corner has a value. */
function isComplete(data: CornerData, notes: string[]): boolean {
  const { keyword, variable, components, values, indices } = data;
  const all = indices.toArray();
  const count = values.length / components;
  const without = all.reduce((sum, index) => sum + (index >= count || data.broken.has(index) ? 1 : 0), 0);
  if (without === 0) return true;
  const lost = all.reduce((sum, index) => sum + (index === missing ? 0 : 1), 0) - (all.length - without);
  const why = lost > 0 ? ` (${counted(lost, 'corner')} with a ${keyword} that is not in the file, or no numbers)` : '';
  if (all.some((index) => index !== missing))
    notes.push(`Not carried: ${variable}, since not every corner has one${why}.`);
  return false;
}
