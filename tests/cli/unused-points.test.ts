// Points of no triangle count for nothing, whatever stands there, and every command says that there are some.

import { beforeAll, describe, expect, test } from 'vitest';
import type { Mesh } from '../../wasm/types.ts';
import { Folder } from './command.ts';
import { engine } from './engine.ts';

const folder = new Folder();
const all = ['-b', 'position=1%', '-b', '*=3%'];

/** The engine behind two points that only a triangle without three points names, or none: far away or nowhere. */
function withStray(place: number): Mesh {
  const { position, triangles, variables } = engine();
  return {
    position: Float64Array.of(place, 0, 0, place, place, 1, ...position),
    triangles: Uint32Array.of(1, 1, 2, ...triangles.map((corner) => corner + 2)),
    variables: variables.map((variable) => ({
      ...variable,
      values: Float64Array.of(...Array(2 * variable.components).fill(place), ...variable.values),
    })),
  };
}

beforeAll(async () => {
  await folder.save('engine.vtp', engine());
  await folder.save('far.vtp', withStray(1e6));
  await folder.save('nowhere.vtp', withStray(Number.NaN));
});

describe.each(['far.vtp', 'nowhere.vtp'])('%s', (file) => {
  test('inspect counts them, and measures without them', async () => {
    const { stdout } = await folder.run('inspect', file);
    expect(stdout).toMatch(/that no triangle uses +2$/m);
    expect(stdout).not.toContain('NaN or infinity (');
    const { variables } = JSON.parse((await folder.run('inspect', '--json', file)).stdout);
    const expected = JSON.parse((await folder.run('inspect', '--json', 'engine.vtp')).stdout).variables;
    const measured = ({ extent, range, nan }: { extent: number; range: unknown; nan: number }) => [extent, range, nan];
    expect(variables.map(measured)).toEqual(expected.map(measured));
  });

  test('reduce gives what it gives without them, and says so', async () => {
    const { status, stderr } = await folder.run('reduce', file, '-o', 'out.vtp', '--report', 'report.json', ...all);
    expect(status).toBe(0);
    expect(stderr).toContain(`${file}: 2 vertices belong to no triangle: left out of the result.`);
    await folder.run('reduce', 'engine.vtp', '-o', 'expected.vtp', '--report', 'expected.json', ...all);
    const [{ mesh }, expected] = [await folder.read('out.vtp'), await folder.read('expected.vtp')];
    expect(mesh.triangles).toEqual(expected.mesh.triangles);
    const bounds = (name: string) =>
      JSON.parse(folder.text(name)).variables.map(({ bound }: { bound: number }) => bound);
    expect(bounds('report.json')).toEqual(bounds('expected.json'));
  });

  test('verify measures the same bounds, and says that nothing is compared there', async () => {
    await folder.run('reduce', 'engine.vtp', '-o', 'small.vtp', ...all);
    const { status, stdout, stderr } = await folder.run('verify', file, 'small.vtp', ...all);
    expect(status).toBe(0);
    expect(stderr).toBe(`${file}: 2 vertices belong to no triangle: nothing is compared there.\n`);
    expect(stdout).toContain((await folder.run('verify', 'engine.vtp', 'small.vtp', ...all)).stdout.split('\n')[0]);
  });

  test('convert keeps them, or says that the format has no place for them', async () => {
    const { position } = (await folder.read(file)).mesh;
    for (const output of ['out.ply', 'out.vtk', 'out.vtp', 'out.obj']) {
      expect(await folder.run('convert', file, output), output).toMatchObject({ status: 0 });
      expect((await folder.read(output)).mesh.position, output).toEqual(position);
    }
  });
});

test('STL has no place for points without a triangle, which is said, and asks nothing of them', async () => {
  const { position, triangles } = engine();
  const mesh: Mesh = { position: Float32Array.of(...position, Number.NaN, 0, 0), triangles, variables: [] };
  await folder.save('point.ply', mesh);
  const { status, stderr } = await folder.run('convert', 'point.ply', 'out.stl');
  expect({ status, stderr }).toEqual({ status: 0, stderr: 'out.stl: STL has no place for 1 point of no triangle.\n' });
});
