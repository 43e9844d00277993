import { faceNormals } from './corner-normals.ts';
import type { SurfaceArrays } from './surface-arrays.ts';

/** How the triangles of a morph lie on one of the two levels that it leads between. */
export interface MorphEnd {
  /** For each triangle of the morph the triangle of the level that it lies in. */
  triangle: Uint32Array;
  /** Three vertices of the level for each corner of the morph, and their weights, which add up to 1. */
  vertices: Uint32Array;
  weights: Float64Array;
}

/**
 * The same, ready to carry over what stands at the corners of the level's triangles: for each triangle of the morph one of
 * the level, and for each of its three corners the weights of the corners of that one.
 */
export interface MorphCorners {
  triangle: Uint32Array;
  weights: Float64Array;
}

/**
 * @param triangles three corners of the morph a triangle
 * @param end where these lie on the level
 * @param level three vertices of the level a triangle
 */
export function morphCorners(triangles: Uint32Array, end: MorphEnd, level: Uint32Array): MorphCorners {
  const weights = new Float64Array(3 * triangles.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const host = 3 * end.triangle[Math.floor(corner / 3)];
    for (let i = 0; i < 3; i++) weights[3 * corner + i] = weightAt(level[host + i], triangles[corner], end);
  }
  return { triangle: end.triangle, weights };
}

/** How much of a corner of the morph lies at a vertex of the level. */
function weightAt(vertex: number, corner: number, { vertices, weights }: MorphEnd): number {
  let weight = 0;
  for (let i = 3 * corner; i < 3 * corner + 3; i++) if (vertices[i] === vertex) weight += weights[i];
  return weight;
}

/**
 * Carries what stands at the corners of a level's triangles over to those of the morph, where it is linear in between: places
 * in space, normals, places in a colour map. What is the same at the three corners (an error of the triangle) stays so.
 *
 * @param numbers `size` numbers for each corner of the level's triangles
 */
export function carriedOver(numbers: Float32Array, size: number, { triangle, weights }: MorphCorners) {
  const carried = new Float32Array((weights.length / 3) * size);
  for (let corner = 0; 3 * corner < weights.length; corner++) {
    const host = 3 * triangle[Math.floor(corner / 3)];
    for (let part = 0; part < size; part++) {
      let sum = 0;
      for (let i = 0; i < 3; i++) sum += weights[3 * corner + i] * numbers[(host + i) * size + part];
      carried[corner * size + part] = sum;
    }
  }
  return carried;
}

/** A morph as it is drawn at one of its ends. The numbers that only light and edges need are rounded: they are many. */
export interface MorphArrays extends SurfaceArrays {
  /** Normals of the level's triangles, one a corner, each part in 1/32767. */
  faces: Int16Array<ArrayBuffer>;
  /** The weights of each corner in the level's triangle, in 1/65535. */
  within: Uint16Array<ArrayBuffer>;
}

/** From the level as it is drawn: the same picture, in more triangles. */
export function morphArrays({ corners, normals }: SurfaceArrays, at: MorphCorners): MorphArrays {
  return {
    corners: carriedOver(corners, 3, at),
    normals: carriedOver(normals, 3, at),
    faces: roundedFaces(corners, at),
    within: roundedWeights(at),
  };
}

function roundedFaces(corners: Float32Array, { triangle, weights }: MorphCorners): Int16Array<ArrayBuffer> {
  const { unit } = faceNormals(corners);
  // Written in a loop: a typed array's `from` takes ten times as long.
  const faces = new Int16Array(weights.length);
  for (let i = 0; i < faces.length; i++) {
    faces[i] = Math.round(32767 * unit[3 * triangle[Math.floor(i / 9)] + (i % 3)]);
  }
  return faces;
}

function roundedWeights({ weights }: MorphCorners): Uint16Array<ArrayBuffer> {
  const within = new Uint16Array(weights.length);
  for (let i = 0; i < within.length; i++) within[i] = Math.round(65535 * weights[i]);
  return within;
}
