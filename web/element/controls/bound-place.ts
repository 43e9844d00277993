import { tidy } from '../../session/bounds/bound-setting.ts';

/** The slider reaches from 0.01 % to 20 %, logarithmic; a number field reaches beyond. */
const lowest = 0.0001;
const highest = 0.2;

/** The place of a fraction on the slider, 0…1. */
export function placeOf(fraction: number): number {
  const place = Math.log(fraction / lowest) / Math.log(highest / lowest);
  return Math.min(1, Math.max(0, place));
}

/** The fraction at a place, 0…1. */
export function fractionAt(place: number): number {
  return tidy(lowest * (highest / lowest) ** place);
}
