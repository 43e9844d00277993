/** 100 × 0.03 is 3.0000000000000004 in the machine's numbers; that is not above 3. */
const roundingSlack = 1e-9;

/** As many signs have room in a field. */
const fieldLength = 9;

/** A number as a field shows it: as it is where that has room, else with four significant digits. */
export function fieldText(value: number): string {
  const whole = String(value);
  if (whole.length <= fieldLength) return whole;
  const rounded = Number(value.toPrecision(4));
  const plain = String(rounded);
  return plain.length <= fieldLength ? plain : rounded.toExponential().replace('e+', 'e');
}

/**
 * A number rounded up to so many significant digits. Bounds and errors are both written so: neither is written smaller
 * than it is, and an error within its bound is never written above it.
 */
export function roundedUp(value: number, digits: number): number {
  return inSteps(value, digits, (count) => Math.ceil(count - roundingSlack));
}

/** The same rounded down: what is short of a whole must not be written as one. */
export function roundedDown(value: number, digits: number): number {
  return inSteps(value, digits, (count) => Math.floor(count + roundingSlack));
}

/** `value` ≥ 0 counted in units of its last significant digit; those may be 1e-320, so the digits are counted as text. */
function inSteps(value: number, digits: number, whole: (count: number) => number): number {
  if (value === 0 || !Number.isFinite(value)) return value;
  const [significand, exponent] = value.toExponential().split('e').map(Number);
  return Number(`${whole(significand * 10 ** (digits - 1))}e${exponent - digits + 1}`);
}

/** More digits than these no double has. */
const mostDigits = 17;

/** Of a span so much is worth a digit: with the last one it is told to a hundredth at least. */
const spanDigits = 3;

/** How many significant digits tell a number of this size from one that lies `span` beside it; never fewer than `least`. */
export function tellingDigits(size: number, span: number, least: number): number {
  if (!(span > 0) || !Number.isFinite(size / span)) return least;
  return Math.min(mostDigits, Math.max(least, Math.ceil(Math.log10(Math.abs(size) / span)) + spanDigits));
}

/** The same for the two ends of a range. */
export function rangeDigits(lowest: number, highest: number, least: number): number {
  return tellingDigits(Math.max(Math.abs(lowest), Math.abs(highest)), highest - lowest, least);
}

/**
 * What share of `before` is gone, in percent, with so many significant digits; 100 only where nothing is left: of
 * 320 000 to 2 it is 99.999, however few digits were asked for.
 */
export function removedPercent(before: number, after: number, digits: number): number {
  const left = (100 * after) / before;
  const rounded = Number((100 - left).toPrecision(digits));
  if (rounded < 100 || after === 0) return rounded;
  const nines = 10 ** Math.max(1, Math.ceil(-Math.log10(left)) - 1);
  return Math.floor((100 - left) * nines + roundingSlack) / nines;
}
