import type { Report } from '../../../wasm/index.ts';
import { counted, grouped } from '../../formats/text/wording.ts';

/** A line for the triangles that turn away from the original, and one for what the map folds; none where there are none. */
export function turnLines({ flippedNormals: { before, after }, cells, foldedCells }: Report): string[] {
  const turned = `turned more than a right angle against the original: ${grouped(before)} -> ${counted(after, 'triangle')}`;
  const folded = `folded by the map: ${grouped(foldedCells)} of ${counted(cells, 'cell')}`;
  return [...(before > 0 || after > 0 ? [turned] : []), ...(foldedCells > 0 ? [folded] : [])];
}
