import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { readTogether } from '../../web/formats/read-together.ts';
import { surfaceAmong } from '../../web/formats/surface-among.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { accessorsOf } from './gltf-file.ts';
import { bytesOf, smallMesh } from './sample-mesh.ts';

const bytes = (text: string) => bytesOf(text) as Uint8Array<ArrayBuffer>;
const stl = await writeSurface('stl', smallMesh());
const table = (name: string, text = `${name}\n1\n2\n3\n4\n`) => ({ name: `${name}.csv`, bytes: bytes(text) });

describe('files that are chosen together', () => {
  it('are a surface and what lies beside it, in any order', () => {
    const chosen = (...names: string[]) => surfaceAmong(names.map((name) => ({ name })))?.name;
    expect(chosen('a.csv', 'a.STL', 'b.csv.gz')).toBe('a.STL');
    expect(chosen('a.bin', 'a.png', 'a.gltf')).toBe('a.gltf');
    expect(chosen('a.CSV')).toBe('a.CSV');
    expect(chosen()).toBeUndefined();
  });

  it('give a surface the variables of all tables', async () => {
    const packed = { name: 'c.csv.gz', bytes: new Uint8Array(gzipSync('c [K]\n5\n6\n7\n8\n')) };
    const { mesh, units, notes } = await readTogether('a.stl', stl, [table('b'), packed]);
    expect(mesh.variables.map(({ name, values }) => [name, values[0]])).toEqual([
      ['b', 1],
      ['c', 5],
    ]);
    expect({ ...units }).toEqual({ c: 'K' });
    expect(notes).toEqual(['5 repeated points welded.']);
  });

  it('name the table that does not fit', async () => {
    const reading = readTogether('a.stl', stl, [table('b'), table('short', 'p\n1\n')]);
    await expect(reading).rejects.toMatchObject({
      code: 'count_mismatch',
      message: expect.stringMatching(/^“short\.csv”: The CSV file has 1 line/),
    });
  });

  it('give a glTF file its buffers, whatever folder it thinks them in', async () => {
    const { json, binary } = accessorsOf([{ components: 3, values: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0) }]);
    const meshes = [{ primitives: [{ attributes: { POSITION: 0 } }] }];
    const buffers = [{ byteLength: binary.length, uri: 'data/a%20b.bin' }];
    const gltf = bytes(JSON.stringify({ asset: { version: '2.0' }, buffers, ...json, meshes }));
    const { mesh, summary } = await readTogether('a.gltf', gltf, [{ name: 'a b.bin', bytes: binary }]);
    expect([Array.from(mesh.triangles), summary]).toEqual([[0, 1, 2], '']);
    await expect(readTogether('a.gltf', gltf, [{ name: 'c.bin', bytes: binary }])).rejects.toMatchObject({
      code: 'unsupported_feature',
      message: expect.stringContaining('“data/a b.bin”, which is not at hand. Open both together'),
    });
  });

  it('have those named that had no part in it', async () => {
    const { summary } = await readTogether('a.stl', stl, [{ name: 'b.stl', bytes: bytes('') }]);
    expect(summary).toContain('Not opened with it: “b.stl”. One surface is opened at a time;');
  });
});
