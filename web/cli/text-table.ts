import { printable } from '../formats/wording.ts';
import { roundedUp } from '../session/rounding.ts';

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

/** A number for a table: "0.8663", "1.234e-7", "1.415e+18". */
export function numberText(value: number): string {
  const rounded = Number(value.toPrecision(digits));
  return Math.abs(rounded) < largestPlain ? String(rounded) : rounded.toExponential();
}

/** The same rounded up: what is guaranteed must not be written smaller than it is. */
export function roundedUpText(value: number): string {
  return numberText(roundedUp(value, digits));
}
