// A variable that holds NaN or infinity: with a bound it is refused by name, point and both ways out; free, it is carried
// along bit for bit, and nothing is said of its error that is not known.

import { beforeAll, describe, expect, test } from 'vitest';
import type { Mesh } from '../../wasm/types.ts';
import { Folder } from './command.ts';
import { engine } from './engine.ts';

const folder = new Folder();
const holes = [17, 40, 41];

/** Beside the engine's variables some of two components with NaN and infinity. */
function withHoles(): Mesh {
  const mesh = engine();
  const values = new Float64Array((2 * mesh.position.length) / 3).map((_, i) => Math.sin(i));
  values[2 * holes[0] + 1] = Number.NaN;
  values[2 * holes[1]] = Number.POSITIVE_INFINITY;
  values.fill(Number.NaN, 2 * holes[2], 2 * holes[2] + 2);
  return { ...mesh, variables: [{ name: 'sst', components: 2, values }, ...mesh.variables] };
}

const all = ['-b', 'position=1%', '-b', '*=3%'];
const waysOut = /--bound "sst=free".* --exclude "sst"/;

beforeAll(async () => {
  await folder.save('holes.vtp', withHoles());
  await folder.save('engine.vtp', engine());
});

test('inspect says where', async () => {
  const { stdout } = await folder.run('inspect', 'holes.vtp');
  expect(stdout).toContain('“sst” holds NaN or infinity (at 3 points, the first of which is 17)');
  expect(stdout).not.toContain('“pressure” holds');
  const { variables } = JSON.parse((await folder.run('inspect', '--json', 'holes.vtp')).stdout);
  expect(variables[1]).toMatchObject({ name: 'sst', nan: 3, infinite: 1, nonFinite: { vertices: 3, first: 17 } });
  expect(variables[2].nonFinite).toBe(null);
});

describe('with a bound, it is refused by variable, point and both ways out', () => {
  test.each([
    ['a result', ['reduce', 'holes.vtp', '-o', 'out.vtp', ...all]],
    ['levels', ['reduce', 'holes.vtp', '-o', 'out.vtp', '--levels', '1%,3%']],
    ['a bound of its own', ['reduce', 'holes.vtp', '-o', 'out.vtp', '-b', 'sst=0.1']],
    ['verify', ['verify', 'holes.vtp', 'holes.vtp', ...all]],
  ])('%s', async (_, args) => {
    const { status, stderr } = await folder.run(...args);
    expect(status).toBe(2);
    expect(stderr).toMatch(/holes\.vtp: .*“sst” is not a number at (vertex|point) 17; so it can have no bound\./);
    expect(stderr).toMatch(waysOut);
  });
});

test.each([
  ['free', ['-b', 'sst=free'], ['sst', 'pressure', 'velocity', 'temperature']],
  ['left out', ['--exclude', 'sst'], ['pressure', 'velocity', 'temperature']],
])('%s, it goes through, verify too, and the rest is as without it', async (_, way, names) => {
  const reduced = await folder.run('reduce', 'holes.vtp', '-o', 'out.vtp', ...all, ...way);
  expect(reduced).toMatchObject({ status: 0, stderr: '' });
  const { mesh } = await folder.read('out.vtp');
  expect(mesh.variables.map(({ name }) => name)).toEqual(names);
  await folder.run('reduce', 'engine.vtp', '-o', 'expected.vtp', ...all);
  expect(mesh.triangles).toEqual((await folder.read('expected.vtp')).mesh.triangles);
  expect(await folder.run('verify', 'holes.vtp', 'out.vtp', ...all, ...way)).toMatchObject({ status: 0, stderr: '' });
});

test('its error is not known, in the table and in the report, of levels too', async () => {
  const free = [...all, '-b', 'sst=free'];
  const { stdout } = await folder.run('reduce', 'holes.vtp', '-o', 'out.vtp', '--report', 'report.json', ...free);
  expect(stdout).toMatch(/^ *sst +free +not known$/m);
  const known = { name: 'sst', bound: null, error: null, ratio: null, nonFinite: { vertices: 3, first: 17 } };
  expect(JSON.parse(folder.text('report.json')).variables[1]).toMatchObject(known);
  const levels = ['--levels', '3%,9%', '-b', 'sst=free', '--report', 'levels.json'];
  expect(await folder.run('reduce', 'holes.vtp', '-o', 'out.vtp', ...levels)).toMatchObject({ status: 0 });
  for (const level of JSON.parse(folder.text('levels.json')).levels) expect(level.variables[1]).toMatchObject(known);
});
