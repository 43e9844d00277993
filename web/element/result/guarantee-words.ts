import type { Reduction, Report, VariableExtent, VariableReport } from '../../../wasm/index.ts';
import { sizeOf } from '../../session/bounds/bound-setting.ts';
import { type Reason, whyLittleWent } from '../../session/report/why-little-went.ts';
import { english } from '../../words/english.ts';
import { littleWentSentence } from '../../words/little-went.ts';
import { countText, isRounding, lowerPercentText, upperPercentText, upperText } from '../number-text.ts';

const words = english.guarantee;

/** A bound or an error of a variable as a percentage; in its unit where there is nothing to take a percentage of. */
function shareText(value: number, variable: VariableExtent): string {
  const size = sizeOf(variable);
  return size > 0 ? upperPercentText(value / size) : upperText(value);
}

export function isFree({ bound }: VariableReport): boolean {
  return !Number.isFinite(bound);
}

/**
 * Whether a result is there only until the one from the original is: of what a session shows, what was resumed from a
 * checkpoint is.
 */
export function isProvisional({ errorsAreUpperBounds }: Report): boolean {
  return errorsAreUpperBounds;
}

/** Whether errors were measured against the original (tracked); otherwise they are limits from above (propagated). */
export function isMeasured({ vertexErrors }: Reduction): boolean {
  return vertexErrors !== undefined;
}

/**
 * The result as the guarantee states it: "806 of 99 980 triangles. Every point within 1 % in space, 3 % in pressure: proved;
 * most used: pressure, 2.97 % (99 % of its bound)." Claims nothing of a variable without a bound.
 *
 * @param measured whether the errors were measured; otherwise they are limits, and the sentence says so
 * @param multiplied whether the bounds were multiplied by what differs over the surface
 */
export function guaranteeSentence(report: Report, measured: boolean, multiplied = false): string {
  const { triangles, variables, dropped } = report;
  const [after, before] = [countText(triangles.after), countText(triangles.before)];
  const counted = words.counted(after, before, english.triangles(triangles.before));
  const bounded = variables.filter((variable) => !isFree(variable));
  const free = variables.filter(isFree).map(placeName);
  const left = dropped.components > 0 ? ` ${words.dropped(countText(dropped.components), dropped.components)}` : '';
  const freed = `${free.length > 0 ? ` ${words.free(free)}` : ''}${left}${littleWent(report)}`;
  const bounds = `${boundsPhrase(bounded)}${multiplied ? words.multiplied : ''}`;
  if (bounded.length === 0) return `${counted}${freed}`;
  return `${counted} ${words.proved(bounds, mostUsed(bounded, measured, multiplied))}${freed}`;
}

/** Why, where little went though the bounds would let it. */
function littleWent(report: Report): string {
  const why = whyLittleWent(report);
  return why ? ` ${littleWentSentence(why)}` : '';
}

/** "1 % in space, 3 % in pressure and density": variables with the same bound stand together, in their order. */
function boundsPhrase(bounded: VariableReport[]): string {
  const together = new Map<string, string[]>();
  for (const variable of bounded) {
    const bound = shareText(variable.bound, variable);
    together.set(bound, [...(together.get(bound) ?? []), placeName(variable)]);
  }
  return [...together].map(([bound, names]) => words.bound(bound, names)).join(', ');
}

function mostUsed(bounded: VariableReport[], measured: boolean, multiplied: boolean): string {
  const most = bounded.reduce((best, next) => (next.ratio > best.ratio ? next : best));
  if (most.ratio === 0) return words.noError;
  if (isRounding(most.ratio)) return words.rounding;
  const error = shareText(most.error, most);
  const say = multiplied ? words.mostUsedThere : words.mostUsed;
  return say(placeName(most), measured ? error : words.atMost(error), lowerPercentText(most.ratio));
}

/** Why vertices that are still there could not go, as a share of them all, 0…1. */
export interface HeldBack {
  /** A variable's name, `space`, or what of the surface's shape forbids it. */
  reason: string;
  share: number;
}

/** What holds a reduction back, the largest share first; empty where nothing does. */
export function heldBackShares({ variables, refused }: Report): HeldBack[] {
  const reasons: [string, number][] = [
    ...variables.map((variable): [string, number] => [placeName(variable), variable.refused]),
    ...(Object.entries(refused) as [Reason, number][]).map(([reason, count]): [string, number] => [
      english.heldBack.reasons[reason],
      count,
    ]),
  ];
  const counted = reasons.filter(([, count]) => count > 0).sort(([, a], [, b]) => b - a);
  const all = counted.reduce((sum, [, count]) => sum + count, 0);
  return counted.map(([reason, count]) => ({ reason, share: count / all }));
}

/** "61 %", and nothing finer: it is a rough guide. */
export function roughShareText(share: number): string {
  return share < 0.01 ? '<\u00a01\u00a0%' : `${Math.round(100 * share)}\u00a0%`;
}

function placeName({ name }: { name: string }): string {
  return name === 'position' ? words.space : name;
}
