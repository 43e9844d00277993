// Who waits for a reduction is told how it ends, whatever becomes of it.
import { expect, test } from 'vitest';
import type { Reduction } from '../../wasm/types.ts';
import { outcomeOf } from '../../web/element/result/outcome.ts';
import { Session } from '../../web/session/session.ts';
import { noDefects } from './no-defects.ts';

const mesh = { position: new Float32Array(9), triangles: new Uint32Array([0, 1, 2]), variables: [] };
const position = { name: 'position', components: 3, extent: 1, magnitude: 1, constant: false };

/** With a surface that is being reduced, until the test says how that ends. */
async function opened() {
  const runs: { finish: () => void; fail: (error: Error) => void }[] = [];
  const session = new Session({
    inspect: async () => ({ triangles: 1, vertices: 3, variables: [position], defects: noDefects }),
    reduce: (_, { signal }) =>
      new Promise((resolve, reject) => {
        signal?.addEventListener('abort', () => reject(new DOMException('aborted', 'AbortError')));
        runs.push({ finish: () => resolve({ mesh } as unknown as Reduction), fail: reject });
      }),
    resumeReduction: () => Promise.reject(new Error('There is no checkpoint.')),
    read: async () => ({ mesh, notes: [], labels: { units: {}, componentNames: {} } }),
    fetchBytes: async () => new Uint8Array(),
  });
  await session.openAddress('a.ply');
  return { session, runs };
}

const aborted = { name: 'AbortError', message: 'The reduction was aborted.' };

test('resolves to what was reduced', async () => {
  const { session, runs } = await opened();
  const outcome = outcomeOf(session);
  runs[0].finish();
  expect(await outcome).toMatchObject({ result: { mesh } });
  expect(await outcome).toBe(session.state.reduced);
});

test('waits for the reduction that takes the place of the one that ran', async () => {
  const { session, runs } = await opened();
  const outcome = outcomeOf(session);
  session.reduceAgain();
  runs[1].finish();
  expect(await outcome).toBe(session.state.reduced);
});

test('rejects with the reason where the reduction fails, also when there is an earlier one', async () => {
  const { session, runs } = await opened();
  runs[0].finish();
  await outcomeOf(session);
  session.reduceAgain();
  const outcome = outcomeOf(session);
  runs[1].fail(new Error('It is too large.'));
  await expect(outcome).rejects.toMatchObject({ name: 'Error', message: 'It is too large.' });
});

test.each([
  ['it is cancelled', (session: Session) => session.cancel()],
  ['the session stops', (session: Session) => session.stop()],
  ['another surface is opened', (session: Session) => session.openAddress('b.ply')],
])('rejects where %s', async (_, end) => {
  const { session } = await opened();
  const outcome = outcomeOf(session);
  await Promise.all([end(session), expect(outcome).rejects.toMatchObject(aborted)]);
});
