/** Counts the instructions of the fixed small run anew and keeps them as those to compare with: npm run bench:renew */
import { execFileSync } from 'node:child_process';
import { compiler, count, modes, obstacle, readStored, store } from './instructions.ts';

// What stands in the build folder may be older than the sources.
execFileSync('cmake', ['--preset', 'native'], { stdio: ['ignore', 'ignore', 'inherit'] });
execFileSync('cmake', ['--build', '--preset', 'native', '--target', 'instructions_run'], { stdio: 'inherit' });
const reason = obstacle();
if (reason) throw new Error(`Nothing can be counted: ${reason}.`);

const before = readStored();
const [tracked, propagated] = modes.map(count);
store({ compiler: compiler(), counts: { tracked, propagated } });
for (const [mode, { instructions, triangles }] of Object.entries({ tracked, propagated })) {
  const old = before.counts[mode as keyof typeof before.counts];
  console.log(
    `${mode}: ${instructions} instructions, ${(instructions / old.instructions).toFixed(3)} of those before; ` +
      `${triangles} triangles left, ${old.triangles} before`,
  );
}
