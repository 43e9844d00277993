import type { Report } from '../../wasm/types.ts';

/** Of a surface without any. */
export const noOddities: Report['oddities'] = {
  repeatedVertexTriangles: 0,
  zeroAreaTriangles: 0,
  unusedVertices: 0,
  turnedTriangles: 0,
  unorientableParts: 0,
  copiedTriangles: 0,
  twoSidedTriangles: 0,
};
