/** Stands for a share where there is none to show; a surface draws negative places in the colour of the missing. */
const noShare = -1;

/** Errors are rounded up to single precision, so one that equals its bound may stand this fraction above it. */
const roundedUp = 2 ** -23;

/**
 * The share of its bound that a triangle's error uses, the same at its three corners: 0 none, 1 all, above 1 a broken
 * promise. Negative everywhere where the variable is free (its bound is not finite).
 *
 * @param largest largest error of each triangle, in the variable's unit
 * @param bound in the variable's unit
 */
export function cornerShares(largest: Float32Array, bound: number): Float32Array {
  const shares = new Float32Array(3 * largest.length);
  for (let triangle = 0; triangle < largest.length; triangle++) {
    shares.fill(shareOf(largest[triangle], bound), 3 * triangle, 3 * triangle + 3);
  }
  return shares;
}

function shareOf(error: number, bound: number): number {
  if (!Number.isFinite(bound)) return noShare;
  const share = error / bound;
  return share > 1 && share <= 1 + roundedUp ? 1 : share;
}
