import type { Variable } from '../../../wasm/types.ts';
import { type Declared, roleOf } from './roles.ts';

// A colour keeps the numbers of its file, 0…255 where that has bytes, so that a bound means the same whichever of the formats
// it came from: uchar in PLY and VTK, normalised bytes in glTF, 255ths from 0 to 1 in OBJ. Fractions stay fractions.

const brightest = 255;

/** OBJ files have 255ths with some digits; so far from one a number is another. */
const digitsLost = 1e-3;

/** Whether the numbers of a colour are bytes. Zeros and ones alone are fractions. */
export function areBytes(values: Variable['values']): boolean {
  const isByte = (value: number) =>
    value >= 0 && value <= brightest && Number.isInteger(value) && !Object.is(value, -0);
  return values.every(isByte) && values.some((value: number) => value > 1);
}

/** Whether this is a colour of bytes, by its name or by what its file declares. */
export function isByteColour(variable: Variable, declared: Declared = {}): boolean {
  return roleOf(variable, declared) === 'colour' && areBytes(variable.values);
}

/** The numbers of a colour as fractions, as OBJ has them. */
export function asFractions(values: Variable['values']): Variable['values'] {
  return areBytes(values) ? Float64Array.from(values, (value) => value / brightest) : values;
}

/** Fractions as bytes where they all are 255ths; else as they are. */
export function asBytes(values: Variable['values']): Variable['values'] {
  const isShare = (value: number) =>
    value >= 0 && value <= 1 && Math.abs(brightest * value - Math.round(brightest * value)) <= digitsLost;
  return values.every(isShare) ? Float32Array.from(values, (value) => Math.round(brightest * value)) : values;
}
