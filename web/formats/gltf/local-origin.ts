import type { Mesh } from '../../../wasm/types.ts';

export type Origin = [x: number, y: number, z: number];

/** Single precision is relative to the distance from the origin: a surface so many times its size away needs one of its own. */
const farAway = 1;
/** The origin is a multiple of the power of two that is about this fraction of the size, so that doubles hold it exactly. */
const gridShare = 1 / 16;

/**
 * From where single precision holds the places of a surface well: the origin itself, unless the surface lies far from it and
 * is not in single precision already. Points of no triangle do not count.
 */
export function localOrigin({ position, triangles }: Pick<Mesh, 'position' | 'triangles'>): Origin {
  if (position instanceof Float32Array) return [0, 0, 0];
  const lowest = [Infinity, Infinity, Infinity];
  const highest = [-Infinity, -Infinity, -Infinity];
  for (const corner of triangles) {
    for (let axis = 0; axis < 3; axis++) {
      const value = position[3 * corner + axis];
      lowest[axis] = Math.min(lowest[axis], value);
      highest[axis] = Math.max(highest[axis], value);
    }
  }
  const size = Math.hypot(...highest.map((value, axis) => value - lowest[axis]));
  if (!(size > 0 && Number.isFinite(size))) return [0, 0, 0];
  const grid = 2 ** Math.floor(Math.log2(size * gridShare));
  const middle = lowest.map((value, axis) => Math.round((value / 2 + highest[axis] / 2) / grid) * grid);
  return middle.map((value) => (Math.abs(value) > farAway * size ? value : 0)) as Origin;
}
