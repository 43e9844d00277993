import type { Bound } from '../../wasm/types.ts';

/** What the user asks of one variable: a bound as a fraction of its extent, or none. */
export interface BoundSetting {
  /** 0.01 is one percent. Kept while free, so that bounding again brings it back. */
  fraction: number;
  free: boolean;
}

/** By variable name, `position` among them. */
export type BoundSettings = Readonly<Record<string, BoundSetting>>;

/** What a surface starts with. */
const positionFraction = 0.01;
const variableFraction = 0.03;

export function defaultBounds(variables: readonly string[]): BoundSettings {
  const settings: [string, BoundSetting][] = variables.map((name) => [
    name,
    { fraction: name === 'position' ? positionFraction : variableFraction, free: false },
  ]);
  // From entries, so that a variable may be called `__proto__`.
  return Object.fromEntries(settings);
}

/** The largest bound that holds, as a fraction; of the free ones where all are free. */
export function largestFraction(settings: BoundSettings): number {
  const all = Object.values(settings);
  const bounded = all.filter(({ free }) => !free);
  return Math.max(...(bounded.length > 0 ? bounded : all).map(({ fraction }) => fraction));
}

/** All bounds multiplied by the factor that brings the largest to `fraction`. */
export function moveAll(settings: BoundSettings, fraction: number): BoundSettings {
  const factor = fraction / largestFraction(settings);
  const moved = Object.entries(settings).map(([name, setting]): [string, BoundSetting] => [
    name,
    { ...setting, fraction: tidy(setting.fraction * factor) },
  ]);
  return Object.fromEntries(moved);
}

/** Significant digits of a bound: as many as are shown, so that the bound that runs is the one that the user reads. */
const boundDigits = 3;

export function tidy(fraction: number): number {
  return Number(fraction.toPrecision(boundDigits));
}

/** The bounds as the reduction takes them. */
export function asBounds(settings: BoundSettings): Record<string, Bound> {
  const bounds = Object.entries(settings).map(([name, { fraction, free }]): [string, Bound] => [
    name,
    free ? 'free' : { relative: fraction },
  ]);
  return Object.fromEntries(bounds);
}

/** A percentage that a user typed, as a tidy fraction, or what is wrong with it. */
export function parsePercent(text: string): { fraction: number } | { fault: string } {
  const written = text.trim().replace(/\s*%$/, '');
  const percent = written === '' ? Number.NaN : tidy(Number(written));
  if (Number.isNaN(percent))
    return { fault: written === '' ? 'A bound needs a number.' : `“${written}” is not a number.` };
  if (!Number.isFinite(percent)) return { fault: 'A bound must be finite. To set no bound, clear “bounded”.' };
  if (percent < 0) return { fault: 'A bound cannot be negative.' };
  const fraction = percent / 100;
  if (fraction === 0) return { fault: 'A bound cannot be zero: nothing could be removed.' };
  return { fraction };
}
