import { validateBytes } from 'gltf-validator';
import { describe, expect, it } from 'vitest';
import { readSurface } from '../../web/formats/read.ts';
import type { Format } from '../../web/formats/surface.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { smallMesh } from './sample-mesh.ts';

const bytes = [255, 0, 0, 0, 254, 7, 128, 1, 255, 3, 77, 200];
const color = { name: 'color', components: 3, values: Float32Array.from(bytes) };
const formats: Format[] = ['ply', 'vtp', 'vtk', 'glb', 'obj'];

describe('colours of bytes', () => {
  const pairs = formats.flatMap((from) => formats.map((to) => [from, to] as const));
  it.each(pairs)('survive from %s to %s', async (from, to) => {
    const first = await readSurface(`a.${from}`, await writeSurface(from, smallMesh([color])));
    const second = await readSurface(`b.${to}`, await writeSurface(to, first.mesh));
    expect(second.mesh.variables).toEqual([color]);
  });

  it('are uchar in PLY and VTK, fractions in OBJ, normalised bytes in glTF', async () => {
    const text = async (format: Format) =>
      new TextDecoder('latin1').decode(await writeSurface(format, smallMesh([color])));
    expect(await text('ply')).toContain('property uchar red\nproperty uchar green\nproperty uchar blue\n');
    expect(await text('vtp')).toContain('type="UInt8" Name="color"');
    expect(await text('vtk')).toContain('COLOR_SCALARS color 3\n');
    expect(await text('obj')).toMatch(/^v \S+ \S+ \S+ 1 0 0$/m);
    const file = await writeSurface('glb', smallMesh([color]));
    const size = new DataView(file.buffer, file.byteOffset).getUint32(12, true);
    const { meshes, accessors } = JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + size)));
    const accessor = accessors[meshes[0].primitives[0].attributes.COLOR_0];
    expect(accessor).toMatchObject({ componentType: 5121, normalized: true, type: 'VEC3' });
    const { issues } = await validateBytes(file);
    expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
  });

  it('have their place under the names of VTK, too, and keep them where a file holds names', async () => {
    const mesh = smallMesh([{ ...color, name: 'RGB' }]);
    for (const format of ['ply', 'vtp', 'vtk', 'glb'] as const) {
      const back = await readSurface(`a.${format}`, await writeSurface(format, mesh));
      expect(back.mesh.variables).toEqual(mesh.variables);
    }
    const { mesh: ofObj } = await readSurface('a.obj', await writeSurface('obj', mesh));
    expect(ofObj.variables).toEqual([color]);
  });

  it('of fractions stay as they are', async () => {
    const values = Float32Array.from({ length: 12 }, (_, i) => i / 11);
    for (const format of formats) {
      const back = await readSurface(`a.${format}`, await writeSurface(format, smallMesh([{ ...color, values }])));
      expect(Array.from(back.mesh.variables[0].values, Math.fround)).toEqual(Array.from(values));
    }
  });
});
