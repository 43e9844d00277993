// The numbers in docs/evaluation.md are those of the code, more or less. Where they are not: npm run evaluate.
import { existsSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';

import { reduce } from '../../wasm/index.ts';
import { readPly } from '../../web/formats/ply/read-ply.ts';
import { mustSkip } from '../skipping.ts';

const sample = 'build/samples/fireballs.ply';

/** A step forward in the core need not repeat the evaluation at once; what is farther off misleads. */
const tolerance = 0.05;

const missing = existsSync(sample) ? undefined : 'the samples are missing';

test.skipIf(mustSkip(missing))('docs/evaluation.md says what the fireballs keep at 3 %', async () => {
  const { mesh } = readPly(readFileSync(sample));
  const left = async (errors: 'propagated' | 'tracked') => {
    const { report } = await reduce(mesh, { bounds: { '*': { relative: 0.03 } }, errors });
    return report.triangles.after;
  };
  const row = /^\| fireballs \| \d+ \| 3 % .* \| (\d+) \([\d.]+ %\) \| (\d+) \(/m;
  const [, propagated, tracked] = row.exec(readFileSync('docs/evaluation.md', 'utf8'))?.map(Number) ?? [];
  expect(Math.abs(propagated / (await left('propagated')) - 1)).toBeLessThan(tolerance);
  expect(Math.abs(tracked / (await left('tracked')) - 1)).toBeLessThan(tolerance);
});
