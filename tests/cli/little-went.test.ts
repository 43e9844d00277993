import { expect, test } from 'vitest';
import type { Mesh } from '../../wasm/types.ts';
import { Folder } from './command.ts';

const folder = new Folder();

type Point = [number, number, number];

function surface(points: Point[], triangles: number[][]): Mesh {
  return { position: Float64Array.from(points.flat()), triangles: Uint32Array.from(triangles.flat()), variables: [] };
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
  return { stdout, refused: JSON.parse(folder.text('report.json')).refused };
}

/** A grid whose every point is moved by up to ten cells any way: full of folds. */
function crumpled(): Mesh {
  let state = 1;
  const random = () => {
    state = (state * 16807) % 2147483647;
    return state / 2147483647 - 0.5;
  };
  const flat = grid(10, () => 0);
  return { ...flat, position: flat.position.map((coordinate) => coordinate + 2 * random()) };
}

test.each<[string, Mesh, string[], string, string]>([
  [
    'curves that meet everywhere',
    everyThree(7),
    [],
    'nonManifold',
    '100 % of the vertices left stand where curves meet',
  ],
  [
    'a box that locks all',
    grid(6, () => 0),
    ['--lock-box=-9,-9,-9,9,9,9'],
    'locked',
    '100 % of the vertices left are locked',
  ],
  ['a tetrahedron', tetrahedron, [], 'topology', '100 % of the vertices left cannot go without making another surface'],
  ['a crumpled sheet', crumpled(), [], 'fold', '% of the vertices left cannot go without a fold'],
])('names what held most: %s', async (_, mesh, args, reason, words) => {
  const { stdout, refused } = await reduce(mesh, '20%', ...args);
  expect(refused.whyLittleWent.reason).toBe(reason);
  expect(stdout).toContain('Why so little went: ');
  expect(stdout).toContain(words);
});

test('says nothing where the bounds are the reason, or where half went', async () => {
  const wavy = grid(10, (x, y) => Math.sin(x) * Math.cos(y));
  for (const [mesh, bound] of [
    [wavy, '1e-9'],
    [wavy, '5%'],
  ] as const) {
    const { stdout, refused } = await reduce(mesh, bound);
    expect(refused.whyLittleWent).toBeNull();
    expect(stdout).not.toContain('Why so little');
  }
});
