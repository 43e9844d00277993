import { expect, test } from 'vitest';
import { mustSkip } from '../skipping.ts';
import { compiler, count, modes, obstacle, readStored } from './instructions.ts';

/**
 * How far a count may rise above the stored one, or fall below it before it is worth storing anew. Small changes elsewhere
 * (the C library, the order of the linked files) move it by less than one percent.
 */
const slack = 0.05;

const renewal = 'npm run bench:renew';

/** Why the counts cannot be compared; nothing where they can. */
function incomparable(): string | undefined {
  const reason = obstacle();
  if (reason) return reason;
  const stored = readStored().compiler;
  const here = compiler();
  if (here === stored) return undefined;
  return `the stored counts are of another compiler ("${stored}"; here "${here}")`;
}

const missing = incomparable();
if (missing) console.warn(`instructions not compared: ${missing}`);

test.skipIf(mustSkip(missing)).for(modes)(
  'a reduction with %s errors takes no more instructions than it did',
  (mode) => {
    const before = readStored().counts[mode];
    const now = count(mode);
    const ratio = now.instructions / before.instructions;
    const comparison = `${mode}: ${now.instructions} instructions, ${ratio.toFixed(3)} of the ${before.instructions} stored`;
    if (ratio < 1 - slack) console.warn(`${comparison}. Store the new count: ${renewal}`);
    expect(ratio, `${comparison}. Where that is meant: ${renewal}`).toBeLessThanOrEqual(1 + slack);
    // Else the run does other work, and its instructions say nothing.
    expect(now.triangles, `triangles left. Where that is meant: ${renewal}`).toBe(before.triangles);
  },
);
