import type { Mesh, Variable } from '../../../wasm/types.ts';
import { labelArrays } from '../regions/label-arrays.ts';
import type { WriteOptions } from '../surface.ts';
import { areBytes } from '../variables/colours.ts';
import { byRole, type Role, spellings } from '../variables/roles.ts';
import { asWhole, type WholeArray, wholeTypeIn } from '../variables/whole-numbers.ts';
import type { WholeType } from '../variables/whole-types.ts';
import { encodeName } from './legacy-vtk-text.ts';

const cornerCount = 3;

/**
 * Writes a legacy VTK file, binary, version 4.2, which every VTK reads. Variables are arrays of a FIELD, so that any number of
 * components and both precisions come back bit for bit, but for normals, texture coordinates, ids and colours of bytes, which
 * have keywords of their own; units and component names go to METADATA.
 */
export function writeVtk(mesh: Mesh, options: WriteOptions = {}): Uint8Array {
  const points = mesh.position.length / 3;
  const triangles = mesh.triangles.length / cornerCount;
  const title = '# vtk DataFile Version 4.2\nwritten by Meshbound\nBINARY\nDATASET POLYDATA\n';
  const position = { name: 'position', components: 3, values: mesh.position };
  const chunks: Chunk[] = [
    `${title}POINTS ${points} ${typeOf(mesh.position)}\n`,
    mesh.position,
    `\n${metadata(position, options)}POLYGONS ${triangles} ${triangles * (cornerCount + 1)}\n`,
    cellLists(mesh.triangles),
    ...labelChunks(mesh, options),
    mesh.variables.length > 0 ? `\nPOINT_DATA ${points}\n` : '\n',
    ...pointChunks(mesh, options),
  ];
  return joined(chunks);
}

/** The variables in their order: those with keywords of their own, and the others in FIELDs between them. */
function pointChunks({ variables, position }: Mesh, options: WriteOptions): Chunk[] {
  const points = position.length / 3;
  const keywords = keywordsOf(variables, options);
  return variables.flatMap((variable, i) => {
    const { name, components, values } = variable;
    const whole = wholeTypeIn('vtk', variable, options);
    const type = whole ? wholeNames[whole] : typeOf(values);
    const keyword = keywords.get(variable);
    const next = variables.findIndex((other, at) => at > i && keywords.has(other));
    const first = i === 0 || keywords.has(variables[i - 1]);
    const field = first ? `FIELD FieldData ${(next < 0 ? variables.length : next) - i}\n` : '';
    const head = keyword?.(encodeName(name), type) ?? `${field}${encodeName(name)} ${components} ${points} ${type}`;
    return [`${head}\n`, whole ? asWhole(values, whole) : values, `\n${metadata(variable, options)}`];
  });
}

type Head = (name: string, type: string) => string;

/** How the arrays begin that have a keyword. */
function keywordsOf(variables: Variable[], options: WriteOptions): Map<Variable, Head> {
  const heads = [...byRole(variables, options)].flatMap(([role, variable]): [Variable, Head][] => {
    const head = headOf(role, variable, options);
    return head ? [[variable, head]] : [];
  });
  return new Map(heads);
}

function headOf(role: Role, variable: Variable, options: WriteOptions): Head | undefined {
  const keyword = spellings[role].vtk;
  const { components } = variable;
  if (role === 'textureCoordinates') return (name, type) => `${keyword} ${name} ${components} ${type}`;
  if (role !== 'colour') return (name, type) => `${keyword} ${name} ${type}`;
  // They are bytes there, and VTK expects no METADATA behind them.
  const isPlain = areBytes(variable.values) && metadata(variable, options) === '';
  return isPlain ? (name) => `${keyword} ${name} ${components}` : undefined;
}

/** Labels of the triangles, as cell data. */
function labelChunks(mesh: Mesh, options: WriteOptions): Chunk[] {
  const arrays = labelArrays(mesh, options);
  if (arrays.length === 0) return [];
  const triangles = mesh.triangles.length / cornerCount;
  const chunks = arrays.flatMap(([name, labels]) => [`\n${encodeName(name)} 1 ${triangles} int\n`, labels]);
  return [`\nCELL_DATA ${triangles}\nFIELD FieldData ${arrays.length}`, ...chunks];
}

type Numbers = Float32Array | Float64Array | WholeArray;
type Chunk = string | Numbers;

/** What whole numbers are called; `long` has not everywhere the same size, and `char` not everywhere a sign. */
const wholeNames: Record<WholeType, string> = {
  int8: 'signed_char',
  uint8: 'unsigned_char',
  int16: 'short',
  uint16: 'unsigned_short',
  int32: 'int',
  uint32: 'unsigned_int',
  int64: 'vtktypeint64',
  uint64: 'vtktypeuint64',
};

function typeOf(values: Float32Array | Float64Array): string {
  return values instanceof Float64Array ? 'double' : 'float';
}

/** Each triangle as its number of corners and these. */
function cellLists(triangles: Uint32Array): Int32Array {
  const lists = new Int32Array((triangles.length / cornerCount) * (cornerCount + 1));
  for (let from = 0, to = 0; from < triangles.length; from += cornerCount, to += cornerCount + 1) {
    lists[to] = cornerCount;
    for (let corner = 0; corner < cornerCount; corner++) lists[to + 1 + corner] = triangles[from + corner];
  }
  return lists;
}

/** Ends with an empty line, which is how readers know that it is over. */
function metadata({ name }: Variable, { units = {}, componentNames = {} }: WriteOptions): string {
  const lines: string[] = [];
  if (Object.hasOwn(componentNames, name)) lines.push('COMPONENT_NAMES', ...componentNames[name].map(encodeName));
  if (Object.hasOwn(units, name) && units[name] !== '') {
    lines.push('INFORMATION 1', 'NAME UNITS_LABEL LOCATION vtkDataArray', `DATA ${encodeName(units[name])}`);
  }
  return lines.length > 0 ? `METADATA\n${lines.join('\n')}\n\n` : '';
}

function joined(chunks: Chunk[]): Uint8Array {
  const parts = chunks.map((chunk) => (typeof chunk === 'string' ? new TextEncoder().encode(chunk) : chunk));
  const file = new Uint8Array(parts.reduce((sum, part) => sum + part.byteLength, 0));
  let at = 0;
  for (const part of parts) {
    if (part instanceof Uint8Array) file.set(part, at);
    else writeBigEndian(new DataView(file.buffer, at, part.byteLength), part);
    at += part.byteLength;
  }
  return file;
}

function writeBigEndian(view: DataView, values: Exclude<Numbers, Uint8Array>): void {
  const size = values.BYTES_PER_ELEMENT;
  new Uint8Array(view.buffer, view.byteOffset, view.byteLength).set(
    new Uint8Array(values.buffer, values.byteOffset, values.byteLength),
  );
  for (let at = 0; at < view.byteLength; at += size) new Uint8Array(view.buffer, view.byteOffset + at, size).reverse();
}
