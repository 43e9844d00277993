import { validateBytes } from 'gltf-validator';
import { describe, expect, it } from 'vitest';
import type { Mesh, Reduction } from '../../wasm/types.ts';
import { screenCoverages, writeGlbLevels } from '../../web/formats/gltf/write-glb-levels.ts';
import { readSurface } from '../../web/formats/read.ts';
import { writeLevels } from '../../web/formats/write.ts';
import { fingerprint, mixedVariables, smallMesh } from './sample-mesh.ts';

const singles = mixedVariables().filter(({ values }) => values instanceof Float32Array && values.length > 0);
const fine = smallMesh(singles);
const coarse = { ...fine, triangles: fine.triangles.slice(0, 3) };
const labels = { units: { position: 'mm' }, componentNames: {} };

function jsonOf(file: Uint8Array) {
  const size = new DataView(file.buffer, file.byteOffset).getUint32(12, true);
  return JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + size)));
}

describe('levels of detail in one GLB', () => {
  it('are nodes that the finest one names, finest first', async () => {
    const { nodes, scenes, meshes, extensionsUsed, extensionsRequired } = jsonOf(
      await writeGlbLevels([
        { mesh: fine, error: 0.001 },
        { mesh: coarse, error: 0.01 },
        { mesh: coarse, error: 0.1 },
      ]),
    );
    const shown = scenes[0].nodes[0];
    expect(scenes[0].nodes).toHaveLength(1);
    const chain = [shown, ...nodes[shown].extensions.MSFT_lod.ids].map((index: number) => nodes[index]);
    expect(chain.map(({ name }) => name)).toEqual(['LOD0', 'LOD1', 'LOD2']);
    expect(new Set(chain.map(({ mesh }) => mesh)).size).toBe(3);
    expect(meshes).toHaveLength(3);
    expect(extensionsUsed).toEqual(['MSFT_lod']);
    expect(extensionsRequired).toBeUndefined();
    expect(nodes[shown].extras.MSFT_screencoverage).toHaveLength(3);
  });

  it('pass the validator of the Khronos Group', async () => {
    for (const levels of [[{ mesh: fine }], [{ mesh: fine }, { mesh: coarse }]]) {
      const { issues } = await validateBytes(await writeGlbLevels(levels, labels));
      expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
    }
  });

  it('are read as the finest one, as by programs that do not know the extension', async () => {
    const back = await readSurface('levels.glb', await writeGlbLevels([{ mesh: fine }, { mesh: coarse }], labels));
    expect(fingerprint(back.mesh)).toEqual(fingerprint(fine));
    expect(back.units.position).toBe('mm');
  });

  it('can be packed', async () => {
    const packed = await writeGlbLevels([{ mesh: fine }, { mesh: coarse }], { gzip: true });
    expect((await readSurface('levels.glb.gz', packed)).mesh.triangles).toHaveLength(fine.triangles.length);
  });
});

describe('levels as they come from a reduction', () => {
  const reduced = (mesh: Mesh, error: number, extent = 1) =>
    ({ mesh, report: { variables: [{ error, extent }] } }) as unknown as Reduction;

  it('go to one GLB with the hint at when to switch', async () => {
    const levels = [reduced(fine, 0.002, 2), reduced(coarse, 0.02, 2)];
    const direct = await writeGlbLevels([
      { mesh: fine, error: 0.001 },
      { mesh: coarse, error: 0.01 },
    ]);
    expect(await writeLevels(levels)).toEqual(direct);
    expect(jsonOf(await writeLevels([reduced(fine, 0, 0), reduced(coarse, 0, 0)])).nodes[0].extras).toBe(undefined);
  });

  it('are refused where the format cannot hold them', async () => {
    const nameless = { ...fine, variables: [{ ...singles[0], name: '' }] };
    await expect(writeLevels([reduced(nameless, 0)])).rejects.toThrow('without a name');
    const endless = { ...fine, position: fine.position.map(() => Infinity) };
    await expect(writeLevels([reduced(fine, 0), reduced(endless, 0)])).rejects.toThrow('position');
  });
});

describe('the hint at when to switch', () => {
  it('is where the error of the next level is a pixel', () => {
    // A surface of 108 pixels, a tenth of the lines, has an error of one pixel in the second level.
    expect(screenCoverages([0.001, 1 / 108, 1])).toEqual([
      expect.closeTo(0.01, 10),
      expect.closeTo(1 / 1080 ** 2, 10),
      0,
    ]);
    expect(screenCoverages([0, 1e-9])).toEqual([1, 0]);
  });

  it('is not given where an error is not known', () => {
    expect(screenCoverages([0.1, undefined])).toBeUndefined();
  });
});
