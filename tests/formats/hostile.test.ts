import { readdirSync, readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { FormatError } from '../../web/formats/format-error.ts';
import { readSurface } from '../../web/formats/read.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { accessorsOf } from './gltf-file.ts';
import { fingerprint, mixedVariables, smallMesh, withinSingles } from './sample-mesh.ts';

const fixtures = new URL('fixtures/', import.meta.url);
const kept = ['pressure', 'temperature', 'velocity', 'Mach number'];
const mesh = smallMesh(mixedVariables().filter(({ name }) => kept.includes(name)));

/** For a busy machine; what is tested here takes well below a second a file. */
const patience = 60_000;
const textStl =
  'solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\nendfacet\nendsolid s\n';
const texturedObj =
  'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0.5\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1\nf -1/-1/-1 -2//1 \\\n2\n';

/** The triangles of the GLB file as glTF in text, with its data inside. */
function gltfText(): Uint8Array {
  const { json, binary } = accessorsOf([
    { components: 3, values: mesh.position as Float32Array },
    { components: 1, values: Uint16Array.from(mesh.triangles) },
    { components: 1, values: Float32Array.of(1, 2, 3, 4) },
  ]);
  const uri = `data:application/octet-stream;base64,${btoa(String.fromCharCode(...binary))}`;
  const meshes = [{ primitives: [{ attributes: { POSITION: 0, _P: 2 }, indices: 1 }] }];
  const buffers = [{ byteLength: binary.length, uri }];
  return new TextEncoder().encode(JSON.stringify({ asset: { version: '2.0' }, buffers, ...json, meshes }));
}

const files: [name: string, bytes: Uint8Array][] = [
  ['ASCII PLY', await writeSurface('ply', mesh, { encoding: 'ascii' })],
  ['binary PLY', await writeSurface('ply', mesh)],
  ['big-endian PLY', await writeSurface('ply', mesh, { encoding: 'binary_big_endian' })],
  ['VTP', await writeSurface('vtp', mesh)],
  ['legacy VTK', await writeSurface('vtk', mesh)],
  ['GLB', await writeSurface('glb', withinSingles(mesh))],
  ['glTF in text', gltfText()],
  ['OBJ', await writeSurface('obj', mesh)],
  ['textured OBJ', new TextEncoder().encode(texturedObj)],
  ['STL', await writeSurface('stl', mesh)],
  ['STL in text', new TextEncoder().encode(textStl)],
  ...readdirSync(fixtures)
    .filter((name) => /\.(vtp|vtk)$/.test(name))
    .map((name): [string, Uint8Array] => [name, new Uint8Array(readFileSync(new URL(name, fixtures)))]),
];

// Thousands of errors are made here, and nobody reads where.
Error.stackTraceLimit = 0;

/** What becomes of a file: an error with a name, or a surface. Any other exception goes through and fails the test. */
async function outcome(bytes: Uint8Array) {
  try {
    return await readSurface('', bytes);
  } catch (error) {
    if (error instanceof FormatError) return error;
    throw error;
  }
}

describe.each(files)('%s', (name, bytes) => {
  it(
    'cut anywhere is an error with a name, or still whole',
    async () => {
      const whole = await outcome(bytes);
      const parts = whole instanceof FormatError ? [] : fingerprint(whole.mesh);
      // Legacy VTK and OBJ declare no length: whole arrays and strips may be gone from its end.
      const declaresLength = !/vtk$|OBJ/i.test(name);
      for (let length = 0; length < bytes.length; length++) {
        const cut = await outcome(bytes.subarray(0, length));
        if (cut instanceof FormatError) continue;
        expectToHoldTogether(cut.mesh);
        if (!declaresLength) continue;
        const found = fingerprint(cut.mesh);
        // The last number of a text may have lost digits, but then that is suspected.
        const certain = cut.summary.includes('line break') ? -1 : parts.length;
        expect(found.slice(0, certain)).toEqual(parts.slice(0, certain));
      }
    },
    patience,
  );

  it(
    'with any bytes changed, added or gone is an error with a name, or a mesh that holds together',
    async () => {
      const change = fc.record({
        at: fc.nat(bytes.length),
        removed: fc.oneof(fc.constantFrom(0, 1, 4), fc.nat(100)),
        added: fc.oneof(
          fc.uint8Array({ maxLength: 8 }),
          fc
            .constantFrom('-1', '4294967295', '999999999999', '1e99', 'nan', '<', '">', '&x;', '\n', ' ')
            .map((text) => new TextEncoder().encode(text)),
        ),
      });
      const property = fc.asyncProperty(fc.array(change, { minLength: 1, maxLength: 3 }), async (changes) => {
        let changed = bytes;
        for (const { at, removed, added } of changes) {
          changed = Uint8Array.of(...changed.subarray(0, at), ...added, ...changed.subarray(at + removed));
        }
        const result = await outcome(changed);
        if (!(result instanceof FormatError)) expectToHoldTogether(result.mesh);
      });
      await fc.assert(property, { numRuns: 300 });
    },
    patience,
  );
});

function expectToHoldTogether({ position, triangles, variables }: typeof mesh): void {
  const points = position.length / 3;
  expect(Number.isInteger(points)).toBe(true);
  expect(triangles.length % 3).toBe(0);
  expect(triangles.every((corner) => corner < points)).toBe(true);
  for (const { components, values } of variables) expect(values.length).toBe(points * components);
}
