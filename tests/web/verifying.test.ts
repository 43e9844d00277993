// The page's verifying: what the judge says is said of the result that is shown, and of no other.
import { beforeAll, describe, expect, test, vi } from 'vitest';
import { reduce, verify } from '../../wasm/index.ts';
import type { Reduction, Verdict, VerifyOptions } from '../../wasm/types.ts';
import { notVerified, Verifying } from '../../web/session/verifying.ts';
import { bumpyPlate } from '../wasm/bumpy-plate.ts';

const mesh = bumpyPlate(20);
let result: Reduction;
let other: Reduction;

beforeAll(async () => {
  result = await reduce(mesh, { bounds: { '*': { relative: 0.02 } } });
  other = await reduce(mesh, { bounds: { '*': { relative: 0.05 } } });
});

const verdict = { withinBounds: true } as Verdict;

/** A judge who answers when told to. */
function patientJudge() {
  const asked: { options: VerifyOptions; answer: (verdict: Verdict) => void; fail: (error: unknown) => void }[] = [];
  const judge = (_: unknown, __: unknown, options: VerifyOptions) =>
    new Promise<Verdict>((answer, fail) => asked.push({ options, answer, fail }));
  return { asked, judge };
}

test('asks the judge for the bounds of the report, and says what he found', async () => {
  const verifying = new Verifying(verify);
  const steps: (number | null)[] = [];
  verifying.addEventListener('change', () => steps.push(verifying.state.progress));
  verifying.follow(mesh, result, false);
  await verifying.start();
  expect(verifying.state).toMatchObject({ progress: null, fault: null, verdict: { withinBounds: true } });
  expect(steps.length).toBeGreaterThan(3);
});

test('gives the judge what multiplies the bounds', async () => {
  const { asked, judge } = patientJudge();
  const verifying = new Verifying(judge);
  const multiplier = new Float32Array(mesh.position.length / 3).fill(0.5);
  verifying.follow(mesh, { ...result, multiplier }, false);
  void verifying.start();
  expect(asked[0].options.multipliers).toEqual(Float64Array.from(multiplier));
});

test('finds a result broken that is not what its report says', async () => {
  const verifying = new Verifying(verify);
  verifying.follow(mesh, { ...other, report: result.report }, false);
  await verifying.start();
  expect(verifying.state.verdict?.withinBounds).toBe(false);
});

describe('a verdict is of one result', () => {
  test('another result has none', async () => {
    const { asked, judge } = patientJudge();
    const verifying = new Verifying(judge);
    verifying.follow(mesh, result, false);
    const running = verifying.start();
    asked[0].answer(verdict);
    await running;
    expect(verifying.state.verdict).toBe(verdict);
    verifying.follow(mesh, result, true);
    expect(verifying.state.verdict).toBe(verdict);
    verifying.follow(mesh, other, false);
    expect(verifying.state).toBe(notVerified);
  });

  test.each([
    ['another result comes', () => other, false],
    ['a reduction begins', () => result, true],
  ])('the judge stops where %s, and what he says is not told', async (_, next, busy) => {
    const { asked, judge } = patientJudge();
    const verifying = new Verifying(judge);
    verifying.follow(mesh, result, false);
    const running = verifying.start();
    verifying.follow(mesh, next(), busy);
    expect(asked[0].options.signal?.aborted).toBe(true);
    asked[0].options.onProgress?.(0.7);
    asked[0].answer(verdict);
    await running;
    expect(verifying.state).toBe(notVerified);
  });
});

test('is cancelled', async () => {
  const { asked, judge } = patientJudge();
  const verifying = new Verifying(judge);
  verifying.follow(mesh, result, false);
  const running = verifying.start();
  verifying.cancel();
  asked[0].fail(new DOMException('', 'AbortError'));
  await running;
  expect(verifying.state).toBe(notVerified);
});

test('says why there is no verdict', async () => {
  const { asked, judge } = patientJudge();
  const verifying = new Verifying(judge);
  verifying.follow(mesh, result, false);
  const running = verifying.start();
  asked[0].fail(new Error('There is no memory left.'));
  await running;
  expect(verifying.state).toEqual({ ...notVerified, fault: 'There is no memory left.' });
});

test('does nothing where there is nothing to judge', async () => {
  const judge = vi.fn();
  const verifying = new Verifying(judge);
  await verifying.start();
  expect(judge).not.toHaveBeenCalled();
  expect(verifying.state).toBe(notVerified);
});
