import type { VariableExtent } from '../../../wasm/inspection.ts';
import type { Bound } from '../../../wasm/types.ts';
import { type Bounded, type Bounds, boundOf } from './bound-text.ts';
import { notANumber, readDecimal } from './decimal.ts';
import { fieldText } from './rounding.ts';

/** What the user asks of one variable: a bound as a fraction of its extent or in its unit, or none. */
export interface BoundSetting {
  /** 0.01 is one percent. Kept while free, so that bounding again brings it back. */
  fraction: number;
  /** In the variable's unit, where it was stated so: then this is what runs, and `fraction` says how large it is. */
  absolute?: number;
  free: boolean;
}

/** By variable name, `position` among them. */
export type BoundSettings = Readonly<Record<string, BoundSetting>>;

/** What a surface starts with. */
const positionFraction = 0.01;
const variableFraction = 0.03;

/** What decides whether a variable starts with a bound. */
type Boundable = Bounded & Pick<VariableExtent, 'nonFinite'> & Partial<Pick<VariableExtent, 'extent'>>;

export function defaultBounds(variables: readonly Boundable[]): BoundSettings {
  const settings: [string, BoundSetting][] = variables.map(({ name, kind, nonFinite, extent = 0 }) => [
    name,
    {
      fraction: name === 'position' ? positionFraction : variableFraction,
      // Of values farther apart than a double holds no fraction is a bound.
      free: kind === 'identifier' || nonFinite !== undefined || !Number.isFinite(extent),
    },
  ]);
  // From entries, so that a variable may be called `__proto__`.
  return Object.fromEntries(settings);
}

/** Whether two settings bound alike. */
export function sameSetting(one: BoundSetting, other: BoundSetting): boolean {
  if (one.free || other.free) return one.free === other.free;
  return one.fraction === other.fraction && one.absolute === other.absolute;
}

/** Whether these are the bounds that a surface starts with. */
export function areFirst(settings: BoundSettings, variables: readonly Boundable[]): boolean {
  const first = defaultBounds(variables);
  return Object.entries(settings).every(
    ([name, { fraction, absolute, free }]) =>
      free === first[name].free && absolute === undefined && fraction === first[name].fraction,
  );
}

/** The settings that state `bounds`: a variable that none reaches is free. */
export function settingsFrom(bounds: Bounds, variables: readonly VariableExtent[]): BoundSettings {
  const first = defaultBounds(variables);
  const settings = variables.map((variable): [string, BoundSetting] => {
    const bound = boundOf(bounds, variable);
    if (bound === 'free') return [variable.name, { ...first[variable.name], free: true }];
    if ('relative' in bound) return [variable.name, { fraction: bound.relative, free: false }];
    return [variable.name, inUnit(bound.absolute, variable)];
  });
  return Object.fromEntries(settings);
}

/** Bounds that were not made for these variables: one that can have no bound, and is not named, is free. */
export function boundsThatFit(bounds: Bounds, variables: readonly VariableExtent[]): Bounds {
  const free = variables.filter(({ name, nonFinite }) => nonFinite && !Object.hasOwn(bounds, name));
  return Object.fromEntries([...Object.entries(bounds), ...free.map(({ name }): [string, Bound] => [name, 'free'])]);
}

/** What is asked of those of these variables that there were before; a bound in a unit is the same, whatever the extent is now. */
export function settingsOf(variables: readonly VariableExtent[], before: BoundSettings): BoundSettings {
  const kept = variables.filter(({ name, nonFinite }) => Object.hasOwn(before, name) && !nonFinite);
  return Object.fromEntries(
    kept.map((variable): [string, BoundSetting] => {
      const setting = before[variable.name];
      const { absolute, free } = setting;
      return [variable.name, absolute === undefined ? setting : { ...inUnit(absolute, variable), free }];
    }),
  );
}

/** A bound in the variable's unit. */
export function inUnit(absolute: number, variable: VariableExtent): BoundSetting {
  return { fraction: absolute / wholeOf(variable), absolute, free: false };
}

/** What a relative bound of a variable is a fraction of, in its unit: 1 where the variable itself has no size. */
export function wholeOf(variable: VariableExtent): number {
  return sizeOf(variable) || 1;
}

/** Zero where all points coincide, or all values are zero. */
export function sizeOf({ constant, extent, magnitude }: VariableExtent): number {
  return constant ? magnitude : extent;
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
  const all = Object.entries(settings).map(([name, setting]): [string, BoundSetting] => [name, moved(setting, factor)]);
  return Object.fromEntries(all);
}

function moved({ fraction, absolute, free }: BoundSetting, factor: number): BoundSetting {
  const setting = { fraction: tidy(fraction * factor), free };
  return absolute === undefined ? setting : { ...setting, absolute: tidy(absolute * factor) };
}

/** Significant digits of a bound: as many as are shown, so that the bound that runs is the one that the user reads. */
const boundDigits = 3;

export function tidy(fraction: number): number {
  return Number(fraction.toPrecision(boundDigits));
}

/** The bounds as the reduction takes them. */
export function asBounds(settings: BoundSettings): Record<string, Bound> {
  const bounds = Object.entries(settings).map(([name, setting]): [string, Bound] => [name, asBound(setting)]);
  return Object.fromEntries(bounds);
}

function asBound({ fraction, absolute, free }: BoundSetting): Bound {
  if (free) return 'free';
  return absolute === undefined ? { relative: fraction } : { absolute };
}

const zeroBound = 'A bound cannot be zero: nothing could be removed.';

/** A number that a user typed, as the field shows it, or what is wrong with it. */
export type Parsed = { value: number; text: string } | { fault: string };

/** A percentage that a user typed, as a fraction: what is typed is what runs, digit by digit. */
export function parsePercent(text: string): Parsed {
  const parsed = parseAmount(text.trim().replace(/\s*%$/, ''));
  if ('fault' in parsed) return parsed;
  const value = Number(`${parsed.value}e-2`) || parsed.value / 100;
  return value === 0 ? { fault: zeroBound } : { value, text: parsed.text };
}

/** A bound in a variable's unit. */
export function parseAmount(text: string): Parsed {
  const written = text.trim();
  const value = readDecimal(written);
  if (Number.isNaN(value)) return { fault: written === '' ? 'A bound needs a number.' : notANumber(written) };
  if (!Number.isFinite(value)) return { fault: 'A bound must be finite. To set no bound, clear “bounded”.' };
  if (value < 0) return { fault: 'A bound cannot be negative.' };
  if (value === 0) return { fault: zeroBound };
  return { value, text: fieldText(value) };
}
