import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, test } from 'vitest';
import { reduce } from '../../wasm/index.ts';
import type { Mesh, Reduction } from '../../wasm/types.ts';
import { bumpyPlate } from './bumpy-plate.ts';

const program = 'build/native/tests/native_reduction';
const bounds = { position: { relative: 0.01 }, '*': { relative: 0.03 } };

type Precision = Float32ArrayConstructor | Float64ArrayConstructor;

/** The bumpy plate with one scalar variable, all in one precision, values that need it to their last digit. */
function plate(precision: Precision): Mesh {
  const { position, triangles } = bumpyPlate(60);
  const tilt = Array.from({ length: position.length / 3 }, (_, vertex) => {
    const [x = 0, y = 0] = position.subarray(3 * vertex);
    return Math.exp(x) * Math.sin(9 * y);
  });
  return {
    position: new precision(Array.from(position, (coordinate) => coordinate / 3)),
    triangles,
    variables: [{ name: 'tilt', components: 1, values: new precision(tilt) }],
  };
}

/** A binary PLY file, written here so that this test compares the two builds and nothing else. */
function toPly({ position, triangles, variables }: Mesh): Buffer {
  const vertices = position.length / 3;
  const faces = triangles.length / 3;
  const type = position instanceof Float32Array ? 'float' : 'double';
  const header = ['ply', 'format binary_little_endian 1.0', `element vertex ${vertices}`]
    .concat(['x', 'y', 'z', 'tilt'].map((name) => `property ${type} ${name}`))
    .concat([`element face ${faces}`, 'property list uchar uint vertex_indices', 'end_header', '']);

  const rows = new (position.constructor as Precision)(vertices * 4);
  for (let vertex = 0; vertex < vertices; vertex++) {
    rows.set(position.subarray(3 * vertex, 3 * vertex + 3), 4 * vertex);
    rows[4 * vertex + 3] = variables[0]?.values[vertex] as number;
  }
  const lists = Buffer.alloc(faces * 13);
  for (let face = 0; face < faces; face++) {
    lists.writeUInt8(3, 13 * face);
    Buffer.from(triangles.buffer, 12 * face, 12).copy(lists, 13 * face + 1);
  }
  return Buffer.concat([Buffer.from(header.join('\n')), Buffer.from(rows.buffer), lists]);
}

/** The bytes in the order of tests/wasm/native_reduction.cpp. */
function toBytes({ mesh, vertices, triangleErrors }: Reduction): Buffer {
  const values = mesh.variables.map((variable) => variable.values);
  const largest = triangleErrors.map((errors) => errors.largest);
  const arrays = [mesh.position, mesh.triangles, vertices, ...values, ...largest];
  return Buffer.concat(arrays.map((array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength)));
}

const cases = (['propagated', 'tracked'] as const).flatMap((errors) =>
  (['maximum', 'introduced'] as const).flatMap((cost) =>
    [Float32Array, Float64Array].map((precision) => ({ errors, cost, precision, name: precision.name })),
  ),
);

describe.skipIf(!existsSync(program))('the native and the WebAssembly build give the same bytes', () => {
  const folder = mkdtempSync(join(tmpdir(), 'meshbound-'));
  afterAll(() => rmSync(folder, { recursive: true }));

  test.each(cases)('errors $errors, cost $cost, $name', async ({ errors, cost, precision }) => {
    const mesh = plate(precision);
    const input = join(folder, 'plate.ply');
    const output = join(folder, 'reduced');
    writeFileSync(input, toPly(mesh));
    execFileSync(program, [input, output, errors, cost]);

    const reduction = await reduce(mesh, { bounds, errors, cost });
    expect(reduction.report.triangles.after).toBeLessThan(reduction.report.triangles.before / 2);
    // Compared as one value: a difference printed byte by byte tells nobody anything.
    expect(toBytes(reduction).equals(readFileSync(output))).toBe(true);
  });
});
