import type { Box, Mesh } from '../../wasm/index.ts';

/** A sentence for each box that no triangle's own box meets, so that it locks nothing. */
export function unmetBoxNotes({ position, triangles }: Mesh, boxes: readonly Box[]): string[] {
  const unmet = new Set(boxes);
  for (let first = 0; first < triangles.length && unmet.size > 0; first += 3) {
    const corners = triangles.subarray(first, first + 3);
    for (const box of unmet) if (meets(position, corners, box)) unmet.delete(box);
  }
  return [...unmet].map(({ lowest, highest }) => {
    const text = [...lowest, ...highest].join(',');
    return `--lock-box=${text} meets no triangle: nothing stays because of it.`;
  });
}

/** Whether the box of the three points meets the other one; boxes that touch meet, as they do for the core. */
function meets(position: Mesh['position'], corners: Uint32Array, { lowest, highest }: Box): boolean {
  return [0, 1, 2].every((axis) => {
    const [a, b, c] = corners;
    const [u, v, w] = [position[3 * a + axis], position[3 * b + axis], position[3 * c + axis]];
    return Math.max(u, v, w) >= lowest[axis] && Math.min(u, v, w) <= highest[axis];
  });
}
