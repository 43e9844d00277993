import { quantile, ticks } from 'd3-array';

/** The numbers that the two ends of a colour map stand for, lowest first, in the variable's unit. */
export interface ColourRange {
  lowest: number;
  highest: number;
}

/**
 * What a colour map is to span: all values, those between two percentiles (0…100, lowest first), or a range typed by
 * the user in the variable's unit.
 */
export type RangeChoice = 'data' | { percentiles: readonly [lowest: number, highest: number] } | ColourRange;

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

/** Between two percentiles, 0…100, of the finite values; 0…0 where there is none. */
export function percentileRange(values: ArrayLike<number>, lowest: number, highest: number): ColourRange {
  const finite = Float64Array.from(values).filter(Number.isFinite);
  return { lowest: quantile(finite, lowest / 100) ?? 0, highest: quantile(finite, highest / 100) ?? 0 };
}

/** The range that was chosen, of these values. */
export function chosenRange(values: ArrayLike<number>, choice: RangeChoice): ColourRange {
  if (choice === 'data') return dataRange(values);
  if ('percentiles' in choice) return percentileRange(values, ...choice.percentiles);
  return choice;
}

/**
 * A range as a user types it: "data", two percentiles as "2%…98%", or two numbers as "0…1.5"; between them stands …, ..,
 * a comma, a space or "to". Null where it is none of these, or not rising.
 */
export function parseRange(text: string): RangeChoice | null {
  const trimmed = text.trim();
  if (trimmed === '' || trimmed === 'data') return 'data';
  const parts = trimmed.split(/\s*(?:…|\.\.+|,|\bto\b)\s*|\s+(?!%)/);
  const percents = parts.filter((part) => part.endsWith('%')).length;
  const numbers = parts.map((part) => Number(part.replace(/\s*%$/, '').replace('\u2212', '-') || Number.NaN));
  const [lowest, highest] = numbers;
  if (parts.length !== 2 || !numbers.every(Number.isFinite) || !(lowest < highest)) return null;
  if (percents === 0) return { lowest, highest };
  return percents === 2 && lowest >= 0 && highest <= 100 ? { percentiles: [lowest, highest] } : null;
}

/** What `parseRange` reads as this choice. */
export function rangeText(choice: RangeChoice): string {
  if (choice === 'data') return 'data';
  if ('percentiles' in choice) return choice.percentiles.map((percent) => `${percent}%`).join('…');
  return `${choice.lowest}…${choice.highest}`;
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
