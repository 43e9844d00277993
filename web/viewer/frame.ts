/** What brings a surface to the size of the view: its centre goes to the origin, its farthest point to distance 1. */
export interface Frame {
  centre: readonly [x: number, y: number, z: number];
  radius: number;
}

/**
 * The frame of the points that triangles use: around the centre of their box (radius 1 where they all coincide). Others are no
 * part of the surface, and may lie anywhere.
 */
export function frameOf(position: Float32Array | Float64Array, triangles: Uint32Array): Frame {
  const lowest = [Infinity, Infinity, Infinity];
  const highest = [-Infinity, -Infinity, -Infinity];
  for (const vertex of triangles) {
    for (let axis = 0; axis < 3; axis++) {
      const coordinate = position[3 * vertex + axis];
      if (coordinate < lowest[axis]) lowest[axis] = coordinate;
      if (coordinate > highest[axis]) highest[axis] = coordinate;
    }
  }
  const centre = [0, 1, 2].map((axis) => lowest[axis] + (highest[axis] - lowest[axis]) / 2) as [number, number, number];
  const radius = farthest(position, triangles, centre);
  return { centre, radius: radius > 0 && Number.isFinite(radius) ? radius : 1 };
}

/** The largest distance of a corner from `centre`. */
function farthest(
  position: Float32Array | Float64Array,
  triangles: Uint32Array,
  [x, y, z]: readonly [number, number, number],
): number {
  let squares = 0;
  for (const vertex of triangles) {
    const [dx, dy, dz] = [position[3 * vertex] - x, position[3 * vertex + 1] - y, position[3 * vertex + 2] - z];
    squares = Math.max(squares, dx * dx + dy * dy + dz * dz);
  }
  return Math.sqrt(squares);
}
