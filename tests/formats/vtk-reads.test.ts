import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import type { Mesh, Variable } from '../../wasm/types.ts';
import { readSurface } from '../../web/formats/read.ts';
import type { Format, Labels, WriteOptions } from '../../web/formats/surface.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { mustSkip } from '../skipping.ts';
import { bits, mixedVariables, smallMesh, withinSingles } from './sample-mesh.ts';

/** Point data as vtk_dump.py prints it. */
interface VtkArray {
  name: string | null;
  type: string;
  components: number;
  /** In hexadecimal, little-endian. */
  bytes: string;
  unit: string | null;
  componentNames: string[] | null;
}

interface VtkSurface {
  points: VtkArray;
  corners: number[];
  offsets: number[];
  /** Numbers of cells that are no polygons, by their kind. */
  others: Record<string, number>;
  /** Names of the arrays that VTK takes for normals and so on. */
  active: Record<string, string>;
  arrays: VtkArray[];
}

interface VtkAnswer {
  read: Record<string, VtkSurface>;
  original: VtkSurface;
  written: Record<string, VtkSurface>;
  drawn: Record<string, VtkSurface>;
}

// Debian's own first: another one on the path seldom has Debian's VTK.
const python = ['/usr/bin/python3', 'python3'].find(
  (command) =>
    spawnSync(command, ['-c', 'import numpy, vtkmodules.vtkIOXML, vtkmodules.vtkIOPLY, vtkmodules.vtkIOGeometry'])
      .status === 0,
);

const labels: Labels = {
  units: { position: 'mm', pressure: 'kg/(m s²)', temperature: 'K' },
  componentNames: { velocity: ['u', 'v', 'w'] },
};
const single = smallMesh(mixedVariables());
const double: Mesh = { ...single, position: Float64Array.from(single.position, (value) => value / 3) };
/** What PLY, OBJ and GLB have places of their own for. */
const shading: Mesh = {
  ...single,
  variables: [
    { name: 'normal', components: 3, values: Float32Array.of(0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0.6, 0.8) },
    { name: 'uv', components: 2, values: Float32Array.from({ length: 8 }, (_, i) => i / 7) },
  ],
};

/** Whole numbers from 0 to 255 go to a PLY file as bytes, which is how VTK knows colours. */
const painted: Mesh = {
  ...shading,
  variables: [
    ...shading.variables,
    { name: 'color', components: 3, values: Float32Array.from({ length: 12 }, (_, i) => 23 * i) },
  ],
};

const written: [name: string, format: Format, mesh: Mesh, options: WriteOptions][] = [
  ['single.vtp', 'vtp', single, labels],
  ['double.vtp', 'vtp', double, {}],
  ['single.vtk', 'vtk', single, labels],
  ['double.vtk', 'vtk', double, {}],
  ['ascii.ply', 'ply', painted, { encoding: 'ascii' }],
  ['little-endian.ply', 'ply', painted, { encoding: 'binary_little_endian' }],
  ['big-endian.ply', 'ply', painted, { encoding: 'binary_big_endian' }],
  ['double.ply', 'ply', double, {}],
  ['shading.obj', 'obj', shading, {}],
  ['double.obj', 'obj', { ...double, variables: [] }, {}],
  ['single.stl', 'stl', single, {}],
  ['shading.glb', 'glb', shading, {}],
  ['all-variables.glb', 'glb', withinSingles(single), labels],
];

/** What whole numbers are called in NumPy is what they are called here. */
const wholeTypes: Labels['wholeTypes'] = Object.fromEntries(
  (['int8', 'uint8', 'int16', 'uint16', 'int32', 'uint32', 'int64', 'uint64'] as const).map((type) => [type, type]),
);
const whole = smallMesh(
  Object.keys(wholeTypes).map((name) => ({ name, components: 1, values: Float64Array.of(0, 127, 5, 77) })),
);
const wholeFiles: typeof written = [
  ['whole.vtp', 'vtp', whole, { wholeTypes }],
  ['whole.vtk', 'vtk', whole, { wholeTypes }],
];

/** What VTK takes for what, whatever it is called. */
const declared = smallMesh([
  { name: 'n', components: 3, values: Float32Array.of(0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0.6, 0.8) },
  { name: 'pressure', components: 1, values: Float32Array.of(1, 2, 3, 4) },
  { name: 'place', components: 2, values: Float32Array.of(0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7) },
  { name: 'number', components: 1, values: Float32Array.of(4, 3, 2, 1) },
  { name: 'name', components: 1, values: Float32Array.of(7, 8, 9, 5) },
]);
const roles: Labels['roles'] = { n: 'normal', place: 'textureCoordinates', number: 'globalIds', name: 'pedigreeIds' };
const declaredOptions = { roles, wholeTypes: { number: 'int64', name: 'int32' } } as const;
const coloured = smallMesh([
  { name: 'RGB', components: 3, values: Float32Array.from({ length: 12 }, (_, i) => 23 * i) },
]);
const declaredFiles: typeof written = [
  ['declared.vtp', 'vtp', declared, declaredOptions],
  ['declared.vtk', 'vtk', declared, declaredOptions],
  ['coloured.vtk', 'vtk', coloured, {}],
];

/** One process for all files, since VTK takes its time to start. */
async function askVtk(command: string, folder: string): Promise<VtkAnswer> {
  const [files, variants, drawn] = ['files', 'variants', 'drawn'].map((name) => join(folder, name));
  for (const path of [files, variants, drawn]) mkdirSync(path);
  for (const [name, format, mesh, options] of [...written, ...wholeFiles, ...declaredFiles]) {
    writeFileSync(join(files, name), await writeSurface(format, mesh, options));
  }
  const script = fileURLToPath(new URL('vtk_dump.py', import.meta.url));
  return JSON.parse(execFileSync(command, [script, files, variants, drawn], { encoding: 'utf8' }));
}

/** The type and the bits, as `bits` has them. */
function vtkBits({ type, bytes }: VtkArray): string {
  const typedArrays: Record<string, string> = { float32: 'Float32Array', float64: 'Float64Array' };
  return `${typedArrays[type] ?? type} ${bytes}`;
}

const rounded = (values: Variable['values']) => bits(Float32Array.from(values));

/** An array of VTK's as plain text, to compare with expectedArray. */
function arrayText({ name, components, unit, componentNames, ...values }: VtkArray): string {
  return JSON.stringify([name, components, vtkBits(values as VtkArray), unit ?? '', componentNames ?? []]);
}

function expectedArray({ name, components, values }: Variable, { units, componentNames }: WriteOptions): string {
  const labelIn = <Label>(labels: Record<string, Label> | undefined, none: Label) =>
    labels && Object.hasOwn(labels, name) ? labels[name] : none;
  return JSON.stringify([name, components, bits(values), labelIn(units, ''), labelIn(componentNames, [])]);
}

/** Nothing but the triangles of the mesh, in order. */
function expectCells(surface: VtkSurface, { triangles }: Mesh): void {
  expect(surface.corners).toEqual(Array.from(triangles));
  expect(surface.offsets).toEqual(Array.from({ length: triangles.length / 3 + 1 }, (_, index) => 3 * index));
  expect(surface.others).toEqual({});
}

/** Of each corner of each triangle its place, whatever the order of the points. */
function cornerPlaces(position: ArrayLike<number>, corners: ArrayLike<number>): number[][] {
  return Array.from(corners, (corner) => [0, 1, 2].map((axis) => position[3 * corner + axis]));
}

const folder = mkdtempSync(join(tmpdir(), 'vtk-reads-'));
afterAll(() => rmSync(folder, { recursive: true }));
const answer: VtkAnswer | undefined = python ? await askVtk(python, folder) : undefined;
const missing = answer ? undefined : 'no Python here has VTK';
const title = (what: string) => (missing ? `${what} (skipped: ${missing})` : what);
const filesOf = (ending: string) => written.filter(([name]) => name.endsWith(ending));

describe.skipIf(mustSkip(missing))(title('VTK reads what the project writes'), () => {
  const { read } = answer ?? ({} as VtkAnswer);

  it.each([...filesOf('.vtp'), ...filesOf('.vtk')])('%s: every bit, unit and name', (name, _, mesh, options) => {
    const { points, arrays } = read[name];
    expectCells(read[name], mesh);
    expect([points.components, vtkBits(points)]).toEqual([3, bits(mesh.position)]);
    expect(arrays.map(arrayText)).toEqual(mesh.variables.map((variable) => expectedArray(variable, options)));
    expect(points.unit ?? undefined).toBe(options.units?.position);
  });

  it.each(wholeFiles)('%s: whole numbers in their types', (name, _, mesh) => {
    const { arrays } = read[name];
    expect(arrays.map((array) => [array.name, array.type])).toEqual(Object.entries(wholeTypes));
    for (const [i, { type, bytes }] of arrays.entries()) {
      const digits = bytes.length / mesh.variables[i].values.length;
      const numbers = Array.from({ length: 4 }, (_, at) => bytes.slice(at * digits, (at + 1) * digits));
      expect(digits).toBe(Number(type.replace(/\D/g, '')) / 4);
      expect(numbers.map((number) => Number.parseInt(number.slice(0, 2), 16))).toEqual([0, 127, 5, 77]);
      expect(numbers.every((number) => /^..0*$/.test(number))).toBe(true);
    }
  });

  it.each(filesOf('.ply'))('%s: what its reader knows, in its single precision', (name, _, mesh) => {
    expectCells(read[name], mesh);
    expect(vtkBits(read[name].points)).toBe(rounded(mesh.position));
    const arrayOf = Object.fromEntries(read[name].arrays.map((array) => [array.name, array]));
    const variableOf = Object.fromEntries(mesh.variables.map((variable) => [variable.name, variable.values]));
    expect(vtkBits(arrayOf.Normals)).toBe(rounded(variableOf.normal));
    if (mesh !== painted) return;
    const bytes = Array.from(variableOf.color, (value) => value.toString(16).padStart(2, '0')).join('');
    expect(arrayOf.RGB).toMatchObject({ type: 'uint8', components: 3, bytes });
  });

  it.each(filesOf('.obj'))('%s: what its reader knows, in its single precision', (name, _, mesh) => {
    expectCells(read[name], mesh);
    expect(vtkBits(read[name].points)).toBe(rounded(mesh.position));
    const arrays = read[name].arrays.map((array) => [array.name, vtkBits(array)]).sort();
    const names: Record<string, string> = { normal: 'Normals', uv: 'TCoords' };
    expect(arrays).toEqual(mesh.variables.map((variable) => [names[variable.name], rounded(variable.values)]));
  });

  it.each(filesOf('.stl'))('%s: every triangle', (name, _, mesh) => {
    const { points, corners, offsets } = read[name];
    expect(points.type).toBe('float32');
    expect(offsets).toEqual(Array.from({ length: mesh.triangles.length / 3 + 1 }, (_, index) => 3 * index));
    const places = new Float32Array(Uint8Array.from(Buffer.from(points.bytes, 'hex')).buffer);
    expect(cornerPlaces(places, corners)).toEqual(cornerPlaces(mesh.position, mesh.triangles));
  });

  it.each(['declared.vtp', 'declared.vtk'])('%s: normals, texture coordinates and ids as such', (name) => {
    expect(read[name].active).toEqual({ Normals: 'n', TCoords: 'place', GlobalIds: 'number', PedigreeIds: 'name' });
    expect(read[name].arrays.map((array) => array.name).sort()).toEqual(['n', 'name', 'number', 'place', 'pressure']);
  });

  it('coloured.vtk: colours as the bytes to draw with', () => {
    expect(read['coloured.vtk'].active).toEqual({ Scalars: 'RGB' });
    expect(read['coloured.vtk'].arrays[0]).toMatchObject({ type: 'uint8', components: 3 });
  });

  it.each(filesOf('.glb'))('%s: every variable, in its single precision', (name, _, mesh) => {
    expectCells(read[name], mesh);
    expect(vtkBits(read[name].points)).toBe(rounded(mesh.position));
    const arrays = Object.fromEntries(read[name].arrays.map((array) => [array.name, vtkBits(array)]));
    const expected = mesh.variables.flatMap((variable) => gltfAttributes(variable, mesh === shading));
    expect(arrays).toEqual(Object.fromEntries(expected));
  });
});

/** What glTF calls a variable; more than four components are one attribute each. */
function gltfAttributes({ name, components, values }: Variable, unitNormals: boolean): [name: string, bits: string][] {
  const semantic = `_${name.toUpperCase().replace(/[^A-Z0-9]+/g, '_')}`;
  const known = name === 'uv' ? 'TEXCOORD_0' : name === 'normal' && unitNormals ? 'NORMAL' : semantic;
  const turned = name === 'uv' ? values.map((value: number, i: number) => (i % 2 === 1 ? 1 - value : value)) : values;
  if (components <= 4) return [[known, rounded(turned)]];
  return Array.from({ length: components }, (_, component) => [
    `${semantic}_${component}`,
    rounded(values.filter((_, index) => index % components === component)),
  ]);
}

describe.skipIf(mustSkip(missing))(title('The project reads what VTK writes'), () => {
  const { original, written: variants } = answer ?? ({ written: {} } as VtkAnswer);
  const exact = (name: string) => !/ascii/.test(name);

  it('in every way that VTK has', () => {
    const names = Object.keys(variants);
    // XML in two header sizes and two byte orders: text, and three encodings packed or not.
    // Legacy: two versions, text or not.
    expect(names).toHaveLength(2 * 2 * (1 + 3 * 2) + 2 * 2);
    for (const name of names.filter(exact)) expect(variants[name]).toEqual(original);
  });

  it.each(Object.keys(variants))('%s: every bit, unit and name', async (name) => {
    const file = new Uint8Array(readFileSync(join(folder, 'variants', name)));
    const { mesh, units, componentNames, notes } = await readSurface(name, file);
    // VTK's text is short of digits and signs of zeros, so that what counts is how VTK reads it.
    const { points, corners, arrays } = variants[name];
    expect(bits(mesh.position)).toBe(vtkBits(points));
    expect(Array.from(mesh.triangles)).toEqual(corners);
    const labels = { units, componentNames };
    expect(mesh.variables.map((variable) => expectedArray(variable, labels))).toEqual(arrays.map(arrayText));
    expect(notes).toEqual([]);
  });
});

describe.skipIf(mustSkip(missing))(title('The project reads what VTK writes for drawing'), () => {
  const { drawn } = answer ?? ({ drawn: {} } as VtkAnswer);
  const normals = [0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0.6, 0.8, 0, 0, -1];
  const colours = Array.from({ length: 15 }, (_, i) => 17 * i);
  const places = Array.from({ length: 10 }, (_, i) => i / 10);
  const expected: Record<string, Record<string, number[]>> = {
    ply: {
      color: colours,
      uv: places,
    },
    stl: {},
    obj: { normal: normals, uv: places },
    gltf: {},
  };

  it.each(Object.keys(drawn))('%s: every triangle and what VTK wrote at its corners', async (name) => {
    const file = new Uint8Array(readFileSync(join(folder, 'drawn', name)));
    const { mesh } = await readSurface(name, file);
    const { points, corners } = drawn[name];
    const there = new Float32Array(Uint8Array.from(Buffer.from(points.bytes, 'hex')).buffer);
    // Its own reader loses the signs of zeros.
    const unsigned = (values: Iterable<number> & ArrayLike<number>) => Float32Array.from(values, (value) => value + 0);
    expect(cornerPlaces(unsigned(mesh.position), mesh.triangles)).toEqual(cornerPlaces(unsigned(there), corners));
    for (const [variable, values] of Object.entries(expected[name.split('.')[1]])) {
      const found = mesh.variables.find((each) => each.name === variable);
      expect(Array.from(found?.values ?? [], Math.fround)).toEqual(values.map(Math.fround));
    }
  });
});
