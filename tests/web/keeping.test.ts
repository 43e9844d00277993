// What of a surface is kept: as attributes say it, as the core is told, and what comes back.
import { describe, expect, test } from 'vitest';
import { reduce, reduceLevels } from '../../wasm/index.ts';
import { keepingFrom, keepingText } from '../../web/element/attributes/keeping-attributes.ts';
import { type Keeping, nothingKept } from '../../web/session/constraints/keeping.ts';
import { firstMethod } from '../../web/session/constraints/method.ts';
import type { OpenSurface } from '../../web/session/reading/open-surface.ts';
import { levelsOf, resultOf, taskOf } from '../../web/session/reducing/task.ts';

const side = 24;

/** A wavy sheet with a variable, a multiplier that falls from left to right, and two regions. */
function waves(): OpenSurface {
  const grid = Array.from({ length: side * side }, (_, i) => [
    (i % side) / (side - 1),
    Math.floor(i / side) / (side - 1),
  ]);
  const corners = grid.flatMap((_, i) =>
    i % side < side - 1 && i + side < side * side ? [i, i + 1, i + side + 1, i, i + side + 1, i + side] : [],
  );
  const variable = (name: string, value: (x: number, y: number) => number) => ({
    name,
    components: 1,
    values: Float64Array.from(grid, ([x, y]) => value(x, y)),
  });
  const mesh = {
    position: Float64Array.from(grid.flatMap(([x, y]) => [x, y, 0.1 * Math.sin(7 * x) * Math.cos(5 * y)])),
    triangles: Uint32Array.from(corners),
    variables: [variable('heat', (x, y) => Math.sin(9 * x + 4 * y)), variable('sharpness', (x) => 1.2 - x)],
  };
  const regions = new Map([
    ['part', Int32Array.from({ length: corners.length / 3 }, (_, i) => (corners[3 * i] % side < 9 ? 4 : 7))],
  ]);
  const variables = ['position', 'heat', 'sharpness'].map((name) => ({
    name,
    components: 1,
    extent: 1,
    magnitude: 1,
    constant: false,
  }));
  return {
    name: 'waves',
    address: null,
    labels: { units: {}, componentNames: {} },
    locked: undefined,
    mesh,
    regions,
    variables,
  };
}

const surface = waves();
const bounds = { position: { relative: 0.02 }, heat: { relative: 0.05 } };
const asked = (keeping: Partial<Keeping>) => taskOf(surface, firstMethod, { ...nothingKept, ...keeping });

async function reduced(keeping: Partial<Keeping>) {
  const task = asked(keeping);
  return resultOf(task, await reduce(task.mesh, { bounds, ...task.options }));
}

describe('attributes', () => {
  const keeping: Keeping = {
    lockPoints: [
      [3, 3],
      [20, 40],
    ],
    lockBox: { lowest: [0, -1, 2e-3], highest: [1, 1, 3] },
    regions: 'part, "two"',
    lockRegions: [4, -7],
    boundMultiplier: 'sharpness',
    focusPoint: { point: [1, 2, -0.5], radius: 0.25, factor: 0.1 },
  };

  test('say what is kept', () => {
    expect(keepingFrom(keepingText(keeping))).toEqual(keeping);
    expect(keepingFrom(keepingText(nothingKept))).toEqual(nothingKept);
  });

  test('say points as the command line does', () => {
    const lockPoints = '3,17,20-40';
    expect(keepingText(keepingFrom({ ...keepingText(nothingKept), lockPoints: ' 3, 17,20-40' }))).toMatchObject({
      lockPoints,
    });
  });

  test.each([
    ['lockPoints', '3,x', 'lock-points cannot be “3,x”: “x” is no point and no range of points.'],
    ['lockPoints', '9-3', '“9-3” is no point'],
    ['lockPoints', '3,', '“” is no point'],
    ['lockPoints', '-1', '“-1” is no point'],
    ['lockPoints', '1.5', '“1.5” is no point'],
    ['lockPoints', '0-4294967295', '“0-4294967295” is no point'],
    ['lockBox', '0,0,0,1,1', 'lock-box cannot be “0,0,0,1,1”: a box has six numbers'],
    ['lockBox', '1,0,0,0,1,1', 'lock-box cannot be'],
    ['lockRegions', '1,x', 'lock-regions cannot be “1,x”: “x” is not the number of a region'],
    ['lockRegions', '1.5', 'lock-regions cannot be'],
    ['focusPoint', '0,0,0,1', 'focus-point cannot be “0,0,0,1”: a focus point has five numbers'],
    ['focusPoint', '0,0,0,0,0.5', 'radius'],
    ['focusPoint', '0,0,0,1,0', 'factor'],
    ['focusPoint', '0,0,0,1,2', 'factor'],
    ['focusPoint', '0,0,0,1,NaN', 'five numbers'],
  ])('refuse %s="%s"', (name, text, message) => {
    expect(() => keepingFrom({ ...keepingText(nothingKept), [name]: text })).toThrow(message);
  });
});

describe('what the core is told', () => {
  test('is the surface itself where nothing is kept', () => {
    expect(asked({}).mesh).toBe(surface.mesh);
  });

  test('locks points beside those that the surface itself needs', () => {
    const { options } = taskOf({ ...surface, locked: Uint32Array.of(7) }, firstMethod, {
      ...nothingKept,
      lockPoints: [
        [3, 3],
        [20, 22],
      ],
    });
    expect(options.locked).toEqual(Uint32Array.of(7, 3, 20, 21, 22));
  });

  test.each([side * side, 2 ** 32 - 2])('has no point %d that the surface has not', (last) => {
    expect(asked({ lockPoints: [[0, side * side - 1]] }).options.locked).toHaveLength(side * side);
    expect(() => asked({ lockPoints: [[3, last]] })).toThrow(
      expect.objectContaining({
        code: 'bad_option',
        message: `There is no point ${last} to lock: the surface has ${side * side}, counted from 0.`,
      }),
    );
  });

  test('parts the surface into regions, whose borders stay in place', async () => {
    const { mesh } = await reduced({ regions: 'part', lockRegions: [7] });
    const kept = mesh.regions?.filter((label) => label === 7).length;
    expect(kept).toBe(surface.regions?.get('part')?.filter((label) => label === 7).length);
    expect(new Set(mesh.regions)).toEqual(new Set([4, 7]));
    expect(mesh.triangles.length).toBeLessThan(surface.mesh.triangles.length);
  });

  test('has no regions that the surface has not', () => {
    expect(() => asked({ regions: 'other' })).toThrow(
      'no cell data “other” to part it into regions; those of whole numbers are “part”',
    );
  });
});

describe('a focus', () => {
  const point = { point: [0.5, 0.5, 0] as const, radius: 0.2, factor: 0.1 };

  test.each([
    ['a variable', { boundMultiplier: 'sharpness' }],
    ['a point', { focusPoint: point }],
    ['both', { boundMultiplier: 'sharpness', focusPoint: point }],
  ])('of %s leaves the surface’s variables, and its bounds hold times the multiplier', async (_, keeping) => {
    const { mesh, report, triangleErrors, vertexErrors = [], multiplier } = await reduced(keeping);
    for (const list of [report.variables, ['', ...mesh.variables], triangleErrors, vertexErrors])
      expect(list).toHaveLength(3);
    expect(mesh.variables.map(({ name }) => name)).toEqual(['heat', 'sharpness']);
    expect(multiplier).toHaveLength(side * side);
    const shares = [0, 1].map((index) =>
      Array.from(
        vertexErrors[index].error,
        (error, v) => error / report.variables[index].bound / (multiplier?.[v] ?? 0),
      ),
    );
    expect(Math.max(...shares.flat())).toBeLessThanOrEqual(1 + 2 ** -23);
    expect(Math.max(...shares.flat())).toBeGreaterThan(0.5);
  });

  test('of both is the product', () => {
    const [variable, near, both] = [
      { boundMultiplier: 'sharpness' },
      { focusPoint: point },
      { boundMultiplier: 'sharpness', focusPoint: point },
    ].map((keeping) => asked(keeping).multiplier ?? []);
    expect([...both]).toEqual(Array.from(near, (each, v) => each * variable[v]));
  });

  test('is none of the variables of levels and morphs', async () => {
    const task = asked({ focusPoint: point });
    const coarse = { position: { relative: 0.04 }, heat: { relative: 0.1 } };
    const { levels, morphs } = levelsOf(
      task,
      await reduceLevels(task.mesh, { levels: [bounds, coarse], morphs: true, ...task.options }),
    );
    for (const { mesh } of levels) expect(mesh.variables).toHaveLength(2);
    for (const { finer, coarser } of morphs) expect([finer.variables.length, coarser.variables.length]).toEqual([2, 2]);
  });

  test.each(['none', 'heat'])('that cannot multiply is refused by its name, %s', async (boundMultiplier) => {
    for (const focusPoint of [null, point])
      await expect(reduced({ boundMultiplier, focusPoint })).rejects.toThrow(`“${boundMultiplier}`);
  });
});
