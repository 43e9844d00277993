import { expect, test } from 'vitest';
import { inspect, reduce, reduceLevels, resumeReduction } from '../../wasm/index.ts';
import type { Mesh, VariableKind } from '../../wasm/types.ts';
import { bumpyPlate } from './bumpy-plate.ts';

/** A plate whose points have numbers of their own. */
function numbered(kind: VariableKind | undefined): Mesh {
  const plate = bumpyPlate(16);
  const points = plate.position.length / 3;
  const values = Float32Array.from({ length: points }, (_, point) => (point * 7919) % points);
  return { ...plate, variables: [...plate.variables, { name: 'ids', components: 1, values, kind }] };
}

const bounds = { '*': { relative: 0.05 } };

test('a bound for all variables is not about an identifier, which stays one', async () => {
  const { mesh, report, checkpoint } = await reduce(numbered('identifier'), { bounds, checkpoint: true });
  expect(report.variables.map(({ kind }) => kind)).toEqual([undefined, undefined, undefined, 'identifier']);
  expect(report.variables[3]).toMatchObject({ bound: Number.POSITIVE_INFINITY, ratio: 0, refused: 0 });
  expect(mesh.variables.map(({ kind }) => kind)).toEqual([undefined, undefined, 'identifier']);

  const quantity = await reduce(numbered('quantity'), { bounds });
  expect(quantity.report.variables[3].bound).toBeGreaterThan(0);
  expect(quantity.report.triangles.after).toBeGreaterThan(report.triangles.after);

  if (!checkpoint) throw new Error('A checkpoint was asked for.');
  const onward = await resumeReduction(checkpoint, { bounds: { '*': { relative: 0.1 } } });
  expect(onward.report.variables[3]).toMatchObject({ kind: 'identifier', bound: Number.POSITIVE_INFINITY });
});

test('its own name bounds it', async () => {
  const named = await reduce(numbered('identifier'), { bounds: { ...bounds, ids: { absolute: 3 } } });
  expect(named.report.variables[3]).toMatchObject({ kind: 'identifier', bound: 3 });
});

test('levels and inspection know it', async () => {
  const mesh = numbered('identifier');
  const { levels } = await reduceLevels(mesh, { levels: [bounds, { '*': { relative: 0.1 } }] });
  for (const { report } of levels) expect(report.variables[3].kind).toBe('identifier');
  const { variables } = await inspect(mesh);
  expect(variables.map(({ kind }) => kind)).toEqual([undefined, undefined, undefined, 'identifier']);
});

test('another kind is a TypeError', async () => {
  await expect(reduce(numbered('id' as VariableKind), { bounds })).rejects.toThrow(
    new TypeError(`The kind of “ids” must be 'quantity' or 'identifier'.`),
  );
});
