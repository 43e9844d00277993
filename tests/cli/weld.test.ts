import { beforeAll, expect, test } from 'vitest';
import type { Mesh } from '../../wasm/types.ts';
import { topologyOf } from '../../web/surface/topology.ts';
import { Folder } from './command.ts';

const folder = new Folder();
const side = 9;

/** Two halves of a wavy square that end a millionth of a tenth beside each other, alternately on either side. */
function halves(): Mesh {
  const [position, triangles]: number[][] = [[], []];
  for (const half of [0, 1]) {
    for (let row = 0; row < side; row++) {
      for (let column = 0; column < side; column++) {
        const [x, y] = [column / (side - 1), half + row / (side - 1)];
        const noise = half === 1 && row === 0 ? 1e-7 * (column % 2 === 0 ? 1 : -1) : 0;
        position.push(x, y + noise, 0.1 * Math.sin(5 * x * y));
        if (row === side - 1 || column === side - 1) continue;
        const at = half * side * side + row * side + column;
        triangles.push(at, at + 1, at + side + 1, at, at + side + 1, at + side);
      }
    }
  }
  const values = Float64Array.from({ length: position.length / 3 }, (_, i) => position[3 * i] ** 2);
  const variables = [{ name: 'pressure', components: 1, values }];
  return { position: Float64Array.from(position), triangles: Uint32Array.from(triangles), variables };
}

beforeAll(() => folder.save('halves.ply', halves()));

test('a crack is said by every command that reads the file', async () => {
  for (const args of [
    ['inspect', 'halves.ply'],
    ['convert', 'halves.ply', 'out.vtp'],
    ['reduce', 'halves.ply', '-o', 'small.ply', '-b', '*=1%', '-b', 'position=1%'],
    ['verify', 'halves.ply', 'halves.ply', '-b', 'position=1%'],
  ]) {
    const { status, stderr } = await folder.run(...args);
    expect(status).toBe(0);
    expect(stderr).toMatch(/halves\.ply: A crack: 18 points .* 1e-7 wide\..*--weld 1e-6/);
  }
});

test('--weld closes it, and what is written is whole', async () => {
  const bounds = ['-b', '*=1%', '-b', 'position=1%'];
  const outcome = await folder.run('reduce', 'halves.ply', '-o', 'whole.ply', '--weld', '1e-6', ...bounds);
  expect(outcome.status).toBe(0);
  expect(outcome.stderr).toContain('9 points where sheets end put where others lie, by 1e-7 at most; all of them');
  expect(outcome.stderr).not.toContain('crack');
  const { mesh } = await folder.read('whole.ply');
  expect(topologyOf(mesh.triangles, mesh.position.length / 3)).toMatchObject({ components: 1, boundaryLoops: 1 });
  const judged = await folder.run('verify', 'halves.ply', 'whole.ply', '--weld', '0.0001%', ...bounds);
  expect(judged).toMatchObject({ status: 0 });
  const { stdout } = await folder.run('inspect', '--json', '--weld', '1e-6', 'halves.ply');
  expect(JSON.parse(stdout)).toMatchObject({ components: 1, boundaryLoops: 1, vertices: 2 * side * side - side });
  await folder.run('convert', 'halves.ply', 'joined.vtp', '--weld=1e-6');
  expect((await folder.read('joined.vtp')).mesh.position).toHaveLength(3 * (2 * side * side - side));
});

test.each(['0', '-1e-6', '0.5', '1e-6m', 'much', ''])('--weld %s is refused', async (fraction) => {
  const { status, stderr } = await folder.run('inspect', 'halves.ply', `--weld=${fraction}`);
  expect(status).toBe(2);
  expect(stderr).toContain(`--weld cannot be “${fraction}”; it is a fraction of the extent`);
});
