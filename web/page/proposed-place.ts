import type { Mesh } from '../../wasm/types.ts';

/** Digits of a place that is proposed, not typed. */
const digits = 4;

export function proposed(value: number): number {
  return Number(value.toPrecision(digits));
}

/** From where surfaces are seen at first, about. */
const viewed = [1, 1, 2];

/** A place on a surface, in sight at first: the vertex farthest towards who looks at it. */
export function placeInSight({ position }: Mesh): readonly number[] {
  const nearness = (first: number) => viewed.reduce((sum, each, axis) => sum + each * position[first + axis], 0);
  let nearest = 0;
  for (let first = 3; first < position.length; first += 3) {
    if (nearness(first) > nearness(nearest)) nearest = first;
  }
  return Array.from(position.subarray(nearest, nearest + 3));
}
