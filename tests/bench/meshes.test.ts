// What the large surfaces of the benchmark are made from; the simulator may not have been compiled yet.
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test, vi } from 'vitest';
import { makeVolume } from './meshes.ts';

const calls = vi.hoisted<string[]>(() => []);

vi.mock('../../web/samples/simulate.ts', () => ({
  buildSimulator: () => calls.push('build'),
  simulate: (scene: string, cells: number[]) => {
    calls.push(`${scene} ${cells.join(' ')}`);
    if (calls[0] !== 'build') throw new Error('spawnSync samples-simulator ENOENT');
    const variables = [
      { name: 'density', unit: 'kg', values: Float32Array.of(1, 2) },
      { name: 'pressure', unit: 'Pa', values: Float32Array.of(3, 4.5) },
    ];
    return { scene, cells, spacing: 0.5, origin: [1, 2, 3], variables };
  },
}));

test('a volume is simulated by a simulator that is compiled first, and written as make_meshes.py reads it', () => {
  const folder = mkdtempSync(join(tmpdir(), 'meshbound-bench-'));
  try {
    const files = { description: join(folder, 'volume.json'), numbers: join(folder, 'volume.raw') };
    makeVolume('fireballs', [2, 1, 1], files);
    expect(calls).toEqual(['build', 'fireballs 2 1 1']);
    expect(JSON.parse(readFileSync(files.description, 'utf8'))).toMatchObject({
      cells: [2, 1, 1],
      spacing: 0.5,
      origin: [1, 2, 3],
      variables: [{ name: 'density' }, { name: 'pressure' }],
    });
    expect(readFileSync(files.numbers)).toEqual(Buffer.from(Float32Array.of(1, 2, 3, 4.5).buffer));
  } finally {
    rmSync(folder, { recursive: true });
  }
});
