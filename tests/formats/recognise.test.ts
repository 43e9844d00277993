import { describe, expect, it } from 'vitest';
import { formatByEnding } from '../../web/formats/format-names.ts';
import { readSurface } from '../../web/formats/read.ts';
import { recognise } from '../../web/formats/recognise.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { expectFault } from './faults.ts';
import { bytesOf, smallMesh } from './sample-mesh.ts';

describe('a file', () => {
  it('is read by its content, and its misleading name is mentioned', async () => {
    const ply = await writeSurface('ply', smallMesh());
    expect(await readSurface('mesh.PLY', ply)).toMatchObject({ format: 'ply', summary: '' });
    expect(await readSurface('mesh', ply)).toMatchObject({ format: 'ply', summary: '' });
    expect((await readSurface('mesh.vtp', ply)).summary).toContain('the content is PLY');
    const vtp = await writeSurface('vtp', smallMesh());
    expect((await readSurface('mesh.ply', vtp)).summary).toContain('the content is VTP');
  });

  it('is recognised behind comments, however long', () => {
    const vtp = `<?xml version="1.0"?>\n<!-- ${'not - yet > '.repeat(60)} --><!---->\n<VTKFile type="PolyData">`;
    expect(recognise(bytesOf(vtp), 'file')).toBe('vtp');
    const obj = `# ${'remark '.repeat(200)}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n`;
    expect(recognise(bytesOf(obj), 'file')).toBe('obj');
    const manyComments = `${'# remark\n'.repeat(2000)}mtllib a.mtl\nvn 0 0 1\nv 0 0 0\n`;
    expect(recognise(bytesOf(manyComments), 'mesh.ply')).toBe('obj');
  });

  it('made of comments that lead to nothing is refused, and at once', async () => {
    await expectFault(`${'<!---->'.repeat(9000)}<x`, 'not_a_mesh');
  });

  it('whose variable is named like the geometry has it renamed, and says so', async () => {
    const values = Float32Array.of(1, 2, 3, 4);
    const named = (...names: string[]) => smallMesh(names.map((name) => ({ name, components: 1, values })));
    for (const format of ['vtp', 'vtk', 'ply', 'glb'] as const) {
      const file = await writeSurface(format, named('position', 'position_2'));
      const { mesh, summary } = await readSurface(`mesh.${format}`, file);
      expect(mesh.variables.map(({ name }) => name)).toEqual(['position_3', 'position_2']);
      expect(summary).toContain('The variable “position” is called “position_3” from here on');
    }
  });

  it('whose variable is named like what stands for all of them has it renamed, with its unit, and says so', async () => {
    const variables = ['*', 'q'].map((name) => ({ name, components: 1, values: Float32Array.of(1, 2, 3, 4) }));
    for (const format of ['vtp', 'vtk', 'ply', 'glb'] as const) {
      const file = await writeSurface(format, smallMesh(variables), { units: { '*': 'K' }, componentNames: {} });
      const { mesh, summary, units } = await readSurface(`mesh.${format}`, file);
      expect(mesh.variables.map(({ name }) => name)).toEqual(['*_2', 'q']);
      expect({ ...units }).toEqual({ '*_2': 'K' });
      expect(summary).toContain('The variable “*” is called “*_2” from here on: “*” stands for all variables.');
    }
  });

  it('is named after its format by the ending that is known', () => {
    expect(['a.ply', 'a.vtp.gz', 'b.c.VTK', 'glb', 'a.txt', 'a.constructor', ''].map(formatByEnding)).toEqual([
      'ply',
      'vtp',
      'vtk',
      undefined,
      undefined,
      undefined,
      undefined,
    ]);
  });

  it('that is empty is refused', async () => {
    await expectFault('', 'empty_file', 'empty');
  });

  it.each([
    ['OFF\n8 6 0', 'OFF'],
    ['PK\u0003\u0004', 'ZIP'],
    ['%PDF-1.4', 'PDF'],
    ['<!doctype html><html>', 'HTML'],
    ['<?xml version="1.0"?><svg/>', 'XML'],
  ])('like %j is refused by name', async (content, name) => {
    await expectFault(content, 'unsupported_format', name);
  });

  it('of variables alone is told to need a surface', async () => {
    await expect(readSurface('heat.csv', bytesOf('heat\n1\n2\n'))).rejects.toMatchObject({
      code: 'not_a_mesh',
      message: expect.stringContaining('A CSV file adds variables to a surface'),
    });
  });

  it('of an image is refused by name', async () => {
    await expectFault(Uint8Array.of(0x89, 0x50, 0x4e, 0x47), 'unsupported_format', 'image');
  });

  it.each(['hello', 'plywood', 'x,y,z\n1,2,3', '\0\0\0\0', 'v', 'solid'])('like %j is no mesh', async (content) => {
    await expectFault(content, 'not_a_mesh');
  });
});
