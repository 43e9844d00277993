/**
 * Integers as the mesh holds numbers: in single precision where every value survives it, else in double precision.
 * Values beyond 2^53 (64-bit integers) have no exact double either.
 */
export function asFloatingPoint(values: Float32Array | Float64Array): Float32Array | Float64Array {
  if (values instanceof Float32Array) return values;
  for (let i = 0; i < values.length; i++) {
    if (Math.fround(values[i]) !== values[i]) return values;
  }
  return Float32Array.from(values);
}
