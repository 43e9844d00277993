/**
 * Texture coordinates u, v with v measured from the other edge of the picture: glTF counts it downwards from the upper edge, all
 * else that is read here upwards from the lower one. In double precision this is exact, but for a v nearer to 0 than 2^-29.
 */
export function upsideDown(values: Float32Array | Float64Array): Float64Array {
  return Float64Array.from(values, (value, i) => (i % 2 === 1 ? 1 - value : value));
}
