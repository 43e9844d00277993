import { quoted } from '../../formats/text/wording.ts';

/** Points that follow one another, by their numbers, counted from 0; `last` is among them. */
export type PointRange = readonly [first: number, last: number];

/** More points than any mesh has; a list that names more is a mistake in writing. */
const mostPoints = 2 ** 32 - 2;

/** Points as people write them, `3,17,20-40`. Throws an Error whose message is a sentence for people. */
export function readPoints(list: string): PointRange[] {
  return list.split(',').map((entry) => {
    const [, from, to = from] = /^\s*(\d+)(?:-(\d+))?\s*$/.exec(entry) ?? [];
    const [first, last] = [Number(from), Number(to)];
    if (from === undefined || last < first || last > mostPoints) {
      throw new Error(`${quoted(entry)} is no point and no range of points.`);
    }
    return [first, last];
  });
}

/** The text that `readPoints` reads as these points. */
export function pointsText(ranges: readonly PointRange[]): string {
  return ranges.map(([first, last]) => (first === last ? first : `${first}-${last}`)).join(',');
}

/** Each of the points. Throws an Error with a `code` where a surface of so many points has not all of them. */
export function pointsOf(ranges: readonly PointRange[], count: number): number[] {
  // Before any are written out, which could be more than memory holds.
  const beyond = ranges.find(([, last]) => last >= count);
  if (beyond) {
    const text = `There is no point ${beyond[1]} to lock: the surface has ${count}, counted from 0.`;
    throw Object.assign(new Error(text), { code: 'bad_option' });
  }
  return ranges.flatMap(writtenOut);
}

function writtenOut([first, last]: PointRange): number[] {
  return Array.from({ length: last - first + 1 }, (_, i) => first + i);
}
