/**
 * A place near which the bounds are finer: within `radius` of it they are multiplied by `factor`, and from there on they rise
 * to what they are elsewhere, at twice the radius.
 */
export interface FocusPoint {
  /** In the unit of position, as the radius. */
  point: readonly [x: number, y: number, z: number];
  radius: number;
  factor: number;
}

/** As people write it, `x,y,z,radius,factor`. Throws an Error whose message is a sentence for people. */
export function readFocusPoint(text: string): FocusPoint {
  const words = text.split(/\s*[,;]\s*|\s+/).filter((word) => word !== '');
  const numbers = words.map(Number);
  if (numbers.length !== 5 || !numbers.every(Number.isFinite)) {
    throw new Error('a focus point has five numbers, x,y,z of its point, its radius and its factor.');
  }
  const [x, y, z, radius, factor] = numbers;
  if (!(radius > 0)) throw new Error('the radius of a focus point must be above zero.');
  if (!(factor > 0 && factor <= 1)) throw new Error('the factor of a focus point must be above zero and at most 1.');
  return { point: [x, y, z], radius, factor };
}

/** The text that `readFocusPoint` reads as this focus point. */
export function focusPointText({ point, radius, factor }: FocusPoint): string {
  return [...point, radius, factor].join(',');
}
