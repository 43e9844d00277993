import { expect, it } from 'vitest';
import { readSurface } from '../../web/formats/read.ts';

/** A strip of triangles in text PLY with one more property of each point. */
async function kindOf(type: string, name: string, value: (point: number) => number) {
  const points = Array.from({ length: 20 }, (_, i) => `${i >> 1} ${i & 1} 0 ${value(i)}`);
  const faces = Array.from({ length: 18 }, (_, i) => `3 ${i} ${i + 1} ${i + 2}`);
  const head = `ply\nformat ascii 1.0\nelement vertex 20\nproperty float x\nproperty float y\nproperty float z\n`;
  const more = `property ${type} ${name}\nelement face 18\nproperty list uchar int vertex_indices\nend_header\n`;
  const text = `${head}${more}${[...points, ...faces].join('\n')}\n`;
  const { mesh, summary } = await readSurface('a.ply', new TextEncoder().encode(text));
  expect(summary.includes('Taken for identifiers')).toBe(mesh.variables[0].kind === 'identifier');
  return mesh.variables[0].kind;
}

it.each([
  ['float', 'GlobalNodeID', (i: number) => i % 5],
  ['double', 'pedigree_ids', (i: number) => i % 5],
  ['float', 'vtkOriginalPointIds', (i: number) => i % 5],
  ['uchar', 'vtkValidPointMask', () => 1],
  ['int', 'Object_Id', (i: number) => i % 5],
  ['int', 'tag', (i: number) => 7 * i - 3],
  ['uchar', 'wet', (i: number) => i % 2],
])('%s %s is an identifier', async (type, name, value) => {
  expect(await kindOf(type, name, value)).toBe('identifier');
});

it.each([
  ['float', 'elevation', (i: number) => i],
  ['double', 'switched', (i: number) => i % 2],
  ['int', 'count', (i: number) => i % 7],
  ['float', 'identity', (i: number) => i % 3],
  ['float', 'humidity', (i: number) => i % 3],
])('%s %s is a quantity', async (type, name, value) => {
  expect(await kindOf(type, name, value)).toBeUndefined();
});
