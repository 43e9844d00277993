import type { Bound, Mesh, Report } from '../../../wasm/types.ts';
import { roundingsOf } from '../../formats/file-rounding.ts';
import { FormatError } from '../../formats/format-error.ts';
import { formatNames } from '../../formats/format-names.ts';
import type { Format, Labels } from '../../formats/surface.ts';
import { quoted } from '../../formats/text/wording.ts';
import { scaleOf, spanOf } from '../../surface/value-span.ts';
import { type Bounds, boundOf } from './bound-text.ts';

/** What a file format takes from the bounds of a surface. */
export interface BoundsForFile {
  /** What is left for the reduction: a bound that the format takes from is absolute, all others are as they were. */
  bounds: Bounds;
  /** What the format takes: of position, then of the variables, in their units. */
  roundings: number[];
}

/** A reduction needs some room: a format may take so much of a bound, no more. */
const mostTaken = 0.5;

/** What the file declares its variables to be. */
type Roles = Pick<Partial<Labels>, 'roles'>;

/**
 * What a file of this format takes from the bounds, before anything is reduced. Throws a FormatError that names the format and
 * the variable where it takes too much; what it has no place for is lost anyway, and said.
 *
 * @param leastMultiplier the smallest value of what multiplies the bounds, 1 where nothing does
 */
export function boundsForFile(
  format: Format,
  mesh: Mesh,
  bounds: Bounds,
  leastMultiplier = 1,
  roles: Roles = {},
): BoundsForFile {
  const variables = [{ name: 'position', components: 3, values: mesh.position }, ...mesh.variables];
  const roundings = takenBy(format, mesh, roles);
  const lowered = variables.flatMap((variable, i): [string, Bound][] => {
    const asked = boundOf(bounds, variable);
    if (roundings[i] === 0 || asked === 'free') return [];
    const absolute = 'absolute' in asked ? asked.absolute : asked.relative * scaleOf(spanOf(variable, mesh.triangles));
    const taken = roundings[i] / leastMultiplier;
    if (!(taken <= mostTaken * absolute)) throw tooCoarse(format, variable.name, absolute, roundings[i]);
    return [[variable.name, { absolute: absolute - taken }]];
  });
  return {
    bounds: lowered.length > 0 ? Object.fromEntries([...Object.entries(bounds), ...lowered]) : bounds,
    roundings,
  };
}

function tooCoarse(format: Format, name: string, bound: number, rounding: number): FormatError {
  const message =
    `${formatNames[format]} cannot keep the bound ${bound} of ${quoted(name)}: it holds single precision, which is up to ` +
    `${rounding.toPrecision(2)} off. VTP, PLY and VTK hold double precision${name === 'position' ? ', OBJ too' : ''}.`;
  return new FormatError('too_coarse', message, name);
}

/** The smallest of what multiplies the bounds: of the variable `boundMultiplier`, 1 where nothing does. What is none is for the core to refuse. */
export function leastMultiplier({ variables, triangles }: Mesh, boundMultiplier: string | null | undefined): number {
  const variable = variables.find(({ name }) => name === boundMultiplier);
  const least = variable ? spanOf(variable, triangles).components[0].lowest : 1;
  return least > 0 && Number.isFinite(least) ? least : 1;
}

/**
 * What a reduction within these bounds leaves, with the errors that it has in the file. Where the feature size limits the bound of
 * position below what is left of it, the format takes its part from that, and the reduction is made once more.
 *
 * @param parts of each level; one, where there are no levels
 */
export async function reducedWithin<Result extends { report: Report }>(
  format: Format,
  parts: readonly BoundsForFile[],
  leastMultiplier: number,
  reduce: (bounds: Bounds[]) => Promise<Result[]>,
): Promise<Result[]> {
  const first = await reduce(parts.map(({ bounds }) => bounds));
  const limited = parts.map((part, i) => belowFeatureSize(format, part, first[i].report, leastMultiplier));
  const isLimited = limited.some((part, i) => part !== parts[i]);
  const results = isLimited ? await reduce(limited.map(({ bounds }) => bounds)) : first;
  return results.map((result, i) => {
    const report = { ...result.report, featureSize: first[i].report.featureSize };
    return { ...result, report: reportOfFile(report, parts[i], leastMultiplier) };
  });
}

/** Bounds of which the format has its part where the feature size limited that of position. */
function belowFeatureSize(
  format: Format,
  part: BoundsForFile,
  { featureSize, variables: [position] }: Report,
  leastMultiplier: number,
): BoundsForFile {
  const [rounding] = part.roundings;
  if (featureSize === undefined || rounding === 0) return part;
  const taken = rounding / leastMultiplier;
  if (!(taken <= mostTaken * position.bound)) throw tooCoarse(format, 'position', position.bound, rounding);
  return { ...part, bounds: { ...part.bounds, position: { absolute: position.bound - taken } } };
}

/** What a file takes of position, then of the variables that it holds. */
function takenBy(format: Format, mesh: Mesh, roles: Roles): number[] {
  const kept = format === 'stl' ? 1 : 1 + mesh.variables.length;
  return roundingsOf(format, mesh, roles).map((rounding, i) => (i < kept ? rounding : 0));
}

/** The report of a result that was reduced without a thought of the file, as it is in there. */
export function reportInFile(
  format: Format,
  mesh: Mesh,
  report: Report,
  leastMultiplier = 1,
  roles: Roles = {},
): Report {
  const roundings = takenBy(format, mesh, roles);
  const variables = report.variables.map((variable, i) => {
    const rounding = roundings[i];
    if (rounding === 0) return variable;
    const used = Number.isFinite(variable.bound) ? rounding / leastMultiplier / variable.bound : 0;
    return { ...variable, error: variable.error + rounding, rounding, ratio: variable.ratio + used };
  });
  return { ...report, variables };
}

/** The report of a reduction with the bounds that were asked for, and with errors that include what the format takes. */
export function reportOfFile(report: Report, { roundings }: BoundsForFile, leastMultiplier = 1): Report {
  if (roundings.every((rounding) => rounding === 0)) return report;
  const variables = report.variables.map((variable, i) => {
    const rounding = roundings[i];
    if (rounding === 0) return variable;
    const error = variable.error + rounding;
    if (!Number.isFinite(variable.bound)) return { ...variable, error, rounding };
    const taken = rounding / leastMultiplier;
    const bound = variable.bound + taken;
    return { ...variable, bound, error, rounding, ratio: (variable.ratio * variable.bound + taken) / bound };
  });
  return { ...report, variables };
}

/**
 * Whether a result keeps its bounds once a file of this format has rounded it.
 *
 * @param mesh what is written
 */
export function isKept(format: Format, mesh: Mesh, report: Report, leastMultiplier = 1, roles: Roles = {}): boolean {
  return broken(format, mesh, report, leastMultiplier, roles) === undefined;
}

/** The first variable whose bound the rounding of the format breaks. */
function broken(format: Format, mesh: Mesh, { variables }: Report, leastMultiplier: number, roles: Roles) {
  return takenBy(format, mesh, roles)
    .map((rounding, i) => ({ ...variables[i], rounding }))
    .filter(({ bound, rounding }) => Number.isFinite(bound) && rounding > 0)
    .find(({ bound, ratio, rounding }) => !(ratio * bound + rounding / leastMultiplier <= bound));
}
