import { ticks } from 'd3-array';

/** The numbers that the two ends of a colour map stand for, lowest first, in the variable's unit. */
export interface ColourRange {
  lowest: number;
  highest: number;
}

/** From the smallest to the largest finite value; 0…0 where there is none. */
export function dataRange(values: ArrayLike<number>): ColourRange {
  let lowest = Infinity;
  let highest = -Infinity;
  for (let index = 0; index < values.length; index++) {
    const value = values[index];
    if (!Number.isFinite(value)) continue;
    if (value < lowest) lowest = value;
    if (value > highest) highest = value;
  }
  return lowest <= highest ? { lowest, highest } : { lowest: 0, highest: 0 };
}

/** The smallest range around zero that contains `range`, so that the middle of a diverging map is zero. */
export function centredOnZero(range: ColourRange): ColourRange {
  const reach = Math.max(Math.abs(range.lowest), Math.abs(range.highest));
  return { lowest: -reach, highest: reach };
}

/** Where `value` stands in the range, 0…1; the middle where the range is a single number. */
export function placeIn(range: ColourRange, value: number): number {
  const width = range.highest - range.lowest;
  return width > 0 ? (value - range.lowest) / width : 0.5;
}

/** About `count` round numbers inside the range, rising. */
export function roundTicks(range: ColourRange, count: number): number[] {
  return range.highest > range.lowest ? ticks(range.lowest, range.highest, count) : [range.lowest];
}
