import { gunzipSync, gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { formatByEnding, formatNames } from '../../web/formats/format-names.ts';
import { readSurface } from '../../web/formats/read.ts';
import type { Format } from '../../web/formats/surface.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { expectFault } from './faults.ts';
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

  it('inside another is refused by name', async () => {
    await expectFault(new Uint8Array(gzipSync(gzipSync('ply'))), 'unsupported_format', 'gzip');
  });
});
