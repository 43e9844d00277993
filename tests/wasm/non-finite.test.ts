import { expect, test } from 'vitest';
import { inspect, reduce, reduceLevels } from '../../wasm/index.ts';
import type { Mesh, Variable } from '../../wasm/types.ts';
import { bumpyPlate } from './bumpy-plate.ts';

const plate = bumpyPlate(16);
const points = plate.position.length / 3;

/** Not-a-numbers with bits of their own, and infinities, between numbers. */
function holed(precision: 'single' | 'double'): Variable {
  const ordinary = Array.from({ length: points }, (_, point) => point / 7);
  if (precision === 'single') {
    const values = Float32Array.from(ordinary);
    const bits = new Uint32Array(values.buffer);
    for (let point = 0; point < points; point += 3) bits[point] = 0x7fc00001 + point;
    values[1] = Number.NEGATIVE_INFINITY;
    return { name: 'sst', components: 1, values };
  }
  const values = Float64Array.from(ordinary);
  const bits = new BigUint64Array(values.buffer);
  for (let point = 0; point < points; point += 3) bits[point] = 0x7ff8000000000001n + BigInt(point);
  values[1] = Number.POSITIVE_INFINITY;
  return { name: 'sst', components: 1, values };
}

function bitsOf({ values }: Variable): Uint32Array {
  return new Uint32Array(values.slice().buffer);
}

const bounds = { '*': { relative: 0.05 }, sst: 'free' } as const;

test.each(['single', 'double'] as const)(
  'what is free goes through bit for bit, in %s precision',
  async (precision) => {
    const variable = holed(precision);
    const mesh: Mesh = { ...plate, variables: [...plate.variables, variable] };
    const { mesh: reduced, vertices, report } = await reduce(mesh, { bounds });
    const width = precision === 'single' ? 1 : 2;
    const before = bitsOf(variable);
    const expected = Array.from(vertices).flatMap((vertex) => [
      ...before.subarray(width * vertex, width * (vertex + 1)),
    ]);
    expect([...bitsOf(reduced.variables[2])]).toEqual(expected);
    expect(report.variables[3]).toMatchObject({
      name: 'sst',
      error: Number.NaN,
      ratio: 0,
      bound: Number.POSITIVE_INFINITY,
    });
    expect(report.variables[3].nonFinite).toEqual({ vertices: Math.ceil(points / 3) + 1, first: 0 });
  },
);

test('it holds nothing back, and makes no other error unknown', async () => {
  const { mesh: without, report } = await reduce(plate, { bounds: { '*': { relative: 0.05 } } });
  const mesh: Mesh = { ...plate, variables: [...plate.variables, holed('double')] };
  const { mesh: reduced, report: reported } = await reduce(mesh, { bounds });
  expect(reduced.triangles).toEqual(without.triangles);
  expect(reported.variables.slice(0, 3).map(({ error }) => error)).toEqual(report.variables.map(({ error }) => error));
});

test('with a bound it is refused by name and point, whoever asks', async () => {
  const mesh: Mesh = { ...plate, variables: [...plate.variables, holed('double')] };
  const refused = { code: 'non_finite_value', variable: 'sst', index: 0 };
  const all = { '*': { relative: 0.05 } };
  await expect(reduce(mesh, { bounds: all })).rejects.toMatchObject(refused);
  await expect(reduceLevels(mesh, { levels: [bounds, { '*': { relative: 0.1 } }] })).rejects.toMatchObject(refused);
  expect((await inspect(mesh)).variables[3].nonFinite).toMatchObject({ first: 0 });
});
