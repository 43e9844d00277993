import type { ReportOptions } from '../../session/report/report-json.ts';
import { UsageFault } from '../fault.ts';
import { outputFormat } from '../files/surface-files.ts';
import { oneOf, parseArguments } from './arguments.ts';
import { type Bounds, parseBounds } from './bound-arguments.ts';
import { type Keeping, parseBoundMultiplier, parseBox, parsePoints, parseRegion } from './keeping-arguments.ts';
import { levelPaths, parseLevels } from './level-arguments.ts';
import { parseWeld, weldHelp } from './weld-argument.ts';

export const help = `Reduces a surface so that every bound holds at every point of it.

Usage: meshbound reduce IN -o OUT --bound NAME=BOUND …
       meshbound reduce IN -o OUT --levels BOUND,BOUND … [--bound NAME=BOUND,BOUND … …]

A bound is the largest allowed error of a variable: 1% of its extent (the length of the diagonal of the box of its
values), 0.2 in its unit, or free. "position" is the geometry, "*" every variable not named but identifiers (numbers of
points, masks); of two bounds with one name the later one holds. A variable without bound is free: it is carried along,
and nothing is guaranteed of it.

Options:
  -o, --output OUT        the file to write: .vtp, .vtk, .ply, .glb, .obj or .stl, and .gz behind any of them
  -b, --bound NAME=BOUND  as often as needed
  --variables FILE.csv    more variables of IN: names in the first line, then a line for each point
  ${weldHelp}
  --exclude NAME          leave a variable out, as often as needed
  --errors HOW            tracked (default): measured against the original at every step;
                          propagated: added up from removal to removal, as in the paper; more triangles stay
  --cost WHAT             with propagated errors, what the choice among retriangulations makes small:
                          introduced (default): the error of this removal; maximum: the error so far
  --region NAME           cell data of IN (whole numbers; of .ply a property of the faces, of .obj the material) that
                          part the surface into regions: their borders are kept within the bounds, each side keeps
                          its number; written to .vtp, .vtk and .ply, materials to .obj, too
  --refuse-piercing       let no part of the surface pierce another that passes near; takes about half as long again
  --limit-to-feature-size limit the bound of position to half the distance of the nearest parts that face each other
  --bound-multiplier NAME a variable of one component, above zero, that multiplies every bound: finer where it is small
  --drop-small-components leave out parts that are smaller than the bound of position; says how many
  --lock-points LIST      points that stay, counted from 0: 3,17,20-40
  --lock-region NUMBER    a region that stays as it is (with --region), as often as needed; of .obj its name will do
  --lock-box X,Y,Z,X,Y,Z  lowest and highest corner of a box: every triangle that meets it stays as it is; as often as
                          needed (--lock-box=-1,… where it begins with a minus)
  --map FILE              also write the original with where each vertex went, and what error it has there
  --report FILE.json      also write counts, bounds and errors for programs
  --levels BOUND,BOUND …  nested levels of detail, finest first: bounds of every variable not named; a --bound beside it
                          has one for each level, or one for all; none may fall. OUT is numbered (small-1.vtp …, or
                          where # stands in it); a .glb without # holds all levels (MSFT_lod)
  --quiet                 say nothing but errors

On a terminal a bar shows the progress. Ctrl-C ends the reduction and leaves all files as they were.

Examples:
  meshbound reduce engine.vtp -o small.vtp --bound position=1% --bound "*=3%"
  meshbound reduce engine.vtp -o small.ply -b position=0.5 -b pressure=2% -b velocity=0.2 -b temperature=free
  meshbound reduce engine.vtp -o small.vtp -b "*=1%" --lock-box 0,0,0,1,1,1 --lock-points 0-9
  meshbound reduce engine.vtp -o small.vtp -b "*=1%" --map where.vtp --report report.json
  meshbound reduce engine.vtp -o levels.glb --levels 1%,3%,9% -b position=0.5%,1%,2%`;

const signature = {
  options: {
    output: { type: 'string', short: 'o' },
    bound: { type: 'string', short: 'b', multiple: true, default: [] as string[] },
    variables: { type: 'string' },
    weld: { type: 'string' },
    exclude: { type: 'string', multiple: true, default: [] as string[] },
    errors: { type: 'string', default: 'tracked' },
    cost: { type: 'string', default: 'introduced' },
    region: { type: 'string' },
    'refuse-piercing': { type: 'boolean', default: false },
    'limit-to-feature-size': { type: 'boolean', default: false },
    'bound-multiplier': { type: 'string', multiple: true, default: [] as string[] },
    'drop-small-components': { type: 'boolean', default: false },
    'lock-points': { type: 'string', multiple: true, default: [] as string[] },
    'lock-region': { type: 'string', multiple: true, default: [] as string[] },
    'lock-box': { type: 'string', multiple: true, default: [] as string[] },
    map: { type: 'string' },
    report: { type: 'string' },
    levels: { type: 'string' },
    quiet: { type: 'boolean', default: false },
  },
  positionals: ['IN'],
} as const;

/** What a command line asks for. */
export interface Request {
  input: string;
  output: string;
  variables: string | undefined;
  /** See ReadOptions. */
  weld: number | undefined;
  exclude: string[];
  options: ReportOptions;
  /** Of levels of detail the bounds of each; those of `options` are the first ones. */
  levels: Bounds[] | undefined;
  /** The files that surfaces are written to: `output`, or those of the levels. */
  outputs: string[];
  /** What must stay, and where the bounds are finer. */
  keeping: Keeping;
  map: string | undefined;
  report: string | undefined;
  quiet: boolean;
}

/** Throws a UsageFault for what is missing, unknown or does not go together. */
export function parseRequest(args: string[]): Request {
  const { values, positionals } = parseArguments(args, signature);
  if (!values.output) throw new UsageFault('-o OUT is missing.');
  const errors = oneOf('--errors', values.errors, ['tracked', 'propagated']);
  requireTogether(values);
  const cost = oneOf('--cost', values.cost, ['maximum', 'introduced']);
  const levels = values.levels === undefined ? undefined : parseLevels(values.levels, values.bound);
  const bounds = levels?.[0] ?? parseBounds(values.bound);
  for (const path of [values.output, values.map]) if (path) outputFormat(path);
  const keeping = parseKeeping(values);
  return {
    input: positionals[0],
    output: values.output,
    variables: values.variables,
    weld: parseWeld(values.weld),
    exclude: values.exclude,
    options: {
      bounds,
      errors,
      cost,
      refusePiercing: values['refuse-piercing'],
      limitToFeatureSize: values['limit-to-feature-size'],
      dropSmallComponents: keeping.dropSmallComponents,
      boundMultiplier: keeping.boundMultiplier ?? null,
      region: keeping.region ?? null,
      lockPoints: values['lock-points'],
      lockRegions: keeping.regionsToLock,
      lockBoxes: keeping.lockedBoxes,
    },
    levels,
    outputs: levels ? levelPaths(values.output, levels.length) : [values.output],
    keeping,
    map: values.map,
    report: values.report,
    quiet: values.quiet,
  };
}

type Values = ReturnType<typeof parseArguments<typeof signature.options>>['values'];

function requireTogether({ map, levels, errors, region, 'lock-region': regions }: Values): void {
  if (map && levels !== undefined) throw new UsageFault('--map goes with one result, not with --levels.');
  if (map && errors === 'propagated') throw new UsageFault('--map goes with --errors tracked.');
  if (regions.length > 0 && region === undefined) {
    throw new UsageFault('--lock-region goes with --region NAME, which says what the regions are.');
  }
}

function parseKeeping(values: Values): Keeping {
  return {
    region: values.region,
    boundMultiplier: parseBoundMultiplier(values['bound-multiplier']),
    dropSmallComponents: values['drop-small-components'],
    points: values['lock-points'].flatMap(parsePoints),
    regionsToLock: values['lock-region'].map(parseRegion),
    lockedBoxes: values['lock-box'].map(parseBox),
  };
}
