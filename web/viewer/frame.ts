/** What brings a surface to the size of the view: its centre goes to the origin, its farthest point to distance 1. */
export interface Frame {
  centre: readonly [x: number, y: number, z: number];
  radius: number;
}

/** The frame of all points: the centre of their box and half of its diagonal (1 where they all coincide). */
export function frameOf(position: Float32Array | Float64Array): Frame {
  const lowest = [Infinity, Infinity, Infinity];
  const highest = [-Infinity, -Infinity, -Infinity];
  for (let index = 0; index < position.length; index++) {
    const axis = index % 3;
    const coordinate = position[index];
    if (coordinate < lowest[axis]) lowest[axis] = coordinate;
    if (coordinate > highest[axis]) highest[axis] = coordinate;
  }
  const half = lowest.map((low, axis) => (highest[axis] - low) / 2);
  const radius = Math.hypot(...half);
  return {
    centre: [lowest[0] + half[0], lowest[1] + half[1], lowest[2] + half[2]],
    radius: radius > 0 && Number.isFinite(radius) ? radius : 1,
  };
}
