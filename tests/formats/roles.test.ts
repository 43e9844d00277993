// Normals, texture coordinates, colours and ids stay what they are from every format to every other one.
import { validateBytes } from 'gltf-validator';
import { describe, expect, it, test } from 'vitest';
import type { Variable } from '../../wasm/types.ts';
import { readSurface, type SurfaceFile } from '../../web/formats/read.ts';
import type { Format, Labels } from '../../web/formats/surface.ts';
import { type Role, roleOf } from '../../web/formats/variables/roles.ts';
import { lossesOf, writeSurface } from '../../web/formats/write.ts';
import { bytesOf, smallMesh } from './sample-mesh.ts';

const unitVectors = Float32Array.of(0, 0, 1, 0, 1, 0, 1, 0, 0, 0.6, 0.8, 0);
const places = Float32Array.of(0, 0.25, 1, 0.5, 0.75, 0, 0.125, 1);
const bytes = Float32Array.of(255, 0, 9, 1, 2, 3, 77, 0, 200, 4, 5, 6);

/** How programs call them, in any of the formats. */
const spelled: [Role, Variable['values'], number, string[]][] = [
  ['normal', unitVectors, 3, ['normal', 'Normals', 'NORMALS']],
  ['textureCoordinates', places, 2, ['uv', 'TCoords', 'Texture Coordinates', 'texcoords']],
  ['colour', bytes, 3, ['color', 'Colors', 'RGB']],
];
const formats: Format[] = ['ply', 'vtp', 'vtk', 'obj', 'glb'];
const pairs = formats.flatMap((from) => formats.map((onto) => [from, onto] as const));

function variables(naming: number): Variable[] {
  return spelled.map(([, values, components, names]) => ({ name: names[naming % names.length], components, values }));
}

/** What file and variables say of each role: the values. */
function valuesByRole({ mesh, ...labels }: SurfaceFile): Partial<Record<Role, number[]>> {
  return Object.fromEntries(mesh.variables.map((each) => [roleOf(each, labels), Array.from(each.values, Math.fround)]));
}

function pointsOf({ mesh }: SurfaceFile): number[] {
  return Array.from(mesh.position, Math.fround);
}

const expected = Object.fromEntries(spelled.map(([role, values]) => [role, Array.from(values)]));

describe.each([0, 1, 2])('variables under their names number %i', (naming) => {
  const mesh = smallMesh(variables(naming));

  it.each(pairs)('keep their roles from %s to %s', async (from, onto) => {
    const first = await readSurface(`a.${from}`, await writeSurface(from, mesh));
    const second = await readSurface(`b.${onto}`, await writeSurface(onto, first.mesh, first));
    expect(pointsOf(second)).toEqual(Array.from(mesh.position));
    expect(valuesByRole(second)).toEqual(expected);
  });

  it('take the places that glTF has for them', async () => {
    const { issues } = await validateBytes(await writeSurface('glb', mesh));
    expect(issues.messages.filter(({ severity }: { severity: number }) => severity < 2)).toEqual([]);
    expect(gltfSemantics(await writeSurface('glb', mesh))).toEqual(['COLOR_0', 'NORMAL', 'POSITION', 'TEXCOORD_0']);
  });

  it('take the places that PLY, OBJ and VTK have for them', async () => {
    const text = async (format: Format) => new TextDecoder('latin1').decode(await writeSurface(format, mesh));
    const ply = await text('ply');
    for (const property of ['nx', 'ny', 'nz', 'texture_u', 'texture_v', 'red']) expect(ply).toContain(` ${property}\n`);
    expect(await text('obj')).toMatch(/^vt 0 0\.25$[\s\S]*^vn 0 0 1$/m);
    expect(await text('vtp')).toMatch(/<PointData Normals="\w+" TCoords="[\w ]+">/);
    expect(await text('vtk')).toMatch(
      /^NORMALS \w+ float$[\s\S]*^TEXTURE_COORDINATES [\w%]+ 2 float$[\s\S]*^COLOR_SCALARS \w+ 3$/m,
    );
  });

  it.each(['ply', 'vtp', 'vtk', 'glb'] as const)('keep their names in %s', async (format) => {
    const back = await readSurface(`a.${format}`, await writeSurface(format, mesh));
    expect(back.mesh.variables.map(({ name }) => name)).toEqual(mesh.variables.map(({ name }) => name));
  });
});

function gltfSemantics(file: Uint8Array): string[] {
  const size = new DataView(file.buffer, file.byteOffset).getUint32(12, true);
  const { meshes } = JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + size)));
  return Object.keys(meshes[0].primitives[0].attributes).sort();
}

describe('v, the second texture coordinate', () => {
  const uv = { name: 'uv', components: 2, values: Float64Array.of(0.1, 0.2, 1 / 3, 0.7, 0.5, 1, 1, -3.25) };

  it('falls in glTF and rises everywhere else', async () => {
    const glb = await writeSurface('glb', smallMesh([uv]));
    const size = new DataView(glb.buffer).getUint32(12, true);
    const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + size)));
    const view = json.bufferViews[json.accessors[json.meshes[0].primitives[0].attributes.TEXCOORD_0].bufferView];
    const accessor = json.accessors[json.meshes[0].primitives[0].attributes.TEXCOORD_0];
    const at = 28 + size + (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    const stride = view.byteStride ?? 8;
    const v = [0, 1, 2, 3].map((point) => new DataView(glb.buffer).getFloat32(at + point * stride + 4, true));
    expect(v).toEqual([0.8, 0.3, 0, 4.25].map(Math.fround));
    expect(new TextDecoder().decode(await writeSurface('obj', smallMesh([uv])))).toContain('\nvt 0.1 0.2\n');
  });

  it('comes back from glTF bit for bit, through any other format', async () => {
    const first = await writeSurface('glb', smallMesh([uv]));
    for (const format of ['ply', 'vtp', 'vtk', 'obj'] as const) {
      const read = await readSurface('a.glb', first);
      const between = await readSurface(`b.${format}`, await writeSurface(format, read.mesh, read));
      const again = await readSurface('c.glb', await writeSurface('glb', between.mesh, between));
      expect(again.mesh.variables[0].values).toEqual(read.mesh.variables[0].values);
    }
  });

  it('has its rounding said, single precision or not', async () => {
    const single = { ...uv, values: Float32Array.from(uv.values) };
    for (const each of [uv, single]) {
      expect(await lossesOf('glb', smallMesh([each]))).toEqual([
        expect.stringMatching(/rounded: “uv” \(by up to \d\.\de-8\)/),
      ]);
    }
    const eighths = { ...uv, values: Float32Array.of(0, 0.125, 0.5, 1, 1, 0.25, 0, 0) };
    expect(await lossesOf('glb', smallMesh([eighths]))).toEqual([]);
  });

  it('is turned round in further texture coordinates, too', async () => {
    const second = { ...uv, name: 'uv_1', values: Float32Array.of(0, 0, 0, 0.25, 1, 1, 1, 0.5) };
    const file = await writeSurface('glb', smallMesh([{ ...uv, values: Float32Array.from(uv.values) }, second]));
    expect(gltfSemantics(file)).toEqual(['POSITION', 'TEXCOORD_0', 'TEXCOORD_1']);
    const { mesh } = await readSurface('a.glb', file);
    expect(mesh.variables[1]).toMatchObject({ name: 'uv_1', values: second.values });
  });
});

describe('what a file declares', () => {
  const shape = { name: 'a', components: 3, values: unitVectors };
  const coordinates = { name: 'b', components: 2, values: places };
  const ids = { name: 'c', components: 1, values: Float32Array.of(7, 3, 5, 1) };
  const roles: Labels['roles'] = { a: 'normal', b: 'textureCoordinates', c: 'globalIds' };
  const mesh = smallMesh([shape, coordinates, ids]);

  it.each(['vtp', 'vtk'] as const)('goes through %s, whatever the arrays are called', async (format) => {
    const back = await readSurface(
      `a.${format}`,
      await writeSurface(format, mesh, { roles, wholeTypes: { c: 'int64' } }),
    );
    expect({ ...back.roles }).toEqual(roles);
    expect({ ...back.wholeTypes }).toEqual({ c: 'int64' });
    expect(back.mesh.variables.map(({ kind }) => kind)).toEqual([undefined, undefined, 'identifier']);
  });

  it.each(pairs)('goes from %s to %s under names that tell nothing', async (from, onto) => {
    const colour = { name: 'd', components: 3, values: bytes };
    const all = smallMesh([shape, coordinates, colour]);
    const declared = { ...roles, d: 'colour' } as const;
    const first = await readSurface(`a.${from}`, await writeSurface(from, all, { roles: declared }));
    const second = await readSurface(`b.${onto}`, await writeSurface(onto, first.mesh, first));
    expect(valuesByRole(second)).toEqual(expected);
  });

  it('counts before what another variable is called', async () => {
    const named = { name: 'normal', components: 3, values: Float32Array.from(unitVectors, (value) => -value) };
    const both = smallMesh([named, shape]);
    const obj = new TextDecoder().decode(await writeSurface('obj', both, { roles }));
    expect(obj).toContain('\nvn 0 0 1\n');
    expect(await lossesOf('obj', both, { roles })).toEqual(['OBJ has no place for the variables “normal”.']);
  });

  it.each(['GlobalIds', 'PedigreeIds'])('as %s identifies in VTP', async (attribute) => {
    const text = new TextDecoder('latin1').decode(await writeSurface('vtp', smallMesh([ids])));
    const file = Uint8Array.from(text.replace('<PointData>', `<PointData ${attribute}="c">`), (letter) =>
      letter.charCodeAt(0),
    );
    const { mesh: read, notes } = await readSurface('a.vtp', file);
    expect(read.variables[0].kind).toBe('identifier');
    expect(notes.join(' ')).toContain('Taken for identifiers, which “*” does not bound: “c”');
  });

  it('that does not fit the array counts for nothing', async () => {
    expect(roleOf({ name: 'a', components: 2 }, { roles })).toBeUndefined();
    expect(roleOf({ name: 'uv', components: 3 })).toBeUndefined();
  });
});

describe('PLY', () => {
  const file = (...properties: string[]) =>
    bytesOf(
      [
        'ply',
        'format ascii 1.0',
        'element vertex 3',
        ...['x', 'y', 'z', ...properties].map((name) => `property float ${name}`),
      ]
        .concat('element face 1', 'property list uchar int vertex_indices', 'end_header')
        .concat(['0 0 0', '1 0 0', '0 1 0'].map((row, i) => [row, ...properties.map((_, j) => i + j / 8)].join(' ')))
        .concat('3 0 1 2', '')
        .join('\n'),
    );

  test.each([
    [['texture_u', 'texture_v'], ['uv'], false],
    [['s', 't'], ['uv'], true],
    [['u', 'v'], ['uv'], true],
    // Not a picture's places but a velocity, or something with a letter for a name.
    [['u', 'v', 'w'], ['u', 'v', 'w'], false],
    [['s'], ['s'], false],
  ])('%j are %j', async (properties, names, isSaid) => {
    const { mesh, summary } = await readSurface('a.ply', file(...properties));
    expect(mesh.variables.map(({ name }) => name)).toEqual(names);
    expect(summary.includes('Taken for texture coordinates')).toBe(isSaid);
  });

  it('gives scalars named s and t back as these', async () => {
    const scalar = (name: string) => ({ name, components: 1, values: Float32Array.of(1, 2, 3, 4) });
    const back = await readSurface('a.ply', await writeSurface('ply', smallMesh([scalar('s'), scalar('t')])));
    expect(back.mesh.variables.map(({ name }) => name)).toEqual(['s', 't']);
    expect(back.summary).toBe('');
  });
});

test('what glTF does not allow as a normal or a colour is said to be no more than numbers', async () => {
  const long = { name: 'Normals', components: 3, values: unitVectors.map((value) => 2 * value) };
  const bright = { name: 'RGB', components: 3, values: Float32Array.of(0, 2.5, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0) };
  const file = await writeSurface('glb', smallMesh([long, bright]));
  expect(gltfSemantics(file)).toEqual(['POSITION', '_NORMALS', '_RGB']);
  expect(await lossesOf('glb', smallMesh([long, bright]))).toEqual([
    'GLB takes unit vectors for normals, and bytes or fractions for colours; just numbers in it: “Normals”, “RGB”.',
  ]);
});

test('a variable that may not be called “position” keeps its type and its role under another name', async () => {
  const position = { name: 'position', components: 1, values: Float32Array.of(1, 2, 3, 9) };
  const options: Partial<Labels> = { wholeTypes: { position: 'int16' }, roles: { position: 'globalIds' } };
  const back = await readSurface('a.vtp', await writeSurface('vtp', smallMesh([position]), options));
  expect(back.mesh.variables[0].name).toBe('position_2');
  expect({ ...back.wholeTypes }).toEqual({ position_2: 'int16' });
  expect({ ...back.roles }).toEqual({ position_2: 'globalIds' });
});
