import type { Box } from '../../../wasm/types.ts';

/**
 * A box as people write it: the lowest and the highest place along the axes, `0,0,0,1,1,1`. Throws an Error whose message
 * is a sentence for people.
 */
export function readBox(text: string): Box {
  const words = text.split(/\s*[,;]\s*|\s+/).filter((word) => word !== '');
  const numbers = words.map(Number);
  if (numbers.length !== 6 || numbers.some(Number.isNaN)) {
    throw new Error('a box has six numbers, x,y,z of its lowest and x,y,z of its highest corner.');
  }
  const [x, y, z, right, top, front] = numbers;
  if (!(x <= right && y <= top && z <= front)) {
    throw new Error('along some axis its lowest place is above its highest.');
  }
  return { lowest: [x, y, z], highest: [right, top, front] };
}

/** The text that `readBox` reads as this box. */
export function boxText({ lowest, highest }: Box): string {
  return [...lowest, ...highest].join(',');
}
