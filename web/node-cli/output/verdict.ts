import type { Deviation, Verdict } from '../../../wasm/types.ts';
import { grouped, printable } from '../../formats/text/wording.ts';
import type { ComponentSpan } from '../../surface/value-span.ts';
import { placeText, roundedUpText, textTable } from './text-table.ts';

/** The farthest sample that was found in one direction. */
interface Finding {
  /** Distance in bounds: 1 is the limit. Infinity where there is nothing to be near to. */
  ratio: number;
  /** The variable that is farthest there. */
  variable: string;
  position: [number, number, number];
  samples: number;
}

/** What `verify --json` prints, beside the files; documented in docs/command-line.md. */
export interface Findings {
  bounds: { name: string; bound: number }[];
  /** The variable that multiplies the bounds, or null. */
  boundMultiplier: string | null;
  ratio: number;
  surface: { fromOriginal: Finding; fromReduced: Finding };
  boundary: { fromOriginal: Finding; fromReduced: Finding };
}

/** The judge's verdict with the names of the variables, position first, their absolute bounds, and what multiplies these. */
export function findingsOf(
  { surface, boundary, ratio }: Verdict,
  names: readonly string[],
  limits: readonly number[],
  boundMultiplier: string | null = null,
): Findings {
  const named = ({ ratio, variable, position, samples }: Deviation): Finding => {
    return { ratio, variable: names[variable], position, samples };
  };
  const both = ({ fromOriginal, fromReduced }: Verdict['surface']) => {
    return { fromOriginal: named(fromOriginal), fromReduced: named(fromReduced) };
  };
  const bounds = names.map((name, i) => ({ name, bound: limits[i] })).filter(({ bound }) => Number.isFinite(bound));
  return {
    bounds,
    boundMultiplier,
    ratio,
    surface: both(surface),
    boundary: both(boundary),
  };
}

const heading = ['', 'samples', 'error/bound', 'variable', 'worst at'];

function row(title: string, { ratio, variable, position, samples }: Finding, box: readonly ComponentSpan[]): string[] {
  if (samples === 0) return [title, '0', Number.isFinite(ratio) ? '0' : 'nothing near', '', ''];
  const place = placeText(position, box);
  return [title, grouped(samples), ratio.toFixed(6), ...(ratio > 0 ? [variable, place] : ['', ''])];
}

/** For people; `box` is what the positions of the original span, so that the places can be told apart. */
export function verdictText(
  { bounds, boundMultiplier, surface, boundary }: Findings,
  box: readonly ComponentSpan[],
): string {
  const limits = bounds.map(({ name, bound }) => `${printable(name)} ${roundedUpText(bound)}`).join(', ');
  const rows = [
    row('original to reduced', surface.fromOriginal, box),
    row('reduced to original', surface.fromReduced, box),
    row('boundary, original to reduced', boundary.fromOriginal, box),
    row('boundary, reduced to original', boundary.fromReduced, box),
  ];
  const multiplied = boundMultiplier === null ? '' : `, each multiplied by ${printable(boundMultiplier)}`;
  return `Bounds: ${limits}${multiplied}\n${textTable([heading, ...rows])}`;
}
