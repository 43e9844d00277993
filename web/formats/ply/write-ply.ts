import type { Mesh, Variable } from '../../../wasm/types.ts';
import { FormatError } from '../format-error.ts';
import { labelArrays } from '../regions/label-arrays.ts';
import type { WriteOptions } from '../surface.ts';
import { byRole } from '../variables/roles.ts';
import { wholeTypeIn } from '../variables/whole-numbers.ts';
import type { WholeType } from '../variables/whole-types.ts';
import { groupProperties, type PlyVariable, propertyNames } from './ply-variables.ts';

type Values = Float32Array | Float64Array;

/** A property of a vertex: a component of a variable. */
interface Column {
  name: string;
  type: keyof typeof columnTypes;
  values: Values;
  step: number;
  offset: number;
}

type SetNumber = (this: DataView, at: number, value: number, littleEndian: boolean) => void;

/** For each type how many bytes it takes, and how a number of it is set. */
const columnTypes = {
  char: { size: 1, set: DataView.prototype.setInt8 as SetNumber },
  uchar: { size: 1, set: DataView.prototype.setUint8 as SetNumber },
  short: { size: 2, set: DataView.prototype.setInt16 },
  ushort: { size: 2, set: DataView.prototype.setUint16 },
  int: { size: 4, set: DataView.prototype.setInt32 },
  uint: { size: 4, set: DataView.prototype.setUint32 },
  float: { size: 4, set: DataView.prototype.setFloat32 },
  double: { size: 8, set: DataView.prototype.setFloat64 },
};

/** What whole numbers are called; PLY has none of 64 bits. */
const wholeNames: Partial<Record<WholeType, Column['type']>> = {
  int8: 'char',
  uint8: 'uchar',
  int16: 'short',
  uint16: 'ushort',
  int32: 'int',
  uint32: 'uint',
};

/** Labels of the faces: a property of theirs. */
interface LabelColumn {
  /** Of the array, and of the property. */
  name: string;
  property: string;
  labels: Int32Array;
}

/** A face: one byte that says three, and three indices; behind them its labels, where there are any. */
const faceSize = 1 + 3 * 4;
const labelSize = 4;

/**
 * Writes a PLY file that readPly gives back bit for bit: float stays float, double stays double, and every variable its
 * name, components and unit; labels of triangles are a property of the faces. Vectors are written under their usual property names; where those would not lead back to the
 * variables (names with spaces, a scalar named velocity_x) comments say what belongs together.
 */
export function writePly(mesh: Mesh, options: WriteOptions = {}): Uint8Array {
  const encoding = options.encoding ?? 'binary_little_endian';
  const groups = nameProperties(mesh.variables, options);
  const columns = vertexColumns(mesh, groups, options);
  const labels = labelColumns(mesh, options);
  const header = headerText(mesh, groups, columns, labels, encoding, options);
  if (encoding === 'ascii') return new TextEncoder().encode(header + asciiBody(mesh, columns, labels));
  return binaryFile(new TextEncoder().encode(header), mesh, columns, labels, encoding === 'binary_little_endian');
}

function nameProperties(variables: Variable[], options: WriteOptions): PlyVariable[] {
  const used = new Set(['x', 'y', 'z']);
  const roles = new Map([...byRole(variables, options)].map(([role, variable]) => [variable, role]));
  return variables.map((variable) => {
    const { name, components } = variable;
    const properties = propertyNames(wordOf(name), components, roles.get(variable)).map((property) =>
      unique(property, used),
    );
    return { name, properties };
  });
}

/** PLY separates words by spaces and is read as ASCII by most programs. */
function wordOf(name: string): string {
  return name.replace(/[^!-~]+/g, '_') || 'variable';
}

function unique(name: string, used: Set<string>): string {
  let free = name;
  for (let copy = 2; used.has(free); copy++) free = `${name}__${copy}`;
  used.add(free);
  return free;
}

function vertexColumns(mesh: Mesh, groups: PlyVariable[], options: WriteOptions): Column[] {
  const position = { name: 'position', components: 3, values: mesh.position };
  const columns = columnsOf(position, ['x', 'y', 'z'], typeOf(mesh.position));
  for (const [index, group] of groups.entries()) {
    const variable = mesh.variables[index];
    const whole = wholeTypeIn('ply', variable, options);
    const type = (whole && wholeNames[whole]) ?? typeOf(variable.values);
    columns.push(...columnsOf(variable, group.properties, type));
  }
  return columns;
}

function columnsOf({ values, components }: Variable, properties: string[], type: Column['type']): Column[] {
  return properties.map((name, offset) => ({ name, type, values, step: components, offset }));
}

function typeOf(values: Values): Column['type'] {
  return values instanceof Float64Array ? 'double' : 'float';
}

function headerText(
  mesh: Mesh,
  groups: PlyVariable[],
  columns: Column[],
  labels: LabelColumn[],
  encoding: string,
  options: WriteOptions,
): string {
  const vertices = mesh.position.length / 3;
  // Signed indices are what every program reads; beyond them there is no room in memory anyway.
  if (vertices > 2 ** 31)
    throw new FormatError('too_large', 'PLY indices are 32-bit; the mesh has more points than that.');
  const lines = ['ply', `format ${encoding} 1.0`, 'comment written by Meshbound', ...commentLines(groups, options)];
  for (const { name, property } of labels)
    if (property !== name) lines.push(`comment regions ${JSON.stringify(name)} ${property}`);
  lines.push(`element vertex ${vertices}`);
  for (const { type, name } of columns) lines.push(`property ${type} ${name}`);
  lines.push(`element face ${mesh.triangles.length / 3}`, 'property list uchar int vertex_indices');
  for (const { property } of labels) lines.push(`property int ${property}`);
  lines.push('end_header', '');
  return lines.join('\n');
}

function commentLines(groups: PlyVariable[], { units = {}, componentNames = {} }: WriteOptions): string[] {
  const lines: string[] = [];
  const asRead = groupProperties(groups.flatMap((group) => group.properties));
  if (JSON.stringify(asRead) !== JSON.stringify(groups)) {
    for (const { name, properties } of groups)
      lines.push(`comment variable ${JSON.stringify(name)} ${properties.join(' ')}`);
  }
  const names = ['position', ...groups.map((group) => group.name)];
  for (const name of names) {
    const unit = Object.hasOwn(units, name) && oneLine(units[name]);
    if (unit) lines.push(`comment unit ${/^[!#-~][!-~]*$/.test(name) ? name : JSON.stringify(name)} ${unit}`);
    const components = Object.hasOwn(componentNames, name) && componentNames[name];
    if (components) lines.push(`comment components ${JSON.stringify(name)} ${JSON.stringify(components)}`);
  }
  return lines;
}

/** None is called as the list of the corners may be. */
function labelColumns(mesh: Mesh, options: WriteOptions): LabelColumn[] {
  const used = new Set(['vertex_indices', 'vertex_index']);
  return labelArrays(mesh, options).map(([name, labels]) => ({ name, property: unique(wordOf(name), used), labels }));
}

function oneLine(text: string): string {
  return text.replace(/\s+/g, ' ').trim();
}

function asciiBody(mesh: Mesh, columns: Column[], labels: LabelColumn[]): string {
  const lines: string[] = [];
  for (let vertex = 0; vertex < mesh.position.length / 3; vertex++) {
    lines.push(columns.map(({ values, step, offset }) => asciiNumber(values[vertex * step + offset])).join(' '));
  }
  for (let at = 0; at < mesh.triangles.length; at += 3) {
    const labelsHere = labels.map((column) => column.labels[at / 3]);
    lines.push(['3', ...mesh.triangles.subarray(at, at + 3), ...labelsHere].join(' '));
  }
  return `${lines.join('\n')}\n`;
}

/** The shortest digits that give the number back; JavaScript's own drop the sign of −0 and C reads nan and inf. */
function asciiNumber(value: number): string {
  if (Number.isNaN(value)) return 'nan';
  if (!Number.isFinite(value)) return value > 0 ? 'inf' : '-inf';
  return Object.is(value, -0) ? '-0' : String(value);
}

function binaryFile(
  header: Uint8Array,
  mesh: Mesh,
  columns: Column[],
  labels: LabelColumn[],
  littleEndian: boolean,
): Uint8Array {
  const vertices = mesh.position.length / 3;
  const vertexSize = columns.reduce((sum, { type }) => sum + columnTypes[type].size, 0);
  const rowSize = faceSize + labelSize * labels.length;
  const file = new Uint8Array(header.length + vertices * vertexSize + (mesh.triangles.length / 3) * rowSize);
  file.set(header);
  const view = new DataView(file.buffer);
  let start = header.length;
  for (const column of columns) {
    writeColumn(view, start, vertexSize, column, littleEndian);
    start += columnTypes[column.type].size;
  }
  writeFaces(view, header.length + vertices * vertexSize, mesh, labels, littleEndian);
  return file;
}

function writeColumn(view: DataView, start: number, vertexSize: number, column: Column, littleEndian: boolean): void {
  const { type, values, step, offset } = column;
  const { set } = columnTypes[type];
  for (let i = offset, at = start; i < values.length; i += step, at += vertexSize) {
    set.call(view, at, values[i], littleEndian);
  }
}

function writeFaces(
  view: DataView,
  start: number,
  { triangles }: Mesh,
  columns: LabelColumn[],
  littleEndian: boolean,
): void {
  let at = start;
  for (let i = 0; i < triangles.length; i += 3) {
    view.setUint8(at, 3);
    for (let corner = 0; corner < 3; corner++) view.setInt32(at + 1 + 4 * corner, triangles[i + corner], littleEndian);
    at += faceSize;
    for (const { labels } of columns) {
      view.setInt32(at, labels[i / 3], littleEndian);
      at += labelSize;
    }
  }
}
