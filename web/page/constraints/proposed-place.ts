import type { Mesh } from '../../../wasm/types.ts';
import { usedPoints } from '../../surface/used-points.ts';

/** Digits of a place that is proposed, not typed. */
const digits = 4;

export function proposed(value: number): number {
  return Number(value.toPrecision(digits));
}

/** From where surfaces are seen at first, about. */
const viewed = [1, 1, 2];

/** A place on a surface, in sight at first: the used vertex farthest towards who looks at it. */
export function placeInSight({ position, triangles }: Mesh): readonly number[] {
  const used = usedPoints(triangles, position.length / 3);
  const nearness = (first: number) => viewed.reduce((sum, each, axis) => sum + each * position[first + axis], 0);
  let nearest = 3 * used.indexOf(1);
  for (let first = nearest; first < position.length; first += 3) {
    if (used[first / 3] && nearness(first) > nearness(nearest)) nearest = first;
  }
  return Array.from(position.subarray(nearest, nearest + 3));
}
