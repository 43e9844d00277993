import type { Mesh } from '../../../wasm/types.ts';
import type { WriteOptions } from '../surface.ts';

/** What a file holds of labels of the triangles: the names of the arrays, and a label for each triangle. */
export function labelArrays(
  { regions }: Mesh,
  { regionName = 'regions', cellData = new Map() }: Pick<WriteOptions, 'regionName' | 'cellData'>,
): [name: string, labels: Int32Array][] {
  return [...(regions ? new Map([[regionName, regions]]) : []), ...cellData];
}
