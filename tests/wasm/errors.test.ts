import { describe, expect, test } from 'vitest';
import { type ErrorCode, MeshboundError, reduce } from '../../wasm/index.ts';
import type { Mesh, ReduceOptions, Variable } from '../../wasm/types.ts';
import { bumpyPlate } from './bumpy-plate.ts';

const bounds = { '*': { relative: 0.03 } };

interface FaultCase {
  what: string;
  code: ErrorCode;
  variable?: string;
  index?: number;
  spoil?: (mesh: Mesh) => void;
  options?: Partial<ReduceOptions>;
}

const height = (mesh: Mesh) => mesh.variables[0] as Variable;
const flow = (mesh: Mesh) => mesh.variables[1] as Variable;

const cases: FaultCase[] = [
  {
    what: 'no triangles',
    code: 'no_triangles',
    spoil: (mesh) => {
      mesh.triangles = new Uint32Array();
    },
  },
  {
    what: 'coordinates that are no triples',
    code: 'bad_coordinates',
    variable: 'position',
    spoil: (mesh) => {
      mesh.position = mesh.position.slice(0, -1);
    },
  },
  {
    what: 'an index out of range',
    code: 'bad_index',
    index: 7,
    spoil: (mesh) => {
      mesh.triangles[7 * 3 + 1] = 1000;
    },
  },
  {
    what: 'indices that are no triples',
    code: 'bad_index',
    index: 31,
    spoil: (mesh) => {
      mesh.triangles = mesh.triangles.slice(0, -1);
    },
  },
  {
    what: 'a position that is not a number',
    code: 'non_finite_position',
    variable: 'position',
    index: 4,
    spoil: (mesh) => {
      mesh.position[3 * 4 + 2] = Number.NaN;
    },
  },
  {
    what: 'a variable without components',
    code: 'bad_components',
    variable: 'height',
    spoil: (mesh) => {
      height(mesh).components = 0;
    },
  },
  {
    what: 'fewer values than vertices',
    code: 'wrong_value_count',
    variable: 'height',
    spoil: (mesh) => {
      height(mesh).values = height(mesh).values.slice(0, -1);
    },
  },
  {
    what: 'an infinite value',
    code: 'non_finite_value',
    variable: 'flow',
    index: 9,
    spoil: (mesh) => {
      flow(mesh).values[3 * 9 + 1] = Number.POSITIVE_INFINITY;
    },
  },
  {
    what: 'a variable without a name',
    code: 'empty_name',
    spoil: (mesh) => {
      height(mesh).name = '';
    },
  },
  {
    what: 'two variables of one name',
    code: 'duplicate_name',
    variable: 'flow',
    spoil: (mesh) => {
      height(mesh).name = 'flow';
    },
  },
  {
    what: 'a bound for an unknown variable',
    code: 'unknown_variable',
    variable: 'pressure',
    options: { bounds: { pressure: { relative: 0.1 } } },
  },
  { what: 'a bound of zero', code: 'bad_bound', variable: 'flow', options: { bounds: { flow: { relative: 0 } } } },
  { what: 'a negative bound', code: 'bad_bound', variable: 'flow', options: { bounds: { flow: { absolute: -1 } } } },
  {
    what: 'a bound that is not a number',
    code: 'bad_bound',
    variable: 'flow',
    options: { bounds: { flow: { relative: Number.NaN } } },
  },
  {
    what: 'a bound of another shape',
    code: 'bad_bound',
    variable: 'flow',
    options: { bounds: { flow: 0.03 } as unknown as ReduceOptions['bounds'] },
  },
  {
    what: 'a bound finer than double precision',
    code: 'bound_too_fine',
    variable: 'height',
    options: { bounds: { height: { absolute: 1e-300 } } },
  },
  { what: 'a locked vertex that does not exist', code: 'bad_option', options: { locked: Uint32Array.of(0, 1000) } },
  {
    what: 'a box turned inside out',
    code: 'bad_option',
    index: 0,
    options: { lockedBoxes: [{ lowest: [0, 0, 1], highest: [1, 1, 0] }] },
  },
  {
    what: 'a box without numbers',
    code: 'bad_option',
    index: 0,
    options: { lockedBoxes: [{ lowest: [0, 0] as never, highest: [1, 1, 0] }] },
  },
  {
    what: 'a multiplier that does not exist',
    code: 'unknown_variable',
    variable: 'near',
    options: { boundMultiplier: 'near' },
  },
  {
    what: 'a multiplier of three components',
    code: 'bad_option',
    variable: 'flow',
    options: { boundMultiplier: 'flow' },
  },
  {
    what: 'a limit to the feature size of a free position',
    code: 'bad_option',
    variable: 'position',
    options: { bounds: { flow: { relative: 0.1 } }, limitToFeatureSize: true },
  },
  {
    what: 'small parts to leave out beside a free position',
    code: 'bad_option',
    variable: 'position',
    options: { bounds: { '*': 'free' }, dropSmallComponents: true },
  },
  { what: 'an unknown option', code: 'bad_option', options: { cost: 'cheap' as ReduceOptions['cost'] } },
];

describe('what is at fault arrives as a typed error with its place', () => {
  test.each(cases)('$what', async ({ code, variable, index, spoil, options }) => {
    const mesh = bumpyPlate(4);
    spoil?.(mesh);
    const error = await reduce(mesh, { bounds, ...options }).then(
      () => undefined,
      (reason: unknown) => reason,
    );
    expect(error).toBeInstanceOf(MeshboundError);
    expect(error).toMatchObject({ code, ...(variable && { variable }), ...(index !== undefined && { index }) });
    expect((error as Error).message).toMatch(/^[A-Z].{10,}\.$/);
  });
});

test('arrays of another type are refused before anything is copied', async () => {
  const mesh = { ...bumpyPlate(4), triangles: [0, 1, 2] as unknown as Uint32Array };
  await expect(reduce(mesh, { bounds })).rejects.toThrow(new TypeError('The triangles must be a Uint32Array.'));
});

test('a fault leaves the module as good as before', async () => {
  await expect(reduce(bumpyPlate(4), { bounds: { x: 'free' } })).rejects.toBeInstanceOf(MeshboundError);
  await expect(reduce(bumpyPlate(4), { bounds })).resolves.toBeDefined();
});
