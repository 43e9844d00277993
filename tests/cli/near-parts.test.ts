import { expect, test } from 'vitest';
import type { Mesh } from '../../wasm/types.ts';
import { Folder } from './command.ts';

const folder = new Folder();
const side = 12;

/** Two wavy sheets, one `gap` above the other. */
function sheets(gap: number): Mesh {
  const [position, triangles]: number[][] = [[], []];
  for (const level of [0, 1]) {
    for (let row = 0; row < side; row++) {
      for (let column = 0; column < side; column++) {
        const [x, y] = [column / (side - 1), row / (side - 1)];
        position.push(x, y, 0.05 * Math.sin(6 * x) * Math.cos(5 * y) + level * gap);
        if (row === side - 1 || column === side - 1) continue;
        const at = level * side * side + row * side + column;
        triangles.push(at, at + 1, at + side + 1, at, at + side + 1, at + side);
      }
    }
  }
  return { position: Float64Array.from(position), triangles: Uint32Array.from(triangles), variables: [] };
}

async function notesOf(gap: number, ...args: string[]): Promise<string> {
  await folder.save('sheets.ply', sheets(gap));
  const { status, stderr } = await folder.run('reduce', 'sheets.ply', '-o', 'out.ply', ...args);
  expect(status).toBe(0);
  return stderr;
}

test('parts nearer to each other than the bound of position are said, with what keeps them from piercing', async () => {
  expect(await notesOf(0.01, '-b', 'position=0.02')).toMatch(/sheets\.ply: parts .* nearer .* --refuse-piercing keeps/);
  expect(await notesOf(0.03, '-b', 'position=0.02')).toBe('');
  expect(await notesOf(0.01, '-b', 'position=free')).not.toContain('piercing');
  expect(await notesOf(0.01, '-b', 'position=0.02', '--refuse-piercing')).toBe('');
  expect(await notesOf(0.01, '-b', 'position=0.02', '--limit-to-feature-size')).not.toContain('--refuse-piercing');
  expect(await notesOf(0.01, '-b', 'position=0.02', '--quiet')).toBe('');
});

test('of levels the largest bound counts', async () => {
  expect(await notesOf(0.01, '--levels', '1%', '-b', 'position=0.001')).toBe('');
  expect(await notesOf(0.01, '--levels', '1%,2%', '-b', 'position=0.001,0.02')).toContain('--refuse-piercing');
});
