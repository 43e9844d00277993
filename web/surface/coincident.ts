/** How many triangles lie on the three points of another one, as the core counts them. */
export interface Coincident {
  /** Those that face as an earlier one does. */
  copiedTriangles: number;
  /** Pairs that face opposite ways: two sides of one sheet. */
  twoSidedTriangles: number;
}

/** Of triangles of three distinct points; three indices each. */
export function coincidentIn(triangles: Uint32Array, points: number): Coincident {
  /** By the two lower points of a triangle and the third one: which ways triangles face there, bit 1 and bit 2. */
  const facing = new Map<number, Map<number, number>>();
  let [copiedTriangles, twoSidedTriangles] = [0, 0];
  for (let corner = 0; corner < triangles.length; corner += 3) {
    const [a, b, c] = triangles.subarray(corner, corner + 3);
    if (a === b || b === c || c === a) continue;
    const [low, middle, high] = [a, b, c].sort((one, other) => one - other);
    const way = (b - a) * (c - b) * (a - c) < 0 ? 1 : 2;
    const key = low * points + middle;
    const here = facing.get(key) ?? new Map<number, number>();
    const before = here.get(high) ?? 0;
    if (before & way) copiedTriangles++;
    else if (before !== 0) twoSidedTriangles++;
    here.set(high, before | way);
    facing.set(key, here);
  }
  return { copiedTriangles, twoSidedTriangles };
}
