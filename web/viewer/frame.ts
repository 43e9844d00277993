import { usedPoints } from '../surface/used-points.ts';

/** The triangles of a surface: x, y, z of each vertex and three vertex indices a triangle. */
export interface Triangles {
  position: Float32Array | Float64Array;
  triangles: Uint32Array;
}

/** What brings a surface to the size of the view: its centre goes to the origin, its farthest point to distance 1. */
export interface Frame {
  centre: readonly [x: number, y: number, z: number];
  radius: number;
}

/** The frame of the points that triangles use: around the centre of their box (radius 1 where they all coincide). */
export function frameOf({ position, triangles }: Triangles): Frame {
  const used = usedPoints(triangles, position.length / 3);
  const centre = centreOf(position, used);
  const radius = farthest(position, used, centre);
  return { centre, radius: radius > 0 && Number.isFinite(radius) ? radius : 1 };
}

function centreOf(position: Triangles['position'], used: Uint8Array): [number, number, number] {
  const lowest = [Infinity, Infinity, Infinity];
  const highest = [-Infinity, -Infinity, -Infinity];
  for (let index = 0; index < position.length; index++) {
    if (!used[Math.floor(index / 3)]) continue;
    const axis = index % 3;
    const coordinate = position[index];
    if (coordinate < lowest[axis]) lowest[axis] = coordinate;
    if (coordinate > highest[axis]) highest[axis] = coordinate;
  }
  return [0, 1, 2].map((axis) => lowest[axis] + (highest[axis] - lowest[axis]) / 2) as [number, number, number];
}

/** The largest distance of a used point from `centre`. */
function farthest(position: Triangles['position'], used: Uint8Array, [x, y, z]: [number, number, number]): number {
  let squares = 0;
  for (let point = 0; point < used.length; point++) {
    if (!used[point]) continue;
    const [dx, dy, dz] = [position[3 * point] - x, position[3 * point + 1] - y, position[3 * point + 2] - z];
    squares = Math.max(squares, dx * dx + dy * dy + dz * dz);
  }
  return Math.sqrt(squares);
}
