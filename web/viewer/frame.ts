/** What brings a surface to the size of the view: its centre goes to the origin, its farthest point to distance 1. */
export interface Frame {
  centre: readonly [x: number, y: number, z: number];
  radius: number;
}

/** The frame of all points: around the centre of their box (radius 1 where they all coincide). */
export function frameOf(position: Float32Array | Float64Array): Frame {
  const lowest = [Infinity, Infinity, Infinity];
  const highest = [-Infinity, -Infinity, -Infinity];
  for (let index = 0; index < position.length; index++) {
    const axis = index % 3;
    const coordinate = position[index];
    if (coordinate < lowest[axis]) lowest[axis] = coordinate;
    if (coordinate > highest[axis]) highest[axis] = coordinate;
  }
  const centre = [0, 1, 2].map((axis) => lowest[axis] + (highest[axis] - lowest[axis]) / 2) as [number, number, number];
  const radius = farthest(position, centre);
  return { centre, radius: radius > 0 && Number.isFinite(radius) ? radius : 1 };
}

/** The largest distance of a point from `centre`. */
function farthest(position: Float32Array | Float64Array, [x, y, z]: [number, number, number]): number {
  let squares = 0;
  for (let first = 0; first < position.length; first += 3) {
    const [dx, dy, dz] = [position[first] - x, position[first + 1] - y, position[first + 2] - z];
    squares = Math.max(squares, dx * dx + dy * dy + dz * dz);
  }
  return Math.sqrt(squares);
}
