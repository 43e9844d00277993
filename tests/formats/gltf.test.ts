import { validateBytes } from 'gltf-validator';
import { describe, expect, it } from 'vitest';
import type { Mesh } from '../../wasm/types.ts';
import type { FormatFault } from '../../web/formats/format-error.ts';
import { readSurface } from '../../web/formats/read.ts';
import { lossesOf, writeSurface } from '../../web/formats/write.ts';
import { expectFault } from './faults.ts';
import { accessorsOf, type GltfArray, glbFile } from './gltf-file.ts';
import { fingerprint, mixedVariables, smallMesh } from './sample-mesh.ts';

const square: GltfArray = { components: 3, values: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0) };
const corners: GltfArray = { components: 1, values: Uint16Array.of(0, 1, 2, 0, 2, 3) };

/** A GLB file of one mesh; attributes and indices are accessors by their number. */
function scene(arrays: GltfArray[], primitives: object[], more: object = {}): Uint8Array {
  const { json, binary } = accessorsOf(arrays);
  const nodes = { nodes: [{ mesh: 0 }], scenes: [{ nodes: [0] }] };
  return glbFile({ ...json, meshes: [{ primitives }], ...nodes, ...more }, binary);
}

const squareFile = accessorsOf([square, corners]);

/** A glTF file in text of one square; its first buffer has its points and corners. */
function textScene(...uris: string[]): Uint8Array {
  const { json, binary } = squareFile;
  const meshes = [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }];
  const buffers = uris.map((uri) => ({ byteLength: binary.length, uri }));
  return new TextEncoder().encode(JSON.stringify({ asset: { version: '2.0' }, buffers, ...json, meshes }));
}

function dataUri(): string {
  return `data:application/octet-stream;base64,${btoa(String.fromCharCode(...squareFile.binary))}`;
}

const read = (bytes: Uint8Array) => readSurface('scene.glb', bytes);
const variablesOf = (mesh: Mesh) => mesh.variables.map(({ name, values }) => `${name} ${Array.from(values).join(' ')}`);

describe('GLB by the project', () => {
  const singles = mixedVariables().filter(({ values }) => values instanceof Float32Array);
  const unit = { name: 'normal', components: 3, values: Float32Array.of(0, 0, 1, 0, 1, 0, 1, 0, 0, 0.6, 0.8, 0) };
  const color = { name: 'color', components: 3, values: Float32Array.from({ length: 12 }, (_, i) => i / 11) };
  const many = { name: 'stress', components: 6, values: Float32Array.from({ length: 24 }, (_, i) => i) };

  it('gives single precision, names, units and component names back', async () => {
    const mesh = smallMesh([...singles.filter(({ name }) => name !== 'color'), unit, color, many]);
    const labels = {
      units: { position: 'mm', stress: 'Pa', 'Mach number': '1' },
      componentNames: { position: ['x', 'r', 'θ'], velocity: ['u', 'v', 'w'] },
    };
    const back = await read(await writeSurface('glb', mesh, labels));
    expect(fingerprint(back.mesh)).toEqual(fingerprint(mesh));
    expect({ ...back.units }).toEqual(labels.units);
    expect({ ...back.componentNames }).toEqual(labels.componentNames);
    expect(back.summary).toBe('');
  });

  it('passes the validator of the Khronos Group', async () => {
    for (const variables of [[], singles, [unit, color, many]]) {
      const { issues } = await validateBytes(await writeSurface('glb', smallMesh(variables)));
      expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
    }
  });

  it.each([
    ['NaN', Number.NaN, 'not finite'],
    ['infinity', Number.NEGATIVE_INFINITY, 'not finite'],
    ['a double beyond single precision', 1e300, 'beyond single precision'],
  ])('cannot hold %s, and says so', async (_, value, reason) => {
    const p = { name: 'p', components: 1, values: Float64Array.of(0, 1, 2, value) };
    const place = { ...smallMesh([]), position: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, value) };
    const writing = [writeSurface('glb', smallMesh([p])), writeSurface('stl', place)];
    const message = expect.stringContaining(reason);
    await expect(writing[0]).rejects.toMatchObject({ code: 'not_finite', where: 'p', message });
    await expect(writing[1]).rejects.toMatchObject({ code: 'not_finite', where: 'position', message });
    // It does not stand in the way of what has no place anyway.
    expect(await writeSurface('stl', smallMesh([p]))).toBeInstanceOf(Uint8Array);
  });

  it('says that doubles are rounded', async () => {
    expect(await lossesOf('glb', smallMesh(mixedVariables()))).toEqual([
      'GLB takes unit vectors for normals, and bytes or fractions for colours; just numbers in it: “normal”, “color”.',
      expect.stringMatching(/rounded: “temperature” \(.*\), “normal” \(by up to .*\), “stress” \(by up to .*\)\./),
    ]);
    const { mesh } = await read(
      await writeSurface('glb', smallMesh([{ name: 'p', components: 1, values: Float64Array.of(0.1, 1, 2, 3) }])),
    );
    expect(mesh.variables[0].values[0]).toBe(Math.fround(0.1));
  });
});

describe('glTF attributes', () => {
  it('are read normalised, quantised, under their names', async () => {
    const arrays: GltfArray[] = [
      { components: 3, values: Int16Array.of(0, 0, 0, 0, 100, 0, 0, 0, 100, 100, 0, 0, 0, 100, 0, 0) },
      {
        components: 4,
        values: Uint8Array.of(0, 51, 255, 255, 0, 0, 0, 0, 255, 255, 255, 255, 1, 2, 3, 4),
        normalized: true,
      },
      { components: 1, values: Float32Array.of(1, 2, 3, 4) },
      { components: 2, values: Uint16Array.of(0, 65535, 0, 0, 0, 0, 0, 0), normalized: true },
      corners,
    ];
    const { json, binary } = accessorsOf(arrays);
    Object.assign(json.bufferViews[0], { byteStride: 8 });
    Object.assign(json.accessors[0], { count: 4 });
    const attributes = { POSITION: 0, COLOR_0: 1, _TEMPERATURE: 2, TEXCOORD_0: 3, TANGENT: 1 };
    const meshes = [{ primitives: [{ attributes, indices: 4 }] }];
    const more = { extensionsUsed: ['KHR_mesh_quantization'], extensionsRequired: ['KHR_mesh_quantization'] };
    const { mesh, notes } = await read(
      glbFile({ ...json, meshes, nodes: [{ mesh: 0 }], scenes: [{ nodes: [0] }], ...more }, binary),
    );
    expect(mesh.position).toEqual(Float32Array.of(0, 0, 0, 100, 0, 0, 100, 100, 0, 0, 100, 0));
    expect(variablesOf(mesh).slice(1)).toEqual(['TEMPERATURE 1 2 3 4', 'uv 0 0 0 1 0 1 0 1']);
    expect(mesh.variables[0]).toMatchObject({ name: 'color', components: 4 });
    expect(mesh.variables[0].values.subarray(0, 4)).toEqual(Float32Array.of(0, 51, 255, 255));
    expect(notes).toEqual(['Not carried: the attributes “TANGENT”.']);
  });

  it('are read where they lie between each other', async () => {
    const rows = Array.from({ length: 4 }, (_, point) => [
      ...square.values.subarray(3 * point, 3 * point + 3),
      point / 2,
    ]);
    const interleaved = { components: 4, values: Float32Array.from(rows.flat()) };
    const { json, binary } = accessorsOf([interleaved, corners]);
    Object.assign(json.bufferViews[0], { byteStride: 16 });
    const element = { bufferView: 0, componentType: 5126, count: 4 };
    const accessors = [{ ...element, type: 'VEC3' }, json.accessors[1], { ...element, type: 'SCALAR', byteOffset: 12 }];
    const meshes = [{ primitives: [{ attributes: { POSITION: 0, _P: 2 }, indices: 1 }] }];
    const { mesh } = await read(glbFile({ ...json, accessors, meshes }, binary));
    expect(mesh.position).toEqual(square.values);
    expect(variablesOf(mesh)).toEqual(['P 0 0.5 1 1.5']);
  });

  it('are read from sparse accessors', async () => {
    const arrays = [
      square,
      corners,
      { components: 1, values: Uint16Array.of(1, 3) },
      { components: 1, values: Float32Array.of(5, 7) },
    ];
    const { json, binary } = accessorsOf(arrays);
    const sparse = { count: 2, indices: { bufferView: 2, componentType: 5123 }, values: { bufferView: 3 } };
    const accessors = [...json.accessors, { componentType: 5126, count: 4, type: 'SCALAR', sparse }];
    const meshes = [{ primitives: [{ attributes: { POSITION: 0, _P: 4 }, indices: 1 }] }];
    const { mesh } = await read(
      glbFile({ ...json, accessors, meshes, nodes: [{ mesh: 0 }], scenes: [{ nodes: [0] }] }, binary),
    );
    expect(variablesOf(mesh)).toEqual(['P 0 5 0 7']);
  });

  it('may be named like what JavaScript has already, and are not carried without a name', async () => {
    const p = { components: 1, values: Float32Array.of(1, 2, 3, 4) };
    // As text, since an object would not keep the name.
    const attributes = JSON.parse('{ "POSITION": 0, "__proto__": 2, "_constructor": 2, "toString": 2, "_": 2, "": 2 }');
    const { mesh, summary } = await read(scene([square, corners, p], [{ attributes, indices: 1 }]));
    expect(variablesOf(mesh)).toEqual(['_proto__ 1 2 3 4', 'constructor 1 2 3 4']);
    expect(summary).toContain('Not carried: the attributes “toString”, “_”, “”.');
  });

  it('that not all primitives have are left out by name', async () => {
    const other = { ...square, values: square.values.map((v) => v + 5) as Float32Array };
    const p = { components: 1, values: Float32Array.of(1, 2, 3, 4) };
    const arrays = [square, other, p, corners];
    const primitives = [
      { attributes: { POSITION: 0, _P: 2, _Q: 2 }, indices: 3 },
      { attributes: { POSITION: 1, _P: 2 }, indices: 3 },
    ];
    const { mesh, summary } = await read(scene(arrays, primitives));
    expect(variablesOf(mesh)).toEqual(['P 1 2 3 4 1 2 3 4']);
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7]);
    expect(summary).toContain('not every primitive has them: “Q”');
  });
});

describe('a glTF scene', () => {
  const placedBy = async (...nodes: object[]) =>
    (await read(scene([square, corners], [{ attributes: { POSITION: 0 }, indices: 1 }], { nodes }))).mesh;

  it('is put together where its nodes put it', async () => {
    const mesh = await placedBy(
      { mesh: 0, translation: [0, 0, 1], children: [1] },
      { mesh: 0, scale: [2, 2, 2], translation: [10, 0, 0] },
    );
    expect(mesh.position).toEqual(
      Float32Array.of(0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 10, 0, 1, 12, 0, 1, 12, 2, 1, 10, 2, 1),
    );
  });

  it('keeps outside outside where a node reflects', async () => {
    const mesh = await placedBy({ mesh: 0, scale: [-1, 1, 1] });
    expect(Array.from(mesh.triangles)).toEqual([2, 1, 0, 3, 2, 0]);
    const normals = { components: 3, values: Float32Array.of(1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0) };
    const primitive = { attributes: { POSITION: 0, NORMAL: 2 }, indices: 1 };
    const turned = await read(
      scene([square, corners, normals], [primitive], { nodes: [{ mesh: 0, scale: [-1, 2, 1] }] }),
    );
    expect(Array.from(turned.mesh.variables[0].values.subarray(0, 3), (part) => part + 0)).toEqual([-1, 0, 0]);
  });

  it('is read in strips, fans and without indices; points, lines and odd corners are named as lost', async () => {
    const trianglesOf = async (mode: number, indices?: number) =>
      Array.from(
        (await read(scene([square, corners], [{ attributes: { POSITION: 0 }, mode, indices }]))).mesh.triangles,
      );
    expect(await trianglesOf(4)).toEqual([0, 1, 2]);
    expect(await trianglesOf(5)).toEqual([0, 1, 2, 1, 3, 2]);
    expect(await trianglesOf(6)).toEqual([0, 1, 2, 0, 2, 3]);
    const lines = scene(
      [square, corners],
      [
        { attributes: { POSITION: 0 }, indices: 1 },
        { attributes: { POSITION: 0 }, mode: 1 },
      ],
    );
    expect((await read(lines)).notes).toEqual(['Not carried: 1 primitive of points or lines.']);
    const odd = { ...corners, values: Uint16Array.of(0, 1, 2, 0, 2) };
    const { notes, mesh } = await read(scene([square, odd], [{ attributes: { POSITION: 0 }, indices: 1 }]));
    expect(notes).toEqual(['Not carried: 2 corners after the last whole triangle.']);
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2]);
  });

  it('of glTF text with buffers inside is read', async () => {
    const { mesh, format } = await readSurface('scene.gltf', textScene(dataUri()));
    expect(format).toBe('glb');
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3]);
  });

  it('of glTF text with a buffer beside it is read, the same file once', async () => {
    const asked: string[] = [];
    const beside = async (path: string) => {
      asked.push(path);
      return squareFile.binary;
    };
    const { mesh } = await readSurface('scene.gltf', textScene('data/my%20scene.bin', 'data/my%20scene.bin'), beside);
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3]);
    expect(asked).toEqual(['data/my scene.bin']);
  });

  it('is read past damaged, huge and missing data that it does not need', async () => {
    const { json, binary } = squareFile;
    const file = {
      asset: { version: '2.0' },
      buffers: [
        { byteLength: binary.length, uri: dataUri() },
        { byteLength: 9, uri: 'walk.bin' },
        { uri: 'https://a.b/c' },
      ],
      bufferViews: [...json.bufferViews, { buffer: 1, byteOffset: 99, byteLength: 9 }, { buffer: 7 }],
      accessors: [
        ...json.accessors,
        { bufferView: 2, componentType: 5126, count: 4, type: 'VEC3' },
        { componentType: 5126, count: 2 ** 31, type: 'VEC4' },
        {},
      ],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
      animations: [{ channels: [], samplers: [{ input: 2, output: 3 }] }],
      images: [{ bufferView: 3 }],
    };
    const { mesh, summary } = await read(new TextEncoder().encode(JSON.stringify(file)));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3]);
    expect(summary).toContain('Not carried: animations');
  });

  it.each([
    ['KHR_draco_mesh_compression', 'primitives'],
    ['EXT_meshopt_compression', 'bufferViews'],
    ['KHR_meshopt_compression', 'bufferViews'],
    ['EXT_meshopt_compression', 'buffers'],
    ['KHR_draco_mesh_compression', 'extensionsRequired'],
    ['KHR_draco_mesh_compression', 'extensionsUsed'],
  ])('compressed by %s, as %s say, is refused by that name before anything else', async (name, place) => {
    const item = { extensions: { [name]: {} } };
    const list = place.startsWith('extensions') ? { [place]: [name] } : { [place]: [item] };
    const mesh = { primitives: [{ ...(place === 'primitives' ? item : {}), attributes: { POSITION: 1 }, indices: 9 }] };
    // Nothing of this file is right, but for its being JSON.
    const broken = { asset: {}, ...list, meshes: [mesh], accessors: [{}, {}, 7], nodes: 'none' };
    await expectFault(JSON.stringify(broken), 'unsupported_feature', `“${name}”`, 'uncompressed');
    await expectFault(glbFile(broken, new Uint8Array(4)), 'unsupported_feature', `“${name}”`);
  });

  it('that only lists a compression which nothing has is read, and so are compressed textures and whole numbers', async () => {
    const extensionsUsed = ['KHR_draco_mesh_compression', 'KHR_mesh_quantization', 'KHR_texture_basisu'];
    const whole: GltfArray = { components: 3, values: Int16Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0) };
    const primitive = { attributes: { POSITION: 0 }, indices: 1 };
    const file = scene([whole, corners], [primitive], {
      extensionsUsed,
      extensionsRequired: ['KHR_mesh_quantization'],
    });
    const { mesh, summary } = await read(file);
    expect(Array.from(mesh.position)).toEqual([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
    expect(summary).toContain('Extensions passed over: “KHR_draco_mesh_compression”, “KHR_texture_basisu”.');
  });

  it('welds what was repeated for drawing', async () => {
    const torn = { components: 3, values: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1) };
    const normals = { components: 3, values: Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1, 0) };
    const { mesh, notes } = await read(scene([torn, normals], [{ attributes: { POSITION: 0, NORMAL: 1 } }]));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3]);
    expect(notes).toEqual([expect.stringContaining('creases'), '2 repeated points welded.']);
  });

  it('names materials, animations and extensions as lost', async () => {
    const more = {
      materials: [{}],
      cameras: [{}],
      images: [{ uri: 'http://example.org/a.png' }],
      textures: [{ source: 0 }],
      extensionsUsed: ['KHR_lights_punctual'],
    };
    const { notes } = await read(
      scene([square, corners], [{ attributes: { POSITION: 0 }, indices: 1, material: 0, targets: [{}] }], more),
    );
    expect(notes).toEqual([
      'Not carried: materials, textures, cameras, morph targets.',
      'Extensions passed over: “KHR_lights_punctual”.',
    ]);
  });
});

describe('a hostile glTF file', () => {
  const good = { attributes: { POSITION: 0 }, indices: 1 };
  const withAccessor = (change: object) => {
    const { json, binary } = accessorsOf([square, corners]);
    const accessors = [{ ...json.accessors[0], ...change }, json.accessors[1]];
    return glbFile({ ...json, accessors, meshes: [{ primitives: [good] }] }, binary);
  };
  const cycle = { nodes: [{ mesh: 0, children: [1] }, { children: [0] }], scenes: [{ nodes: [0] }] };
  const large = { components: 3, values: new Float32Array(30_000) };
  const repeated = scene([large, corners], [good], {
    nodes: Array(1000).fill({ mesh: 0 }),
    scenes: [{ nodes: [...Array(1000).keys()] }],
  });
  const unused = { componentType: 5126, count: 2 ** 31, type: 'VEC4' };
  const huge = { accessors: [...accessorsOf([square, corners]).json.accessors, ...Array(1000).fill(unused)] };
  const greedy = {
    ...good,
    attributes: { POSITION: 0, ...Object.fromEntries(Array.from({ length: 1000 }, (_, i) => [`_A${i}`, 2 + i])) },
  };
  const withIndices = (indices: GltfArray) => scene([square, indices], [good]);
  const withView = (change: object) => {
    const { json, binary } = accessorsOf([square, corners]);
    const bufferViews = [{ ...json.bufferViews[0], ...change }, json.bufferViews[1]];
    return glbFile({ ...json, bufferViews, meshes: [{ primitives: [good] }] }, binary);
  };
  const withSparse = (places: GltfArray, change: object = {}) => {
    const { json, binary } = accessorsOf([square, corners, places, { components: 1, values: Float32Array.of(5, 7) }]);
    const { bufferView, componentType } = json.accessors[2];
    const sparse = { count: 2, indices: { bufferView, componentType, ...change }, values: { bufferView: 3 } };
    const accessors = [...json.accessors, { componentType: 5126, count: 4, type: 'SCALAR', sparse }];
    const meshes = [{ primitives: [{ attributes: { POSITION: 0, _P: 4 }, indices: 1 }] }];
    return glbFile({ ...json, accessors, meshes }, binary);
  };

  it.each<[string, Uint8Array, FormatFault, ...string[]]>([
    [
      'of version 1',
      scene([square, corners], [good], { asset: { version: '1.0' } }),
      'unsupported_feature',
      'version 2',
    ],
    [
      'compressed',
      scene([square, corners], [good], { extensionsRequired: ['KHR_draco_mesh_compression'] }),
      'unsupported_feature',
      'draco',
    ],
    [
      'that refers to others',
      scene([square, corners], [good], { buffers: [{ byteLength: 4, uri: 'scene.bin' }] }),
      'unsupported_feature',
      '“scene.bin”',
    ],
    ['with nodes in a circle', scene([square, corners], [good], cycle), 'bad_header', 'Node'],
    ['with a missing node', scene([square, corners], [good], { nodes: [{ children: [7] }] }), 'bad_header', 'Node 7'],
    ['with accessors for all memory', scene([square, corners], [greedy], huge), 'too_large', 'accessors'],
    ['with a mesh shown too often', repeated, 'too_large', 'nodes'],
    [
      'with 2^32 − 1 elements',
      withAccessor({ count: 2 ** 32 - 1 }),
      'truncated',
      'accessor 0',
      '4 294 967 295 elements',
    ],
    ['with a negative count', withAccessor({ count: -1 }), 'bad_header', 'accessor 0'],
    ['with an offset beyond the buffer', withAccessor({ byteOffset: 4 }), 'truncated', 'accessor 0'],
    ['with an unknown type', withAccessor({ componentType: 5130 }), 'bad_header', 'accessor 0'],
    ['with flat points', withAccessor({ type: 'VEC2' }), 'no_points', 'POSITION'],
    [
      'with an index beyond the points',
      scene([square, { ...corners, values: Uint16Array.of(0, 1, 4) }], [good]),
      'bad_index',
      'point 4',
    ],
    [
      'with fractions for indices',
      withIndices({ ...corners, values: Float32Array.of(0, 1.5, 2) }),
      'bad_header',
      'mesh 0 has indices that are no list of whole numbers',
    ],
    [
      'with negative indices',
      withIndices({ ...corners, values: Int16Array.of(0, -1, 2) }),
      'bad_header',
      'mesh 0 has indices',
    ],
    ['with vectors for indices', withIndices({ ...corners, components: 3 }), 'bad_header', 'mesh 0 has indices'],
    ['with elements that overlap', withView({ byteStride: 4 }), 'bad_header', 'accessor 0', '12 bytes', 'every 4'],
    [
      'with points that only an extension has',
      withAccessor({ bufferView: undefined }),
      'unsupported_feature',
      'points of mesh 0',
    ],
    [
      'with a sparse index beyond the elements',
      withSparse({ components: 1, values: Uint16Array.of(1, 4) }),
      'bad_index',
      'sparse part of accessor 4 names element 4',
    ],
    [
      'with fractions for sparse indices',
      withSparse({ components: 1, values: Float32Array.of(1, 2) }),
      'bad_index',
      'sparse part of accessor 4',
    ],
    [
      'with sparse indices nowhere',
      withSparse({ components: 1, values: Uint8Array.of(1, 2) }, { bufferView: undefined }),
      'bad_index',
      'sparse part of accessor 4',
    ],
    ['without triangles', scene([square, corners], []), 'no_triangles', 'no triangles'],
    [
      'of unequal attributes',
      scene([square, corners], [{ attributes: { POSITION: 0, _P: 1 }, indices: 1 }]),
      'count_mismatch',
      '“_P”',
      '6 elements',
    ],
    [
      'with arrays where objects belong',
      scene([square, corners], [good], { meshes: 'none', nodes: 7 }),
      'bad_header',
      'meshes should be a list',
    ],
    ['with nothing for a mesh', scene([square, corners], [good], { meshes: [null] }), 'bad_header', 'meshes'],
    [
      'with nothing for an accessor',
      scene([square, corners], [good], { accessors: [null] }),
      'bad_header',
      'accessors',
    ],
    ['with a missing accessor', scene([square, corners], [{ ...good, indices: 9 }]), 'bad_header', 'accessor “9”'],
    ['with a missing mesh', scene([square, corners], [good], { nodes: [{ mesh: 3 }] }), 'bad_header', 'mesh “3”'],
    ['with a missing scene', scene([square, corners], [good], { scene: 2 }), 'bad_header', 'scene “2”'],
    [
      'with two attributes of one name',
      scene([square, corners, square], [{ attributes: { POSITION: 0, NORMAL: 2, _normal: 2 }, indices: 1 }]),
      'duplicate_name',
      '“normal”',
    ],
    [
      'with a name that is not UTF-8',
      scene([square, corners], [{ attributes: { POSITION: 0, '_@': 0 }, indices: 1 }]).map((byte) =>
        byte === 64 ? 0xe4 : byte,
      ),
      'bad_encoding',
      'not UTF-8',
    ],
    ['with half a matrix', scene([square, corners], [good], { nodes: [{ matrix: [1] }] }), 'bad_header', '16 numbers'],
    [
      'with words for a scale',
      scene([square, corners], [good], { nodes: [{ scale: 'large' }] }),
      'bad_header',
      'scale',
    ],
    ['with numbers for extensions', scene([square, corners], [good], { extensionsUsed: [1] }), 'bad_header', 'names'],
    ['with a number for a URI', scene([square, corners], [good], { buffers: [{ uri: 1 }] }), 'bad_header', 'buffer 0'],
    [
      'with a second buffer that is nowhere',
      scene([square, corners], [good], {
        buffers: [{ byteLength: 60 }, { byteLength: 60 }],
        bufferViews: squareFile.json.bufferViews.map((view, i) => ({ ...view, buffer: i })),
      }),
      'truncated',
      'Buffer 1',
      'has 0',
    ],
    ['with garbage for base64', textScene(dataUri().replace(/.{8}$/, '!!!!!!!!')), 'corrupt', 'buffer 0'],
    ['with too little base64', textScene(dataUri().slice(0, -8)), 'truncated', 'buffer 0'],
    ['with data that is not base64', textScene('data:,hello'), 'unsupported_feature', 'buffer 0'],
  ])('%s is refused', async (_, file, code, ...words) => {
    await expectFault(file, code, ...words);
  });

  it.each([
    '../a.bin',
    'a/../../b.bin',
    '/etc/passwd',
    'C:\\a.bin',
    '..\\a.bin',
    'file:///a.bin',
    'https://a.b/c',
    '%',
    '%00',
  ])('that refers to %s gets no file, even where there are files beside it', async (uri) => {
    const reading = readSurface('scene.gltf', textScene(uri), () => expect.fail('asked for the file'));
    await expect(reading).rejects.toMatchObject({ code: 'unsupported_feature' });
  });

  it('with too short a file beside it is refused', async () => {
    const reading = readSurface('scene.gltf', textScene('a.bin'), async () => squareFile.binary.subarray(1));
    await expect(reading).rejects.toMatchObject({ code: 'truncated', where: 'buffer 0' });
  });

  it('of broken JSON is refused', async () => {
    await expectFault('{"asset":', 'truncated', 'JSON');
    await expectFault('{"asset":}', 'bad_header', 'JSON');
    await expectFault('{"asset":null}', 'unsupported_feature', 'version 2');
  });
});
