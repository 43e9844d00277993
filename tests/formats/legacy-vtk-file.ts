import fc from 'fast-check';
import type { Variable } from '../../wasm/types.ts';
import type { Labels } from '../../web/formats/surface.ts';

/** A part of a file: a line of text without its break, or bytes. */
export type Part = string | Uint8Array;

type Kind = 'SCALARS' | 'VECTORS' | 'NORMALS' | 'TENSORS' | 'TEXTURE_COORDINATES' | 'FIELD';

interface ArrayModel {
  kind: Kind;
  name: string;
  type: string;
  components: number;
  /** A value of the type for each point and component. */
  values: number[];
  unit: string;
  componentNames: string[];
}

/** What a legacy VTK file says, for writing it in every way that the format has. */
export interface LegacyVtkModel {
  version: string;
  binary: boolean;
  points: number[];
  triangles: number[][];
  strip: boolean;
  cellData: boolean;
  arrays: ArrayModel[];
}

const componentsOf: Record<Kind, number[]> = {
  SCALARS: [1, 2, 3, 4],
  VECTORS: [3],
  NORMALS: [3],
  TENSORS: [9],
  TEXTURE_COORDINATES: [1, 2, 3],
  FIELD: [1, 2, 5, 7],
};

type Setter = (view: DataView, at: number, value: number) => void;

/** Sizes of the types, and what writes a value. */
const types = new Map<string, [size: number, set: Setter]>([
  ['char', [1, (view, at, value) => view.setInt8(at, value)]],
  ['unsigned_char', [1, (view, at, value) => view.setUint8(at, value)]],
  ['short', [2, (view, at, value) => view.setInt16(at, value)]],
  ['unsigned_short', [2, (view, at, value) => view.setUint16(at, value)]],
  ['int', [4, (view, at, value) => view.setInt32(at, value)]],
  ['unsigned_int', [4, (view, at, value) => view.setUint32(at, value)]],
  ['vtkIdType', [4, (view, at, value) => view.setInt32(at, value)]],
  ['long', [8, (view, at, value) => view.setBigInt64(at, BigInt(value))]],
  ['vtktypeint64', [8, (view, at, value) => view.setBigInt64(at, BigInt(value))]],
  ['float', [4, (view, at, value) => view.setFloat32(at, value)]],
  ['double', [8, (view, at, value) => view.setFloat64(at, value)]],
]);

const pointCount = 5;
const word = fc.string({ unit: fc.constantFrom(...'aZ9_-.:#/'), minLength: 1, maxLength: 8 });

function arrayModel(): fc.Arbitrary<ArrayModel> {
  const kinds = Object.keys(componentsOf) as Kind[];
  return fc.constantFrom(...kinds).chain((kind) =>
    fc.constantFrom(...componentsOf[kind]).chain((components) =>
      fc.record({
        kind: fc.constant(kind),
        name: word,
        type: fc.constantFrom(...types.keys()),
        components: fc.constant(components),
        // What every type holds, and text gives back.
        values: fc.array(fc.nat(100), { minLength: pointCount * components, maxLength: pointCount * components }),
        unit: fc.option(word, { nil: '' }),
        componentNames: fc.option(fc.array(word, { minLength: components, maxLength: components }), {
          nil: [] as string[],
        }),
      }),
    ),
  );
}

export function legacyVtkModel(): fc.Arbitrary<LegacyVtkModel> {
  const corner = fc.nat(pointCount - 1);
  const coordinate = fc.integer({ min: -64, max: 64 }).map((value) => value / 8);
  return fc.record({
    version: fc.constantFrom('1.0', '2.0', '3.0', '4.2', '5.0', '5.1'),
    binary: fc.boolean(),
    points: fc.array(coordinate, { minLength: 3 * pointCount, maxLength: 3 * pointCount }),
    triangles: fc.array(fc.tuple(corner, corner, corner), { minLength: 1, maxLength: 4 }),
    strip: fc.boolean(),
    cellData: fc.boolean(),
    arrays: fc.uniqueArray(arrayModel(), { maxLength: 4, selector: ({ name }) => name }),
  });
}

/** The units and names of components that the file holds. */
export function labelsOf({ arrays }: LegacyVtkModel): Labels {
  const named = arrays.filter(({ componentNames }) => componentNames.length > 0);
  return {
    units: Object.fromEntries(arrays.filter(({ unit }) => unit).map(({ name, unit }) => [name, unit])),
    componentNames: Object.fromEntries(named.map(({ name, componentNames }) => [name, componentNames])),
  };
}

/** The variables that the file holds; their precision is left open. */
export function variablesOf({ arrays }: LegacyVtkModel): Pick<Variable, 'name' | 'components' | 'values'>[] {
  return arrays.map(({ name, components, values }) => ({ name, components, values: Float64Array.from(values) }));
}

export function legacyVtkParts(model: LegacyVtkModel): Part[] {
  const { version, binary, points, triangles, strip, cellData, arrays } = model;
  const head = [`# vtk DataFile Version ${version}`, 'a title', binary ? 'BINARY' : 'ASCII', 'DATASET POLYDATA'];
  const cells = [...cellParts('POLYGONS', triangles, model)];
  if (strip) cells.push(...cellParts('TRIANGLE_STRIPS', [[0, 1, 2, 3]], model));
  const cellCount = triangles.length + (strip ? 1 : 0);
  const ofCells = cellData
    ? [
        `CELL_DATA ${cellCount}`,
        'SCALARS region int',
        'LOOKUP_TABLE default',
        ...numbers(Array(cellCount).fill(7), 'int', binary),
      ]
    : [];
  return [
    ...head,
    `POINTS ${pointCount} float`,
    ...numbers(points, 'float', binary),
    ...cells,
    ...ofCells,
    `POINT_DATA ${pointCount}`,
    ...arrays.flatMap((array) => arrayParts(array, binary)),
  ];
}

function numbers(values: number[], type: string, binary: boolean): Part[] {
  if (!binary) return [values.join(' ')];
  const [size, set] = types.get(type) ?? [4, () => {}];
  const bytes = new Uint8Array(size * values.length);
  for (const [index, value] of values.entries()) set(new DataView(bytes.buffer), size * index, value);
  return [bytes, ''];
}

/** Lists with their lengths; from version 5 on offsets and corners. */
function cellParts(keyword: string, cells: number[][], { version, binary }: LegacyVtkModel): Part[] {
  const corners = cells.flat();
  if (Number(version) < 5) {
    const lists = cells.flatMap((cell) => [cell.length, ...cell]);
    return [`${keyword} ${cells.length} ${lists.length}`, ...numbers(lists, 'int', binary)];
  }
  const offsets = [0, ...cells.map((_, index) => cells.slice(0, index + 1).flat().length)];
  return [
    `${keyword} ${offsets.length} ${corners.length}`,
    'OFFSETS vtktypeint64',
    ...numbers(offsets, 'vtktypeint64', binary),
    'CONNECTIVITY vtktypeint64',
    ...numbers(corners, 'vtktypeint64', binary),
  ];
}

function arrayParts(
  { kind, name, type, components, values, unit, componentNames }: ArrayModel,
  binary: boolean,
): Part[] {
  const heads: Record<Kind, string[]> = {
    SCALARS: [`SCALARS ${name} ${type} ${components}`, 'LOOKUP_TABLE default'],
    VECTORS: [`VECTORS ${name} ${type}`],
    NORMALS: [`NORMALS ${name} ${type}`],
    TENSORS: [`TENSORS ${name} ${type}`],
    TEXTURE_COORDINATES: [`TEXTURE_COORDINATES ${name} ${components} ${type}`],
    FIELD: ['FIELD FieldData 1', `${name} ${components} ${pointCount} ${type}`],
  };
  const labels = [
    ...(componentNames.length > 0 ? ['COMPONENT_NAMES', ...componentNames] : []),
    ...(unit ? ['INFORMATION 1', 'NAME UNITS_LABEL LOCATION vtkDataArray', `DATA ${unit}`] : []),
  ];
  return [...heads[kind], ...numbers(values, type, binary), ...(labels.length > 0 ? ['METADATA', ...labels, ''] : [])];
}

/** The parts one after the other; a line has a break behind it, bytes have none. */
export function joined(parts: Part[]): Uint8Array {
  const chunks = parts.map((part) => (typeof part === 'string' ? new TextEncoder().encode(`${part}\n`) : part));
  const file = new Uint8Array(chunks.reduce((sum, chunk) => sum + chunk.length, 0));
  let at = 0;
  for (const chunk of chunks) {
    file.set(chunk, at);
    at += chunk.length;
  }
  return file;
}
