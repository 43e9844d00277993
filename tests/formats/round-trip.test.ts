import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Mesh, Variable } from '../../wasm/types.ts';
import { readSurface } from '../../web/formats/read.ts';
import type { Format, WriteOptions } from '../../web/formats/surface.ts';
import { reservedNames } from '../../web/formats/variables/reserved-names.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { fingerprint, mixedVariables, smallMesh } from './sample-mesh.ts';

const ways: [label: string, format: Format, options: WriteOptions][] = [
  ['PLY, ASCII', 'ply', { encoding: 'ascii' }],
  ['PLY, little endian', 'ply', { encoding: 'binary_little_endian' }],
  ['PLY, big endian', 'ply', { encoding: 'binary_big_endian' }],
  ['VTP', 'vtp', {}],
  ['legacy VTK', 'vtk', {}],
];

/** Names that every format can hold: XML has no control characters and no halves of surrogate pairs. */
const names = fc
  .string({ unit: 'grapheme', minLength: 1, maxLength: 8 })
  .filter((name) => !/\p{Cc}|[\u{FFFE}\u{FFFF}]/u.test(name))
  // Names that no variable of a mesh can have are read as others.
  .filter((name) => !reservedNames.includes(name));
const usualNames = fc.constantFrom(
  'a',
  'a_x',
  'a_y',
  'a_z',
  'a_0',
  'a_1',
  'normal',
  'color',
  'nx',
  'ny',
  'nz',
  'red',
  'x',
  'y',
);

const meshes: fc.Arbitrary<Mesh> = fc.integer({ min: 3, max: 6 }).chain((points) => {
  const values = (components: number) => {
    const size = { minLength: points * components, maxLength: points * components };
    return fc.oneof(fc.float32Array(size), fc.float64Array(size));
  };
  const variable = (name: string) =>
    fc
      .integer({ min: 1, max: 4 })
      .chain((components) => values(components).map((made): Variable => ({ name, components, values: made })));
  const corner = fc.nat(points - 1);
  return fc.record({
    position: values(3),
    triangles: fc
      .array(fc.tuple(corner, corner, corner), { minLength: 1, maxLength: 4 })
      .map((list) => Uint32Array.from(list.flat())),
    variables: fc
      .uniqueArray(fc.oneof(names, usualNames), { maxLength: 5 })
      .chain((list) => fc.tuple(...list.map(variable))),
  });
});

describe.each(ways)('%s', (_, format, options) => {
  it('gives a mesh back bit for bit', async () => {
    const mesh = smallMesh(mixedVariables());
    const back = await readSurface(`mesh.${format}`, await writeSurface(format, mesh, options));
    expect(fingerprint(back.mesh)).toEqual(fingerprint(mesh));
    expect(back.format).toBe(format);
    expect(back.summary).toBe('');
  });

  it('gives units and component names back', async () => {
    const units = Object.fromEntries([
      ['position', 'm'],
      ['Mach number', '1'],
      ['__proto__', 's'],
      ['pressure', 'kg/(m s²)'],
      ['Größe <&">', '"µm" & <more>'],
    ]);
    const labels = {
      units,
      componentNames: { velocity: ['u', 'v', 'w'] },
    };
    const mesh = smallMesh(mixedVariables());
    const back = await readSurface('', await writeSurface(format, mesh, { ...options, ...labels }));
    expect({ ...back.units }).toEqual(units);
    expect({ ...back.componentNames }).toEqual(labels.componentNames);
  });

  it.each(['regions', 'part id', 'vertex_indices', 'Größe', 'pressure', '__proto__'])(
    'gives labels of triangles back, called %s',
    async (regionName) => {
      const regions = Int32Array.of(7, -(2 ** 31) + 1, 0);
      const mesh = { ...smallMesh(mixedVariables()), regions };
      const back = await readSurface('', await writeSurface(format, mesh, { ...options, regionName }));
      expect(fingerprint(back.mesh)).toEqual(fingerprint(mesh));
      expect(back.regions).toEqual(new Map([[regionName, regions]]));
    },
  );

  it('gives several arrays of labels back, beside the regions', async () => {
    const regions = Int32Array.of(7, 8, 9);
    const cellData = new Map([
      ['part id', Int32Array.of(-1, 0, 1)],
      ['part_id', Int32Array.of(2 ** 31 - 1, 4, -(2 ** 31) + 1)],
    ]);
    const mesh = { ...smallMesh(mixedVariables()), regions };
    const back = await readSurface('', await writeSurface(format, mesh, { ...options, cellData }));
    expect(fingerprint(back.mesh)).toEqual(fingerprint(mesh));
    expect(back.regions).toEqual(new Map([['regions', regions], ...cellData]));
  });

  it('gives any mesh back bit for bit', async () => {
    const property = fc.asyncProperty(meshes, async (mesh) => {
      const back = await readSurface('', await writeSurface(format, mesh, options));
      expect(fingerprint(back.mesh)).toEqual(fingerprint(mesh));
    });
    await fc.assert(property, { numRuns: 200 });
  });
});

describe('a name that a format cannot hold is refused', () => {
  const named = (name: string) => smallMesh([{ name, components: 1, values: new Float32Array(4) }]);

  it.each(['vtp', 'vtk', 'glb'] as const)('where it is empty, %s', async (format) => {
    await expect(writeSurface(format, named(''))).rejects.toMatchObject({ code: 'empty_name' });
  });

  it.each(['vtp', 'vtk'] as const)('where it is no text, %s', async (format) => {
    await expect(writeSurface(format, named('\u{D800}'))).rejects.toMatchObject({ code: 'bad_name' });
  });
});
