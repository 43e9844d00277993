import { missingPlace } from './missing-place.ts';

/** Errors are rounded up to single precision, so one that equals its bound may stand this fraction above it. */
const roundedUp = 2 ** -23;

/** As single precision holds it. */
const missing = Math.fround(missingPlace);

/** The place of an error in a map; above 1 a broken guarantee, `missingPlace` where there is nothing to show. */
export type PlaceOf = (error: number) => number;

/**
 * Error / bound: 0 no error, 1 all that is allowed. Nothing to show where the variable is free (its bound is not finite), nor
 * where the error is not known (NaN).
 */
export function placeByShare(bound: number): PlaceOf {
  if (!Number.isFinite(bound)) return () => missingPlace;
  return (error) => (Number.isNaN(error) ? missingPlace : shareOf(error, bound));
}

/** Signed errors in a map centred on zero: 0 is −reach, ½ is no error, 1 is +reach. Nothing to show where it is NaN. */
export function placeBySign(reach: number): PlaceOf {
  return (error) => {
    if (Number.isNaN(error)) return missingPlace;
    const share = shareOf(Math.abs(error), reach);
    // Beyond either end is beyond the bound.
    if (share > 1) return share;
    return (1 + Math.sign(error) * share) / 2;
  };
}

function shareOf(error: number, whole: number): number {
  if (error === 0) return 0;
  const share = error / whole;
  return share > 1 && share <= 1 + roundedUp ? 1 : share;
}

/** The places of errors of triangles, flat: the same at the three corners of each. */
export function flatPlaces(errors: Float32Array, placeOf: PlaceOf): Float32Array {
  const places = new Float32Array(3 * errors.length);
  errors.forEach((error, triangle) => {
    places.fill(placeOf(error), 3 * triangle, 3 * triangle + 3);
  });
  return places;
}

/**
 * The places of errors of vertices at the triangles' corners, to be interpolated; `missingPlace` at all corners of a triangle
 * that has a corner where there is nothing to show.
 */
export function vertexPlaces(
  errors: Float32Array | Float64Array,
  triangles: Uint32Array,
  placeOf: PlaceOf,
): Float32Array {
  const ofVertices = Float32Array.from(errors, placeOf);
  const places = Float32Array.from(triangles, (vertex) => ofVertices[vertex]);
  for (let first = 0; first < places.length; first += 3) {
    const corners = places.subarray(first, first + 3);
    if (corners.includes(missing)) corners.fill(missing);
  }
  return places;
}

/** Of two signed errors for each triangle the one that is larger in size, with its sign. */
export function largerInSize(lowest: Float32Array, highest: Float32Array): Float32Array {
  return lowest.map((low, triangle) => (-low > highest[triangle] ? low : highest[triangle]));
}
