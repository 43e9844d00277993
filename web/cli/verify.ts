import type { Mesh, Variable } from '../../wasm/index.ts';
import { judgeAccuracy, loadJudge } from '../../wasm/judge-module.ts';
import { counted } from '../formats/wording.ts';
import { scaleOf, spanOf } from '../surface/value-span.ts';
import { parseArguments } from './arguments.ts';
import { type Bounds, boundOf, parseBounds, requireKnownBounds, unnamed } from './bound-arguments.ts';
import type { Command } from './command.ts';
import { exitStatus } from './exit-status.ts';
import { Fault, UsageFault } from './fault.ts';
import { sayNotes } from './notes.ts';
import { freeNotes } from './report.ts';
import { type OpenedSurface, openSurface } from './surface-files.ts';
import { findingsOf, verdictText } from './verdict.ts';

const help = `Checks by an independent judge whether a reduced surface keeps the bounds.

Usage: meshbound verify ORIGINAL REDUCED --bound NAME=BOUND …

The judge knows nothing of how the surface was reduced, and shares no code with what reduces. It takes both as surfaces in
the space of position and variables together, looks from many points of each for the nearest point of the other, and does
the same with their boundaries. Distances are given in bounds: 1 is the limit.

Bounds are written as for "meshbound reduce"; percentages are of the extents in ORIGINAL.

Options:
  -b, --bound NAME=BOUND  as often as needed
  --variables FILE.csv    more variables of ORIGINAL: names in the first line, then a line for each point
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
    samples: { type: 'string', default: '50000' },
    json: { type: 'boolean', default: false },
    quiet: { type: 'boolean', default: false },
  },
  positionals: ['ORIGINAL', 'REDUCED'],
} as const;

/** So many points take hours; more is a mistake in writing. */
const mostSamples = 1e9;

function parseSamples(text: string): number {
  const samples = Number(text);
  if (Number.isInteger(samples) && samples > 0 && samples <= mostSamples) return samples;
  throw new UsageFault(`--samples cannot be “${text}”; it is a whole number from 1 to ${mostSamples}.`);
}

/** The position and what has a bound, in the original's order: all that is judged. */
function bounded(bounds: Bounds, { mesh }: OpenedSurface): string[] {
  return mesh.variables.map(({ name }) => name).filter((name) => boundOf(bounds, name) !== 'free');
}

/** The surface with these variables alone, in this order. Throws a Fault where one is missing or not finite. */
function onlyWith(names: readonly string[], { path, mesh }: OpenedSurface): Mesh {
  const variables = names.map((name) => {
    const variable = mesh.variables.find((each) => each.name === name);
    if (!variable) throw new Fault(`${path}: there is no variable “${name}”, so its bound cannot be checked.`);
    return variable;
  });
  for (const variable of [positionOf(mesh), ...variables]) requireFinite(path, variable);
  if (mesh.triangles.length === 0) throw new Fault(`${path}: there are no triangles.`);
  return { ...mesh, variables };
}

function positionOf({ position }: Mesh): Variable {
  return { name: 'position', components: 3, values: position };
}

function requireFinite(path: string, variable: Variable): void {
  const { nan, infinite } = spanOf(variable);
  if (nan + infinite > 0)
    throw new Fault(
      `${path}: “${variable.name}” holds ${counted(nan + infinite, 'value')} that ${nan + infinite === 1 ? 'is' : 'are'} not finite.`,
    );
}

function requireSameComponents(original: Mesh, { path }: OpenedSurface, reduced: Mesh): void {
  for (const [i, { name, components }] of reduced.variables.entries()) {
    const wanted = original.variables[i].components;
    if (components !== wanted)
      throw new Fault(`${path}: “${name}” has ${counted(components, 'component')}, that of the original ${wanted}.`);
  }
}

/** The bound of each variable in its unit, position first. */
function absoluteBounds(bounds: Bounds, original: Mesh): number[] {
  return [positionOf(original), ...original.variables].map((variable) => {
    const bound = boundOf(bounds, variable.name);
    if (bound === 'free') return Number.POSITIVE_INFINITY;
    return 'absolute' in bound ? bound.absolute : bound.relative * scaleOf(spanOf(variable));
  });
}

async function run(args: string[]): Promise<number> {
  const { values, positionals } = parseArguments(args, signature);
  const bounds = parseBounds(values.bound);
  const samples = parseSamples(values.samples);
  const [original, reduced] = [await openSurface(positionals[0], values.variables), await openSurface(positionals[1])];
  requireKnownBounds(bounds, original);
  const names = bounded(bounds, original);
  if (names.length === 0 && boundOf(bounds, 'position') === 'free') throw new UsageFault('Every variable is free.');
  const [one, other] = [onlyWith(names, original), onlyWith(names, reduced)];
  requireSameComponents(one, reduced, other);
  const limits = absoluteBounds(bounds, one);
  const judge = await loadJudge();
  const outcome = judge.judge(one, other, limits, samples);
  if (!outcome.ok) throw new Fault(`${reduced.path}: ${outcome.failure.message}`);
  const findings = findingsOf(outcome.value, ['position', ...names], limits);
  const broken = findings.ratio > 1 + judgeAccuracy;
  if (values.json)
    console.log(
      JSON.stringify({ original: original.path, reduced: reduced.path, ...findings, within: !broken }, undefined, 2),
    );
  else if (!values.quiet) {
    for (const { path, notes } of [original, reduced]) sayNotes(path, notes);
    sayNotes(original.path, freeNotes(unnamed(bounds, original.mesh)));
    console.log(verdictText(findings));
    console.log(broken ? 'A bound is broken.' : 'The bounds hold at every sample.');
  }
  return broken ? exitStatus.boundBroken : exitStatus.done;
}

export const verify: Command = { help, run };
