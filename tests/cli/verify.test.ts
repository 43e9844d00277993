import { beforeAll, describe, expect, test } from 'vitest';
import type { Mesh, Variable } from '../../wasm/types.ts';
import { Folder } from './command.ts';
import { engine } from './engine.ts';

const folder = new Folder();
const bounds = ['-b', 'position=1%', '-b', '*=3%'];
let reduced: Mesh;

beforeAll(async () => {
  await folder.save('engine.vtp', engine());
  await folder.run('reduce', 'engine.vtp', '-o', 'small.vtp', ...bounds);
  reduced = (await folder.read('small.vtp')).mesh;
});

function changed(values: Variable['values'], at: number, by: number): Variable['values'] {
  return values.with(at, values[at] + by);
}

function withPressure(values: Variable['values']): Mesh {
  const [pressure, ...others] = reduced.variables;
  return { ...reduced, variables: [{ ...pressure, values }, ...others] };
}

async function verdict(name: string, ...args: string[]) {
  const { status, stdout } = await folder.run('verify', 'engine.vtp', name, '--json', ...args);
  return { status, ...JSON.parse(stdout) };
}

test('what was reduced passes, in both directions and along the boundary', async () => {
  const { status, stdout, stderr } = await folder.run('verify', 'engine.vtp', 'small.vtp', ...bounds);
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  expect(stdout).toContain('The bounds hold at every sample.');
  for (const row of ['original to reduced', 'reduced to original', 'boundary, original to reduced']) {
    expect(stdout).toMatch(new RegExp(`^ *${row} +[\\d ]+ +[01]\\.\\d+`, 'm'));
  }
});

test('--json has the documented shape', async () => {
  const finding = {
    ratio: expect.any(Number),
    variable: expect.stringMatching(/^(position|pressure|velocity|temperature)$/),
    position: [expect.any(Number), expect.any(Number), expect.any(Number)],
    samples: expect.any(Number),
  };
  const both = { fromOriginal: finding, fromReduced: finding };
  const found = await verdict('small.vtp', ...bounds);
  expect(found).toEqual({
    status: 0,
    original: 'engine.vtp',
    reduced: 'small.vtp',
    bounds: ['position', 'pressure', 'velocity', 'temperature'].map((name) => ({ name, bound: expect.any(Number) })),
    boundMultiplier: null,
    ratio: expect.any(Number),
    surface: both,
    boundary: both,
    within: true,
  });
  // Within, and not by far: the reduction uses what it is allowed.
  expect(found.ratio).toBeGreaterThan(0.5);
});

test('a surface is itself', async () => {
  expect(await verdict('engine.vtp', '-b', '*=1e-9')).toMatchObject({ status: 0, ratio: 0 });
});

describe('a broken bound is found, with status 1, the variable and the place', () => {
  test('of the geometry: a vertex lifted by a tenth', async () => {
    const position = changed(reduced.position, 2, 0.1);
    await folder.save('lifted.vtp', { ...reduced, position });
    const found = await verdict('lifted.vtp', '-b', 'position=0.05');
    expect(found).toMatchObject({ status: 1, within: false });
    expect(found.surface.fromReduced).toMatchObject({ variable: 'position', position: [...position.slice(0, 3)] });
    expect(found.surface.fromReduced.ratio).toBeGreaterThan(1);
    expect(found.surface.fromReduced.ratio).toBeLessThanOrEqual(2 + 1e-6);
  });

  test('of a variable: one value changed by more than its bound', async () => {
    await folder.save('wrong.vtp', withPressure(changed(reduced.variables[0].values, 5, 0.2)));
    const args = ['-b', 'position=0.001', '-b', 'pressure=0.02'];
    const found = await verdict('wrong.vtp', ...args, '-b', 'velocity=9');
    expect(found.status).toBe(1);
    const { status, stdout } = await folder.run('verify', 'engine.vtp', 'wrong.vtp', ...args);
    expect(status).toBe(1);
    expect(stdout).toContain('A bound is broken.');
  });

  test('of the surface: a triangle is missing', async () => {
    await folder.save('hole.vtp', { ...reduced, triangles: reduced.triangles.slice(3) });
    const found = await verdict('hole.vtp', ...bounds);
    expect(found.status).toBe(1);
    expect(found.surface.fromOriginal.ratio).toBeGreaterThan(1);
    expect(found.boundary.fromReduced.ratio).toBeGreaterThan(1);
  });

  test('by bounds tighter than those that were asked for', async () => {
    expect(await verdict('small.vtp', '-b', 'position=0.1%')).toMatchObject({ status: 1 });
  });
});

test('what is free is not looked at, and need not be there', async () => {
  const [pressure] = reduced.variables;
  const wild = withPressure(pressure.values.map((value) => value + 99)).variables[0];
  await folder.save('wild.vtp', { ...reduced, variables: [wild] });
  const { status, stderr } = await folder.run('verify', 'engine.vtp', 'wild.vtp', '-b', 'position=1%');
  expect(status).toBe(0);
  expect(stderr).toContain('No bound was given for “pressure”, “velocity”, “temperature”');
});

test('percentages are of the original’s extents, those of a constant of its magnitude', async () => {
  const mesh = engine(4);
  const constant = { name: 'density', components: 1, values: new Float32Array(mesh.position.length / 3).fill(5) };
  await folder.save('constant.vtp', { ...mesh, variables: [constant] });
  const outcome = await folder.run('verify', 'constant.vtp', 'constant.vtp', '--json', '-b', '*=10%');
  const [position, density] = JSON.parse(outcome.stdout).bounds;
  expect(position.bound).toBeCloseTo(0.1 * Math.hypot(1, 1, 0.19), 2);
  expect(density).toEqual({ name: 'density', bound: 0.5 });
});

test('a variable with other components cannot be compared', async () => {
  const [, velocity] = reduced.variables;
  const flat = { ...velocity, components: 1, values: velocity.values.slice(0, reduced.position.length / 3) };
  await folder.save('flat.vtp', { ...reduced, variables: [flat] });
  const outcome = await folder.run('verify', 'engine.vtp', 'flat.vtp', '-b', 'velocity=3%');
  expect(outcome).toMatchObject({ status: 2, stdout: '' });
  expect(outcome.stderr).toContain('flat.vtp: “velocity” has 1 component, that of the original 3');
});

describe('with --bound-multiplier, bounds hold as the variable multiplies them', () => {
  const focused = [...bounds, '-b', 'sharp=free'];

  /** The engine with a multiplier: a twentieth on one side of it. */
  function sharpened(): Mesh {
    const mesh = engine();
    const values = Float32Array.from({ length: mesh.position.length / 3 }, (_, i) =>
      mesh.position[3 * i] < 0.5 ? 0.05 : 1,
    );
    return { ...mesh, variables: [...mesh.variables, { name: 'sharp', components: 1, values }] };
  }

  beforeAll(() => folder.save('sharp.vtp', sharpened()));

  test('what was reduced so passes', async () => {
    await folder.run('reduce', 'sharp.vtp', '-o', 'focused.vtp', ...focused, '--bound-multiplier', 'sharp');
    const outcome = await folder.run('verify', 'sharp.vtp', 'focused.vtp', ...focused, '--bound-multiplier', 'sharp');
    expect(outcome).toMatchObject({ status: 0, stderr: '' });
    expect(outcome.stdout).toContain('each multiplied by sharp');
    const json = await folder.run(
      'verify',
      'sharp.vtp',
      'focused.vtp',
      '--json',
      ...focused,
      '--bound-multiplier',
      'sharp',
    );
    const found = JSON.parse(json.stdout);
    expect(found.boundMultiplier).toBe('sharp');
    expect(found.ratio).toBeGreaterThan(0.5);
  });

  test('what was reduced without does not', async () => {
    const plain = await folder.run('verify', 'sharp.vtp', 'small.vtp', ...focused);
    expect(plain.status).toBe(0);
    const found = await folder.run(
      'verify',
      'sharp.vtp',
      'small.vtp',
      '--json',
      ...focused,
      '--bound-multiplier',
      'sharp',
    );
    expect(found.status).toBe(1);
    const { surface } = JSON.parse(found.stdout);
    expect(surface.fromOriginal.position[0]).toBeLessThan(0.6);
  });

  test('what cannot multiply is refused', async () => {
    const fault = (name: string, file = 'sharp.vtp') =>
      folder.run('verify', file, 'small.vtp', '-b', 'position=1%', '--bound-multiplier', name);
    expect(await fault('shrap')).toMatchObject({ status: 2, stdout: '' });
    expect((await fault('shrap')).stderr).toContain('sharp.vtp: there is no variable “shrap” to multiply the bounds');
    expect((await fault('velocity')).stderr).toContain('“velocity” has 3 components');
    const mesh = sharpened();
    mesh.variables[3].values[7] = 0;
    await folder.save('blunt.vtp', mesh);
    expect((await fault('sharp', 'blunt.vtp')).stderr).toContain('it is 0 at point 7');
  });
});

test('more samples are looked at when asked for, and --quiet leaves the status alone', async () => {
  const few = await verdict('small.vtp', ...bounds, '--samples', '2000');
  const many = await verdict('small.vtp', ...bounds, '--samples', '20000');
  expect(many.surface.fromOriginal.samples).toBeGreaterThan(3 * few.surface.fromOriginal.samples);
  const quiet = await folder.run('verify', 'engine.vtp', 'small.vtp', '-b', '*=0.01%', '--quiet');
  expect(quiet).toMatchObject({ status: 1, stdout: '', stderr: '' });
});

test.each([
  ['thrice, facing the same way', 3, false],
  ['twice, once each way', 2, true],
])('the rim of a sheet whose every triangle is there %s is found in the result', async (_, times, other) => {
  const points = Array.from({ length: 81 }, (__, i) => [Math.floor(i / 9), i % 9, Math.sin(i % 9) / 40]);
  const corners = Array.from({ length: 64 }, (__, i) => Math.floor(i / 8) * 9 + (i % 8));
  const once = corners.flatMap((i) => [i, i + 9, i + 10, i, i + 10, i + 1]);
  const back = other ? once.map((___, i) => once[i - (i % 3) + 2 - (i % 3)] as number) : once;
  const triangles = Uint32Array.from([once, ...Array.from({ length: times - 1 }, () => back)].flat());
  await folder.save('sheet.ply', { position: Float64Array.from(points.flat()), triangles, variables: [] });
  const bound = ['-b', 'position=1%'];
  expect(await folder.run('reduce', 'sheet.ply', '-o', 'sheet-out.ply', ...bound)).toMatchObject({ status: 0 });
  const { status, stdout } = await folder.run('verify', 'sheet.ply', 'sheet-out.ply', ...bound);
  expect(stdout).toContain('The bounds hold at every sample.');
  expect(stdout).not.toContain('nothing near');
  expect(stdout).not.toMatch(/boundary, original to reduced +0 /);
  expect(status).toBe(0);
});
