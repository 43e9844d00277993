/** Whether the triangle that begins at this corner names three distinct points; others are no surface. */
export function isTriangle(triangles: Uint32Array, first: number): boolean {
  const [a, b, c] = [triangles[first], triangles[first + 1], triangles[first + 2]];
  return a !== b && b !== c && c !== a;
}

/** By point 1 where a triangle of three distinct points uses it; what stands at the others counts for nothing. */
export function usedPoints(triangles: Uint32Array, points: number): Uint8Array {
  const used = new Uint8Array(points);
  for (let first = 0; first < triangles.length; first += 3) {
    if (!isTriangle(triangles, first)) continue;
    for (let corner = first; corner < first + 3; corner++) used[triangles[corner]] = 1;
  }
  return used;
}

/** The triangles of three distinct points; the array itself where there are no others. */
export function properTriangles(triangles: Uint32Array): Uint32Array {
  let kept = 0;
  for (let first = 0; first < triangles.length; first += 3) if (isTriangle(triangles, first)) kept += 3;
  if (kept === triangles.length) return triangles;
  const proper = new Uint32Array(kept);
  for (let first = 0, at = 0; first < triangles.length; first += 3) {
    if (!isTriangle(triangles, first)) continue;
    proper.set(triangles.subarray(first, first + 3), at);
    at += 3;
  }
  return proper;
}
