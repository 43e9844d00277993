import { rangeDigits, removedPercent, roundedDown, roundedUp } from '../session/bounds/rounding.ts';

/** Groups digits as the field does: 99 980, with a space that does not break. */
const groupSpace = '\u202f';
const minus = '\u2212';

const counts = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });

/** "99 980" */
export function countText(count: number): string {
  return counts.format(count).replaceAll(',', groupSpace);
}

/** Beyond these a value is written with a power of ten. */
const largestPlain = 1e6;
const smallestPlain = 1e-3;

/** A value with `digits` significant digits: "0.0123", "−4.5e−7", "101 300". */
export function valueText(value: number, digits = 3): string {
  if (value === 0) return '0';
  if (!Number.isFinite(value)) return Number.isNaN(value) ? '–' : value > 0 ? '∞' : `${minus}∞`;
  const size = Math.abs(value);
  // Where all digits before the point are asked for, a power of ten would hide which they are.
  const plain = size < Math.max(largestPlain, 10 ** digits) && size >= smallestPlain;
  const notation = plain ? 'standard' : 'scientific';
  const format = new Intl.NumberFormat('en', { notation, maximumSignificantDigits: digits, useGrouping: 'min2' });
  return format.format(value).replaceAll(',', groupSpace).replace('E', 'e').replaceAll('-', minus);
}

/** A number under a colour map that spans a range: as many digits as tell its ends apart. */
export function tickText(value: number, { lowest, highest }: { lowest: number; highest: number }): string {
  return valueText(value, rangeDigits(lowest, highest, 6));
}

/** "1.2 Pa", or "1.2" where there is no unit, or the unit is one. */
export function withUnit(text: string, unit: string | undefined): string {
  return unit && unit !== '1' ? `${text}\u00a0${unit}`.trimStart() : text;
}

/** A fraction in percent: 100 × 0.07 is 7.000000000000001 in the machine's numbers. */
export function percentOf(fraction: number): number {
  return Number((100 * fraction).toPrecision(15));
}

/** A fraction as a percentage without its sign, rounded to three digits: "2.97". */
export function percentNumber(fraction: number): string {
  return Number((100 * fraction).toPrecision(3)).toString();
}

/** A fraction as a percentage: "2.97 %". */
export function percentText(fraction: number): string {
  return `${percentNumber(fraction)}\u00a0%`;
}

/** What share of the triangles is gone: "99.3 %"; 100 only where all are. */
export function removedText(before: number, after: number): string {
  return `${removedPercent(before, after, 3)}\u00a0%`;
}

/** Significant digits of bounds and errors. */
const promisedDigits = 3;

/** A bound or an error in its unit, rounded up: what is guaranteed must not be written smaller than it is. */
export function upperText(value: number): string {
  return valueText(roundedUp(value, promisedDigits));
}

/** The same as a percentage, of a fraction. */
export function upperPercentText(fraction: number): string {
  return percentText(roundedUp(fraction, promisedDigits));
}

/** A fraction as a percentage that reads 100 only where it is all: "99.9 %". */
export function lowerPercentText(fraction: number): string {
  return percentText(roundedDown(fraction, promisedDigits));
}

/** Below this an error is what rounding leaves of none: errors are held in single precision. */
const smallestShare = 1e-6;

/** The share that a place uses of a bound: "62.1 %"; reads 100 only where it is all, and 0 only where it is none. */
export function usedShareText(share: number): string {
  return isRounding(share) ? `\u2248\u00a0${percentText(0)}` : lowerPercentText(share);
}

/** The share that an area uses of a bound at most: "12.4 %"; reads 0 only where it is none. */
export function upperShareText(share: number): string {
  return isRounding(share) ? `\u2248\u00a0${percentText(0)}` : upperPercentText(share);
}

/** The error at a place in its unit, given what share of its bound that is (null where it has none): "0.31". */
export function placeErrorText(error: number, share: number | null): string {
  return share !== null && isRounding(share) ? '\u2248\u00a00' : upperText(error);
}

/** Whether such a share of a bound is nothing but rounding. */
export function isRounding(share: number): boolean {
  return share > 0 && share < smallestShare;
}

/** "0.31 s", "12 s" */
export function secondsText(seconds: number): string {
  if (seconds < 0.005) return 'less than 0.01\u00a0s';
  return `${seconds < 10 ? seconds.toFixed(2) : Math.round(seconds)}\u00a0s`;
}
