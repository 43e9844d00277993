import { expect, test } from 'vitest';
import type { Mesh } from '../../wasm/types.ts';
import { Folder } from './command.ts';

const folder = new Folder();

type Point = [number, number, number];

function surface(points: Point[], triangles: number[][]): Mesh {
  return { position: Float64Array.from(points.flat()), triangles: Uint32Array.from(triangles.flat()), variables: [] };
}

function around(count: number, radius: number, z: number): Point[] {
  return Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return [radius * Math.cos(angle), radius * Math.sin(angle), z];
  });
}

/** Two points above and below a ring, joined with all of it. */
function bipyramid(count: number): Mesh {
  const triangles = Array.from({ length: count }, (_, i) => {
    const next = 2 + ((i + 1) % count);
    return [0, 2 + i, next, 1, next, 2 + i];
  });
  return surface([[0, 0, 1], [0, 0, -1], ...around(count, 1, 0)], triangles);
}

/** Every three of some points: three or more triangles on each edge. */
function everyThree(count: number): Mesh {
  const triangles: number[][] = [];
  for (let a = 0; a < count; a++)
    for (let b = a + 1; b < count; b++) for (let c = b + 1; c < count; c++) triangles.push([a, b, c]);
  const points = Array.from({ length: count }, (_, i): Point => [Math.cos(i), Math.sin(2 * i), 0.3 * i]);
  return surface(points, triangles);
}

function grid(cells: number, height: (x: number, y: number) => number): Mesh {
  const row = cells + 1;
  const points = Array.from({ length: row * row }, (_, i): Point => {
    const [x, y] = [i % row, Math.floor(i / row)];
    return [x / cells, y / cells, height(x, y)];
  });
  const triangles = Array.from({ length: cells * cells }, (_, i) => {
    const at = Math.floor(i / cells) * row + (i % cells);
    return [at, at + 1, at + row + 1, at, at + row + 1, at + row];
  });
  return surface(points, triangles);
}

const tetrahedron = surface(
  [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  [
    [0, 2, 1],
    [0, 1, 3],
    [1, 2, 3],
    [0, 3, 2],
  ],
);

async function reduce(mesh: Mesh, bound: string, ...args: string[]) {
  await folder.save('in.ply', mesh);
  const files = ['in.ply', '-o', 'out.ply', '--report', 'report.json'];
  const { status, stdout } = await folder.run('reduce', ...files, '-b', `position=${bound}`, ...args);
  expect(status).toBe(0);
  return { stdout, heldBack: JSON.parse(folder.text('report.json')).heldBack };
}

const everyPoint = ['--lock-box', '-9,-9,-9,9,9,9'.replace(/^/, '')];

test.each<[string, Mesh, string[], string, RegExp]>([
  ['curves that meet everywhere', everyThree(7), [], 'nonManifold', /100 % of the vertices left stand where curves meet/],
  ['a box that locks all', grid(6, () => 0), [`--lock-box=${everyPoint[1]}`], 'locked', /100 % of the vertices left are locked/],
  ['a tetrahedron', tetrahedron, [], 'topology', /100 % of the vertices left cannot go without making another surface/],
])('names the reason: %s', async (_, mesh, args, reason, sentence) => {
  const { stdout, heldBack } = await reduce(mesh, '50%', ...args);
  console.log(stdout, JSON.stringify(heldBack));
  expect(stdout).toMatch(sentence);
});
for (const [n, m, a] of [
  ['ring', bipyramid(60), ['--lock-points', '2-61']],
  ['fold', grid(10, (x, y) => ((x * 7 + y * 13) % 5) * 3), []],
  ['fold2', grid(10, (x, y) => (x % 2) * 50 + (y % 2) * 50), []],
  ['bounds', grid(10, (x, y) => Math.sin(x) * Math.cos(y)), ['-b', 'position=1e-9']],
] as [string, Mesh, string[]][])
  test(n, async () => {
    const { stdout, heldBack } = await reduce(m, 'free', ...a);
    console.log(n, stdout, JSON.stringify(heldBack));
  });
