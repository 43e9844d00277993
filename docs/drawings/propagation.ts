import { arrow, box, drawing, line, type Point, text } from './svg.ts';

/** Pixels for one bound, and where zero lies. */
const unit = 78;
const zero = 180;

function bar(classes: string, x: number, [low, high]: Point, name: string): string {
  const top = zero - high * unit;
  return [
    box(`${classes} veil`, [x, top], 34, (high - low) * unit),
    line(`line ${classes.replace('fill-', '')}`, [x, top], [x + 34, top]),
    line(`line ${classes.replace('fill-', '')}`, [x, zero - low * unit], [x + 34, zero - low * unit]),
    text('small middle', [x + 17, zero + 118], name),
  ].join('');
}

function sum(a: Point, b: Point): Point {
  return [a[0] + b[0], a[1] + b[1]];
}

/** One component of one variable on a new triangle that two old triangles reach. */
export function propagation(): string {
  const old: Point[] = [
    [-0.25, 0.3],
    [-0.05, 0.55],
  ];
  const introduced: Point[] = [
    [-0.35, 0.1],
    [-0.1, 0.25],
  ];
  const sums = old.map((interval, i) => sum(interval, introduced[i]));
  const hull: Point = [Math.min(sums[0][0], sums[1][0]), Math.max(sums[0][1], sums[1][1])];
  const bound = (share: number, words: string) => [
    line('soft orange dashed', [70, zero - share * unit], [700, zero - share * unit]),
    text('small end', [62, zero - share * unit + 4], words),
  ];
  return drawing(760, 340, 'The interval of a new triangle: old interval plus introduced, over all its pieces', [
    text('title', [70, 30], 'signed error of one component, in bounds'),
    ...bound(1, '+1'),
    ...bound(-1, '−1'),
    line('soft', [70, zero], [700, zero]),
    text('small end', [62, zero + 4], '0'),
    bar('fill-blue', 90, old[0], 'old, 1'),
    text('', [133, zero + 5], '+'),
    bar('fill-green', 150, introduced[0], 'new, 1'),
    text('', [194, zero + 5], '='),
    bar('fill-violet', 212, sums[0], 'sum 1'),
    bar('fill-blue', 310, old[1], 'old, 2'),
    text('', [353, zero + 5], '+'),
    bar('fill-green', 370, introduced[1], 'new, 2'),
    text('', [414, zero + 5], '='),
    bar('fill-violet', 432, sums[1], 'sum 2'),
    arrow('soft', [500, zero], [570, zero]),
    bar('fill-orange', 600, hull, 'the new triangle'),
    text(
      'small soft-text',
      [70, 328],
      'old: interval of an old triangle · new: lowest and highest difference at the corners of its piece · right: their hull',
    ),
  ]);
}
