import { describe, expect, it } from 'vitest';
import { readSurface } from '../../web/formats/read.ts';
import type { Format } from '../../web/formats/surface.ts';
import type { WholeType } from '../../web/formats/variables/whole-types.ts';
import { lossesOf, writeSurface } from '../../web/formats/write.ts';
import { smallMesh } from './sample-mesh.ts';

/** The ends of each type, and of what doubles hold. */
const ends: Record<WholeType, [number, number]> = {
  int8: [-128, 127],
  uint8: [0, 255],
  int16: [-32768, 32767],
  uint16: [0, 65535],
  int32: [-(2 ** 31), 2 ** 31 - 1],
  uint32: [0, 2 ** 32 - 1],
  int64: [-(2 ** 53) + 1, 2 ** 53 - 1],
  uint64: [0, 2 ** 53 - 1],
};
const types = Object.keys(ends) as WholeType[];
const variables = types.map((name) => ({
  name,
  components: 1,
  values: Float64Array.of(...ends[name], 3, 77),
}));
const wholeTypes = Object.fromEntries(types.map((type) => [type, type]));
const mesh = smallMesh(variables);
const isWide = (name: string) => name.endsWith('64');

describe('whole numbers keep their type', () => {
  const formats: Format[] = ['ply', 'vtp', 'vtk'];
  const pairs = formats.flatMap((from) => formats.map((to) => [from, to] as const));
  it.each(pairs)('from %s to %s', async (from, to) => {
    const first = await readSurface(`a.${from}`, await writeSurface(from, mesh, { wholeTypes }));
    const second = await readSurface(`b.${to}`, await writeSurface(to, first.mesh, first));
    const kept = types.filter((name) => !isWide(name) || (from !== 'ply' && to !== 'ply'));
    expect({ ...second.wholeTypes }).toEqual(Object.fromEntries(kept.map((type) => [type, type])));
    for (const [i, { values }] of variables.entries()) {
      expect(Array.from(second.mesh.variables[i].values)).toEqual(Array.from(values));
    }
  });

  it('in text PLY, too', async () => {
    const file = await writeSurface('ply', mesh, { wholeTypes, encoding: 'ascii' });
    expect(new TextDecoder().decode(file)).toContain('property ushort uint16\nproperty int int32\n');
    const back = await readSurface('a.ply', file);
    expect(Array.from(back.mesh.variables[5].values)).toEqual(Array.from(variables[5].values));
  });

  it('not where a value is none of the type', async () => {
    const [odd, fine] = [Float64Array.of(1, 2, 3, 0.5), Float64Array.of(1, 2, 3, 4)];
    for (const [values, kept] of [
      [odd, false],
      [Float64Array.of(1, 2, 3, 300), false],
      [Float64Array.of(1, 2, 3, -0), false],
      [Float64Array.of(1, 2, 3, Number.NaN), false],
      [fine, true],
    ] as const) {
      const surface = smallMesh([{ name: 'n', components: 1, values }]);
      const back = await readSurface('a.vtp', await writeSurface('vtp', surface, { wholeTypes: { n: 'uint8' } }));
      expect(back.wholeTypes?.n).toBe(kept ? 'uint8' : undefined);
      expect(Array.from(back.mesh.variables[0].values)).toEqual(Array.from(values));
    }
  });

  it('and a format that has none says so by name', async () => {
    expect(await lossesOf('vtp', mesh, { wholeTypes })).toEqual([]);
    expect(await lossesOf('ply', mesh, { wholeTypes })).toEqual([
      'PLY holds as floating point what were whole numbers: “int64”, “uint64”.',
    ]);
    const [loss] = await lossesOf('glb', mesh, { wholeTypes });
    expect(loss).toMatch(/^GLB holds as floating point what were whole numbers: “int8”, .*“uint64”\.$/);
  });
});
