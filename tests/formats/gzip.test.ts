import { gunzipSync, gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { formatByEnding, formatNames } from '../../web/formats/format-names.ts';
import { readSurface } from '../../web/formats/read.ts';
import type { Format } from '../../web/formats/surface.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { expectFault, faultOf } from './faults.ts';
import { fingerprint, smallMesh } from './sample-mesh.ts';

const formats = Object.keys(formatNames) as Format[];

describe('a file packed by gzip', () => {
  it.each(formats)('is read as %s', async (format) => {
    const file = await writeSurface(format, smallMesh());
    const plain = await readSurface(`mesh.${format}`, file);
    const packed = await readSurface(`mesh.${format}.gz`, new Uint8Array(gzipSync(file)));
    expect(fingerprint(packed.mesh)).toEqual(fingerprint(plain.mesh));
    expect(packed.notes).toEqual(plain.notes);
    const written = await writeSurface(format, smallMesh(), { gzip: true });
    expect(new Uint8Array(gunzipSync(written))).toEqual(file);
    expect(formatByEnding(`a.b.${format.toUpperCase()}.gz`)).toBe(format);
  });

  it('that is damaged or cut anywhere is refused', async () => {
    const packed = new Uint8Array(gzipSync(await writeSurface('ply', smallMesh())));
    for (let length = 2; length < packed.length; length++)
      await expectFault(packed.subarray(0, length), 'corrupt', 'gzip');
    const checksum = packed.slice();
    checksum[packed.length - 8] ^= 1;
    await expectFault(checksum, 'corrupt', 'gzip');
  });

  it('that is a bomb is refused before it fills the memory', async () => {
    const bomb = new Uint8Array(gzipSync(new Uint8Array(128 << 20)));
    await expectFault(bomb, 'too_large', 'gzip');
    // A busy machine takes its time to make the bomb.
  }, 60_000);

  it('that is a bomb and says to be none is refused', async () => {
    const bomb = new Uint8Array(gzipSync(new Uint8Array(128 << 20)));
    new DataView(bomb.buffer).setUint32(bomb.length - 4, 1000, true);
    await expectFault(bomb, 'too_large', 'gzip');
  }, 60_000);

  it('that is a bomb is refused by its first part, whatever comes behind', async () => {
    const bomb = new Uint8Array(gzipSync(new Uint8Array(256 << 20)));
    const padded = new Uint8Array(bomb.length + (8 << 20));
    padded.set(bomb);
    const { message } = await faultOf(padded);
    const [, taken] = /^The first ([\d ]+) bytes of the gzip file unpack to more than/.exec(message) ?? [];
    expect(Number(taken.replaceAll(' ', ''))).toBeLessThan(bomb.length);
  }, 60_000);

  it('begins with a long run of one value if it likes', async () => {
    // Points that are all in one place, ahead of values that are hard to pack.
    const points = 2_000_000;
    const values = Float32Array.from({ length: points }, (_, i) => Math.imul(i, 0x9e3779b1));
    const variables = [{ name: 'p', components: 1, values }];
    const flat = { position: new Float32Array(3 * points), triangles: Uint32Array.of(0, 1, 2), variables };
    const file = await writeSurface('vtk', flat, { gzip: true });
    expect((await readSurface('flat.vtk.gz', file)).mesh.position.length).toBe(3 * points);
  }, 60_000);

  it('is read in several parts one after the other', async () => {
    const file = await writeSurface('ply', smallMesh());
    const parts = [file.subarray(0, 99), file.subarray(99)].map((part) => gzipSync(part));
    const { mesh } = await readSurface('mesh.ply.gz', new Uint8Array(Buffer.concat(parts)));
    expect(fingerprint(mesh)).toEqual(fingerprint(smallMesh()));
  });

  it('inside another is refused by name', async () => {
    await expectFault(new Uint8Array(gzipSync(gzipSync('ply'))), 'unsupported_format', 'gzip');
  });
});
