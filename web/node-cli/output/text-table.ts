import { printable } from '../../formats/text/wording.ts';
import { rangeDigits, removedPercent, roundedUp } from '../../session/bounds/rounding.ts';
import type { ComponentSpan } from '../../surface/value-span.ts';

/** Rows of cells as lines of text: the first column to the left, all others to the right. */
export function textTable(table: string[][]): string {
  const rows = table.map((row) => row.map(printable));
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  const cell = (text: string, column: number) =>
    column === 0 ? text.padEnd(widths[column]) : text.padStart(widths[column]);
  return rows.map((row) => `  ${row.map(cell).join('  ').trimEnd()}`).join('\n');
}

/** Significant digits of numbers in tables. */
const digits = 4;

/** From here on a number is written with a power of ten: its other digits would be zeros that mean nothing. */
const largestPlain = 1e7;

/** A number for a table: "0.8663", "1.234e-7", "1.415e+18"; plain where all of its digits are asked for. */
export function numberText(value: number, significant = digits): string {
  const rounded = Number(value.toPrecision(significant));
  return Math.abs(rounded) < Math.max(largestPlain, 10 ** significant) ? String(rounded) : rounded.toExponential();
}

/** The two ends of a range, with as many digits as tell one from the other. */
export function rangeTexts([lowest, highest]: readonly number[]): [string, string] {
  const significant = rangeDigits(lowest, highest, digits);
  return [numberText(lowest, significant), numberText(highest, significant)];
}

/** A place in a box of such spans, an axis each, with as many digits as tell their ends apart. */
export function placeText(place: readonly number[], spans: readonly ComponentSpan[]): string {
  const texts = place.map((part, axis) => {
    const { lowest, highest } = spans[axis];
    return numberText(part, rangeDigits(lowest, highest, digits));
  });
  return `(${texts.join(', ')})`;
}

/** What share of the triangles is gone: "92.71 %"; 100 only where all are. */
export function removedText(before: number, after: number): string {
  return `${removedPercent(before, after, digits)} %`;
}

/** The same rounded up: what is guaranteed must not be written smaller than it is. */
export function roundedUpText(value: number): string {
  return numberText(roundedUp(value, digits));
}
