import type { Mesh, Variable } from '../../../wasm/types.ts';
import { FormatError } from '../format-error.ts';
import { labelArrays } from '../regions/label-arrays.ts';
import type { WriteOptions } from '../surface.ts';
import { quoted } from '../text/wording.ts';
import { byRole, spellings } from '../variables/roles.ts';
import { asWhole, type WholeArray, wholeTypeIn } from '../variables/whole-numbers.ts';

// Written by hand, appended raw: vtk.js's writer puts everything through base64 and an XML tree, and takes twenty times as long.

/** An array of the file. Every place where JavaScript runs today is little-endian, so arrays go out as they lie in memory. */
interface FileArray {
  name: string;
  components: number;
  values: Float32Array | Float64Array | WholeArray;
}

/** The size of the number that stands before each array. */
const headerSize = 8;

/** Writes a VTP file (VTK XML PolyData, appended raw data): float stays float, double stays double, bit for bit. */
export function writeVtp(mesh: Mesh, options: WriteOptions = {}): Uint8Array {
  const corners = Int32Array.from(mesh.triangles);
  const ends = Int32Array.from({ length: corners.length / 3 }, (_, triangle) => 3 * (triangle + 1));
  const position = { name: 'position', components: 3, values: mesh.position };
  const labels = labelArrays(mesh, options).map(([name, values]) => ({ name, components: 1, values }));
  const arrays: FileArray[] = [
    ...mesh.variables.map((each) => fileArray(each, options)),
    ...labels,
    position,
    { name: 'connectivity', components: 1, values: corners },
    { name: 'offsets', components: 1, values: ends },
  ];
  const offsets = offsetsOf(arrays);
  const tags = arrays.map((array, index) =>
    tagOf(array, array === position ? 'Points' : array.name, offsets[index], options),
  );
  const head = new TextEncoder().encode(headText(mesh, tags, declarations(mesh.variables, options)));
  const tail = new TextEncoder().encode('\n  </AppendedData>\n</VTKFile>\n');
  const file = new Uint8Array(head.length + offsets[arrays.length] + tail.length);
  file.set(head);
  for (const [index, array] of arrays.entries()) writeArray(file, head.length + offsets[index], array);
  file.set(tail, file.length - tail.length);
  return file;
}

function fileArray(variable: Variable, options: WriteOptions): FileArray {
  const type = wholeTypeIn('vtp', variable, options);
  return type ? { ...variable, values: asWhole(variable.values, type) } : variable;
}

const typeNames: [new (length: number) => FileArray['values'], string][] = [
  [Float32Array, 'Float32'],
  [Float64Array, 'Float64'],
  [Int8Array, 'Int8'],
  [Uint8Array, 'UInt8'],
  [Int16Array, 'Int16'],
  [Uint16Array, 'UInt16'],
  [Int32Array, 'Int32'],
  [Uint32Array, 'UInt32'],
  [BigInt64Array, 'Int64'],
  [BigUint64Array, 'UInt64'],
];

function typeOf(values: FileArray['values']): string {
  return typeNames.find(([type]) => values instanceof type)?.[1] ?? '';
}

/** Where each array begins behind the underscore, and where the last one ends. */
function offsetsOf(arrays: FileArray[]): number[] {
  let end = 0;
  return [0, ...arrays.map(({ values }) => (end += headerSize + values.byteLength))];
}

function writeArray(file: Uint8Array, at: number, { values }: FileArray): void {
  new DataView(file.buffer).setBigUint64(at, BigInt(values.byteLength), true);
  file.set(new Uint8Array(values.buffer, values.byteOffset, values.byteLength), at + headerSize);
}

/** Attributes of the point data that say which arrays are normals, texture coordinates, ids. */
function declarations(variables: Variable[], options: WriteOptions): string {
  const declared = [...byRole(variables, options)].map(([role, { name }]) => [spellings[role].vtp, name]);
  return declared.map(([attribute, name]) => (attribute ? ` ${attribute}="${escaped(name ?? '')}"` : '')).join('');
}

function headText(mesh: Mesh, tags: string[], declared: string): string {
  const [points, triangles] = [mesh.position.length / 3, mesh.triangles.length / 3];
  const [position, connectivity, offsets] = tags.slice(-3);
  const variables = tags.slice(0, mesh.variables.length);
  const labels = tags.slice(mesh.variables.length, -3);
  const cellData = labels.length > 0 ? `      <CellData>\n${labels.join('')}      </CellData>\n` : '';
  return `<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
  <PolyData>
    <Piece NumberOfPoints="${points}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="${triangles}">
      <PointData${declared}>
${variables.join('')}      </PointData>
${cellData}      <Points>
${position}      </Points>
      <Polys>
${connectivity}${offsets}      </Polys>
    </Piece>
  </PolyData>
  <AppendedData encoding="raw">
    _`;
}

function tagOf(
  array: FileArray,
  name: string,
  offset: number,
  { units = {}, componentNames = {} }: WriteOptions,
): string {
  const { components, values } = array;
  const names = Object.hasOwn(componentNames, array.name) ? componentNames[array.name] : [];
  const componentAttributes = names
    .map((component, index) => ` ComponentName${index}="${escaped(component)}"`)
    .join('');
  const attributes = `type="${typeOf(values)}" Name="${escaped(name)}" NumberOfComponents="${components}"${componentAttributes}`;
  const unit = Object.hasOwn(units, array.name) && escaped(units[array.name]);
  const key = `          <InformationKey name="UNITS_LABEL" location="vtkDataArray">${unit}</InformationKey>\n`;
  return `        <DataArray ${attributes} format="appended" offset="${offset}"${unit ? `>\n${key}        </DataArray>` : '/>'}\n`;
}

/** Text inside an attribute or element. XML has no way to write control characters and halves of surrogate pairs. */
function escaped(text: string): string {
  if (/[^\t\n\r\u{20}-\u{D7FF}\u{E000}-\u{FFFD}\u{10000}-\u{10FFFF}]/u.test(text)) {
    throw new FormatError('bad_name', `XML cannot hold the characters of the name ${quoted(text)}.`, quoted(text));
  }
  return text.replace(/[&<>"\t\n\r]/g, (letter) => `&#${letter.charCodeAt(0)};`);
}
