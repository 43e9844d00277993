import { expect, test } from 'vitest';
import { createCancelFlag, isRaised, raise } from '../../wasm/cancel-flag.ts';
import { loadCore } from '../../wasm/load-core.ts';
import type { Outcome } from '../../wasm/tasks.ts';
import { transferables } from '../../wasm/transferables.ts';
import { bumpyPlate } from './bumpy-plate.ts';

function unwrap<Value>(outcome: Outcome<Value>): Value {
  if (!outcome.ok) throw new Error(outcome.failure.message);
  return outcome.value;
}

test('a reduction stops where it is told not to go on, and what it has is valid', async () => {
  const core = await loadCore();
  const mesh = bumpyPlate(100);
  let calls = 0;
  const goOn = () => ++calls < 3;
  const stopped = unwrap(core.reduce(mesh, { bounds: { '*': { relative: 0.03 } } }, goOn));
  const finished = unwrap(core.reduce(mesh, { bounds: { '*': { relative: 0.03 } } }, () => true));
  expect(calls).toBe(3);
  expect(stopped.report.termination).toBe('cancelled');
  expect(stopped.report.triangles.after).toBeGreaterThan(finished.report.triangles.after);
  expect(stopped.mesh.triangles.every((vertex) => vertex < stopped.report.vertices.after)).toBe(true);
});

test('a raised flag is seen through every copy of it', () => {
  const flag = createCancelFlag();
  if (!flag) throw new Error('Node shares memory.');
  const copy = structuredClone(flag);
  expect(isRaised(copy)).toBe(false);
  raise(flag);
  expect(isRaised(copy)).toBe(true);
});

test('every array of a message is moved, once, except those on shared memory', () => {
  const values = new Float32Array(4);
  const shared = new Int32Array(new SharedArrayBuffer(4));
  const message = { a: values, b: [{ c: values.subarray(1) }, new Uint32Array(2)], d: shared, e: 'text', f: null };
  expect(transferables(message)).toEqual([values.buffer, message.b[1] && (message.b[1] as Uint32Array).buffer]);
});
