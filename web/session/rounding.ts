/** 100 × 0.03 is 3.0000000000000004 in the machine's numbers; that is not above 3. */
const roundingSlack = 1e-9;

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
