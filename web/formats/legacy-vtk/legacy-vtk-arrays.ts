import { FormatError } from '../format-error.ts';
import { type Labels, noLabels } from '../surface.ts';
import { grouped, quoted } from '../text/wording.ts';
import { roleSpelled } from '../variables/roles.ts';
import type { PointArray } from '../vtk-data/vtk-pieces.ts';
import { isFloat, wholeTypeOf } from '../vtk-data/vtk-values.ts';
import { decodeName, type LegacyVtkText } from './legacy-vtk-text.ts';
import { countOf, typeOf } from './legacy-vtk-words.ts';

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

/** Arrays are read alike for points (kept), for cells (kept if they can be labels) and for the whole file (only their names are). */
export interface Attributes {
  noun: string;
  /** How many tuples an array must have; undefined where each says so itself. */
  tuples: number | undefined;
  arrays: PointArray[];
  /** What is skipped: texts, what cannot be labels of cells, all arrays of the file. */
  lost: string[];
}

/** Reads the array that a keyword announces: SCALARS, VECTORS … */
export function readAttribute(
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
  const shape = { name: words[1], components, tuples };
  if (keyword === 'SCALARS' && text.peek()[0]?.toUpperCase() === 'LOOKUP_TABLE') text.words();
  const type = words[keyword === 'TEXTURE_COORDINATES' ? 3 : 2];
  if (keyword === 'COLOR_SCALARS') readColours(shape, text, attributes, labels);
  else {
    const array = readArray({ ...shape, type }, text, attributes, labels);
    array.role = roleSpelled('vtk', keyword);
  }
}

/** Bytes, which text files hold as fractions of 255. */
function readColours(
  shape: Omit<ArrayShape, 'type'>,
  text: LegacyVtkText,
  attributes: Attributes,
  labels: Labels,
): void {
  const array = readArray({ ...shape, type: text.binary ? 'unsigned_char' : 'float' }, text, attributes, labels);
  array.role = 'colour';
  if (text.binary) return;
  array.values = array.values.map((fraction: number) => Math.round(255 * fraction));
  array.integers = true;
}

function componentsOf(keyword: string, words: string[], text: LegacyVtkText): number | undefined {
  if (keyword === 'SCALARS') return words.length > 3 ? countOf(words[3], text) : 1;
  if (keyword === 'COLOR_SCALARS' || keyword === 'TEXTURE_COORDINATES') return countOf(words[2], text);
  return fixedAttributes.get(keyword);
}

/** Reads the arrays of a FIELD. */
export function readField(words: string[], text: LegacyVtkText, attributes: Attributes, labels: Labels): void {
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

function readArray(shape: ArrayShape, text: LegacyVtkText, attributes: Attributes, labels: Labels): PointArray {
  const { components, tuples } = shape;
  const name = decodeName(shape.name ?? '', text.place());
  const where = `array ${quoted(name)}`;
  const type = shape.type?.toLowerCase();
  const isPoints = attributes.noun === 'point data';
  const array: PointArray = { name, components, values: new Float32Array(), integers: false };
  if (type === 'string' || type === 'utf8_string' || type === 'variant') {
    skipTexts(type, components * tuples, text, where);
  } else {
    const numberType = typeOf(type, text);
    Object.assign(array, {
      values: text.numbers(numberType, components * tuples, where),
      integers: !isFloat(numberType),
      wholeType: wholeTypeOf(numberType),
    });
  }
  const isFirst = !attributes.arrays.some((other) => other.name === name);
  readMetadata(text, array, isPoints && isFirst ? labels : noLabels());
  const whole = components > 0 && array.values.length === components * tuples;
  const isLabel = attributes.noun === 'cell data' && components === 1;
  if (whole && (isPoints || isLabel)) attributes.arrays.push(array);
  else attributes.lost.push(name);
  return array;
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

/** A line each; that of a component without a name is empty, and it is called by its number. */
function readComponentNames(text: LegacyVtkText, components: number): string[] {
  const names: string[] = [];
  while (names.length < components) {
    const line = text.line();
    if (line === undefined) break;
    names.push(decodeName(line, text.place()) || String(names.length));
  }
  return names;
}

/** The METADATA that may follow an array, up to the next empty line: names of components, and the unit among other things. */
export function readMetadata(
  text: LegacyVtkText,
  { name, components }: PointArray,
  { units, componentNames }: Labels,
): void {
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
    const names = readComponentNames(text, components);
    if (names.length === components) componentNames[name] = names;
  }
}
