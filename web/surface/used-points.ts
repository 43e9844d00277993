/** By point 1 where a triangle of three distinct points uses it; what stands at the others counts for nothing. */
export function usedPoints(triangles: Uint32Array, points: number): Uint8Array {
  const used = new Uint8Array(points);
  for (let first = 0; first < triangles.length; first += 3) {
    const [a, b, c] = [triangles[first], triangles[first + 1], triangles[first + 2]];
    if (a === b || b === c || c === a) continue;
    used[a] = used[b] = used[c] = 1;
  }
  return used;
}
