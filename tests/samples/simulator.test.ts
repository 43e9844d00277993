import { beforeAll, describe, expect, it } from 'vitest';

import { buildSimulator, simulate, type Volume } from '../../web/samples/simulate.ts';
import { exactShockTube, type State } from './exact-shock-tube.ts';

// Milliseconds that a busy machine may need.
const compiling = 120_000;
const running = 60_000;

beforeAll(buildSimulator, compiling);

function valuesOf(volume: Volume, name: string): Float32Array {
  const variable = volume.variables.find((candidate) => candidate.name === name);
  expect(variable, name).toBeDefined();
  return (variable as Volume['variables'][number]).values;
}

function bytesOf(volume: Volume): Buffer {
  return Buffer.concat(volume.variables.map(({ values }) => Buffer.from(values.slice().buffer)));
}

/** The mean distance from the exact solution, over the tube. */
function shockTubeError(cells: number, name: keyof State): number {
  const volume = simulate('shock-tube', [cells, 1, 1]);
  const errors = Array.from(valuesOf(volume, name), (value, i) => {
    const x = volume.origin[0] + i * volume.spacing;
    return Math.abs(value - exactShockTube((x - 0.5) / volume.end)[name]);
  });
  return errors.reduce((sum, error) => sum + error) / cells;
}

describe('shock tube', { timeout: running }, () => {
  // Waves between 0.1 and 1: these are a few thousandths of them.
  it.each([
    ['density', 0.0025],
    ['velocity', 0.005],
    ['pressure', 0.002],
  ] as const)('%s is within %f of the exact solution on 200 cells, on average', (name, limit) => {
    expect(shockTubeError(200, name)).toBeLessThan(limit);
  });

  it('comes nearer to the exact solution on finer grids', () => {
    // With a shock, the order of any scheme is at most 1 in the mean; the contact holds it a little below.
    expect(shockTubeError(400, 'density')).toBeLessThan(0.62 * shockTubeError(200, 'density'));
    expect(shockTubeError(400, 'pressure')).toBeLessThan(0.62 * shockTubeError(200, 'pressure'));
  });

  it('is the same along each axis', () => {
    const alongX = bytesOf(simulate('shock-tube', [100, 1, 1]));
    expect(bytesOf(simulate('shock-tube', [1, 100, 1])).equals(alongX)).toBe(true);
    expect(bytesOf(simulate('shock-tube', [1, 1, 100])).equals(alongX)).toBe(true);
  });
});

describe.each([
  ['fireballs', [42, 24, 15]],
  ['impact', [36, 16, 16]],
])('%s', { timeout: running }, (scene, cells) => {
  // Every cell rounds at 6e-8 of its content in every step, up and down alike.
  const rounding = 1e-6;

  it.each(['--walls', '--periodic'])('keeps mass, energy and each material with %s', (boundary) => {
    const { before, after, steps } = simulate(scene, cells, [boundary]);
    expect(steps).toBeGreaterThan(10);
    expect(Math.abs(after.mass / before.mass - 1)).toBeLessThan(rounding);
    expect(Math.abs(after.energy / before.energy - 1)).toBeLessThan(rounding);
    after.partialMass.forEach((mass, material) => {
      expect(before.partialMass[material]).toBeGreaterThan(0);
      expect(Math.abs(mass / before.partialMass[material] - 1)).toBeLessThan(rounding);
    });
  });

  it('gives the same bytes again, with any number of threads', () => {
    const one = bytesOf(simulate(scene, cells, ['--threads', '1']));
    for (const threads of ['1', '2', '3', '64']) {
      expect(bytesOf(simulate(scene, cells, ['--threads', threads])).equals(one)).toBe(true);
    }
  });
});

describe('bad arguments', () => {
  it.each([
    ['nonsense', [4, 4, 4], [], 'no scene "nonsense"'],
    ['fireballs', [0, 4, 4], [], 'not a number of cells'],
    ['fireballs', [4, 4, 4], ['--what'], 'argument "--what"'],
  ])('%s %j %j is refused with a reason', (scene, cells, options, reason) => {
    expect(() => simulate(scene, cells, options)).toThrow(reason);
  });
});
