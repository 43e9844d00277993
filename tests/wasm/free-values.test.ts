// What a free variable holds goes through the module bit for bit, whatever it is: NaN of any bits, infinity, −0, numbers
// below the normal ones.

import { describe, expect, test } from 'vitest';
import { reduce, reduceLevels, resumeReduction } from '../../wasm/index.ts';
import type { Mesh, ReduceOptions, Variable } from '../../wasm/types.ts';
import { bumpyPlate } from './bumpy-plate.ts';

/** Bits of NaN (quiet, signalling, negative, with a payload), of infinity, −0 and the smallest number. */
const odd64 = [
  0x7ff8_0000_0000_0000n,
  0x7ff8_0000_dead_beefn,
  0x7ff0_0000_0000_0001n,
  0xfff0_0000_1234_5678n,
  0xffff_ffff_ffff_ffffn,
  0x7ff0_0000_0000_0000n,
  0xfff0_0000_0000_0000n,
  0x8000_0000_0000_0000n,
  0x0000_0000_0000_0001n,
];
const odd32 = [
  0x7fc0_0000, 0x7fc0_beef, 0x7f80_0001, 0xff80_1234, 0xffff_ffff, 0x7f80_0000, 0xff80_0000, 0x8000_0000, 0x0000_0001,
];

const side = 20;
const points = (side + 1) ** 2;

/** Every value odd, so that those of the vertices that are kept are, too. */
function doubles(components: number): Variable {
  const bits = BigUint64Array.from({ length: points * components }, (_, i) => odd64[i % odd64.length]);
  return { name: 'doubles', components, values: new Float64Array(bits.buffer) };
}

function singles(components: number): Variable {
  const bits = Uint32Array.from({ length: points * components }, (_, i) => odd32[i % odd32.length]);
  return { name: 'singles', components, values: new Float32Array(bits.buffer) };
}

const plate = bumpyPlate(side);
const mesh: Mesh = {
  ...plate,
  variables: [doubles(1), singles(1), ...plate.variables, singles(3), doubles(2)].map((variable, i) => ({
    ...variable,
    name: `${variable.name} ${i}`,
  })),
};
const bounds: ReduceOptions['bounds'] = {
  position: { relative: 0.02 },
  'height 2': { relative: 0.05 },
  'flow 3': { relative: 0.05 },
};

function bitsOf({ values, components }: Variable, point: number): string {
  const size = components * values.BYTES_PER_ELEMENT;
  return Buffer.from(values.buffer, values.byteOffset + point * size, size).toString('hex');
}

function expectSameBits(reduced: Mesh, vertices: Uint32Array): void {
  for (const [i, variable] of mesh.variables.entries()) {
    const here = Array.from(vertices, (_, point) => bitsOf(reduced.variables[i], point));
    const there = Array.from(vertices, (point) => bitsOf(variable, point));
    expect(here, variable.name).toEqual(there);
  }
}

describe.each(['tracked', 'propagated'] as const)('with %s errors', (errors) => {
  test('a result has the bits of the original', async () => {
    const { mesh: reduced, vertices, report } = await reduce(mesh, { bounds, errors });
    expect(report.triangles.after).toBeLessThan(report.triangles.before / 2);
    expectSameBits(reduced, vertices);
  });

  test('and so have a checkpoint, what goes on from it, and levels', async () => {
    const { checkpoint } = await reduce(mesh, { bounds, errors, checkpoint: true });
    if (!checkpoint) throw new Error('There is no checkpoint.');
    expectSameBits(checkpoint.mesh, checkpoint.vertices);
    const onward = await resumeReduction(checkpoint, { bounds, errors });
    expectSameBits(onward.mesh, onward.vertices);
    const coarser = { position: { relative: 0.05 }, 'height 2': { relative: 0.1 }, 'flow 3': { relative: 0.1 } };
    const { levels } = await reduceLevels(mesh, { levels: [bounds, coarser], errors });
    expect(levels).toHaveLength(2);
    for (const level of levels) expectSameBits(level.mesh, level.vertices);
  });

  test('the rest is reduced as without them', async () => {
    const alone = await reduce(plate, {
      bounds: { position: { relative: 0.02 }, height: { relative: 0.05 }, flow: { relative: 0.05 } },
      errors,
    });
    const { mesh: reduced, vertices } = await reduce(mesh, { bounds, errors });
    expect(reduced.triangles).toEqual(alone.mesh.triangles);
    expect(vertices).toEqual(alone.vertices);
  });
});
