import { verify as judge } from '../../../wasm/index.ts';
import type { Mesh, Verdict, VerifyOptions } from '../../../wasm/types.ts';
import { unusedNotes } from '../../session/report/defect-notes.ts';
import { usedPoints } from '../../surface/used-points.ts';
import { spanOf } from '../../surface/value-span.ts';
import type { Command } from '../command.ts';
import { exitStatus } from '../exit-status.ts';
import { faultOf, UsageFault } from '../fault.ts';
import { comparable, multipliersOf } from '../files/comparable.ts';
import { openSurface } from '../files/surface-files.ts';
import { parseArguments } from '../options/arguments.ts';
import { parseBounds, unnamed } from '../options/bound-arguments.ts';
import { without } from '../options/exclude.ts';
import { parseBoundMultiplier } from '../options/keeping-arguments.ts';
import { parseWeld, weldHelp } from '../options/weld-argument.ts';
import { sayNotes } from '../output/notes.ts';
import { ProgressBar } from '../output/progress-bar.ts';
import { freeNotes } from '../output/report.ts';
import { findingsOf, verdictText } from '../output/verdict.ts';

const help = `Checks by an independent judge whether a reduced surface keeps the bounds.

Usage: meshbound verify ORIGINAL REDUCED --bound NAME=BOUND …

The judge knows nothing of how the surface was reduced, and uses nothing that reduces. It takes both as surfaces in
the space of position and variables together, looks from many points of each for the nearest point of the other, and does
the same with their boundaries. Distances are given in bounds: 1 is the limit.

Bounds are written as for “meshbound reduce”; percentages are of the extents in ORIGINAL.

Options:
  -b, --bound NAME=BOUND  as often as needed
  --variables FILE.csv    more variables of ORIGINAL: names in the first line, then a line for each point
  ${weldHelp}
  --exclude NAME          leave a variable of ORIGINAL out, as often as needed
  --bound-multiplier NAME a variable of ORIGINAL that multiplies every bound, as for “meshbound reduce”
  --samples N             how many points of each surface are looked at, more or less (default 50000);
                          never fewer than its vertices, edges and triangles
  --json                  the same for programs
  --quiet                 say nothing but errors

Exit status: 0 the bounds hold at every sample; 1 a bound is broken; 2 the surfaces cannot be compared.

Examples:
  meshbound verify engine.vtp small.vtp --bound position=1% --bound "*=3%"
  meshbound verify engine.vtp small.vtp -b position=0.5 --samples 1000000 --json`;

const signature = {
  options: {
    bound: { type: 'string', short: 'b', multiple: true, default: [] as string[] },
    variables: { type: 'string' },
    weld: { type: 'string' },
    exclude: { type: 'string', multiple: true, default: [] as string[] },
    'bound-multiplier': { type: 'string', multiple: true, default: [] as string[] },
    samples: { type: 'string', default: '50000' },
    json: { type: 'boolean', default: false },
    quiet: { type: 'boolean', default: false },
  },
  positionals: ['ORIGINAL', 'REDUCED'],
} as const;

function unusedIn({ triangles, position }: Mesh): number {
  return usedPoints(triangles, position.length / 3).filter((used) => used === 0).length;
}

/** So many points take hours; more is a mistake in writing. */
const mostSamples = 1e9;

function parseSamples(text: string): number {
  const samples = Number(text);
  if (Number.isInteger(samples) && samples > 0 && samples <= mostSamples) return samples;
  throw new UsageFault(`--samples cannot be “${text}”; it is a whole number from 1 to ${mostSamples}.`);
}

async function judged(
  original: Mesh,
  reduced: Mesh,
  { path, quiet, ...options }: VerifyOptions & { path: string; quiet: boolean },
): Promise<Verdict> {
  const bar = process.stderr.isTTY && !quiet ? new ProgressBar(process.stderr) : undefined;
  try {
    return await judge(original, reduced, { ...options, onProgress: (progress) => bar?.show(progress) });
  } catch (error) {
    throw faultOf(path, error);
  } finally {
    bar?.clear();
  }
}

async function run(args: string[]): Promise<number> {
  const { values, positionals } = parseArguments(args, signature);
  const bounds = parseBounds(values.bound);
  const samples = parseSamples(values.samples);
  const weld = parseWeld(values.weld);
  const boundMultiplier = parseBoundMultiplier(values['bound-multiplier']);
  const original = without(values.exclude, await openSurface(positionals[0], values.variables, { weld }));
  const reduced = await openSurface(positionals[1]);
  const { names, limits, one, other } = comparable(original, reduced, bounds);
  const multipliers = boundMultiplier === undefined ? undefined : multipliersOf(original, boundMultiplier);
  const options = { bounds: limits, samples, boundarySamples: samples, multipliers };
  const verdict = await judged(one, other, { ...options, path: reduced.path, quiet: values.quiet });
  const findings = findingsOf(verdict, names, limits, boundMultiplier);
  const within = verdict.withinBounds;
  if (values.json) {
    const found = { original: original.path, reduced: reduced.path, ...findings, within };
    console.log(JSON.stringify(found, undefined, 2));
  } else if (!values.quiet) {
    for (const { path, notes, mesh } of [original, reduced])
      sayNotes(path, [...notes, ...unusedNotes(unusedIn(mesh), 'nothing is compared there')]);
    sayNotes(original.path, freeNotes(unnamed(bounds, original.mesh)));
    const position = { name: 'position', components: 3, values: original.mesh.position };
    console.log(verdictText(findings, spanOf(position, original.mesh.triangles).components));
    console.log(within ? 'The bounds hold at every sample.' : 'A bound is broken.');
  }
  return within ? exitStatus.done : exitStatus.boundBroken;
}

export const verify: Command = { help, run };
