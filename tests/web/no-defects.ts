import type { Report } from '../../wasm/types.ts';

/** Of a surface without any. */
export const noDefects: Report['defects'] = {
  repeatedVertexTriangles: 0,
  zeroAreaTriangles: 0,
  unusedVertices: 0,
  flippedTriangles: 0,
  unorientableComponents: 0,
  copiedTriangles: 0,
  twoSidedTriangles: 0,
};
