import { isTriangle } from '../surface/used-points.ts';
import { cornerNormals } from './corner-normals.ts';
import type { Frame, Triangles } from './frame.ts';

/**
 * A surface as it is drawn: every triangle with three corners of its own, so that a corner can carry a value of the
 * triangle as well as one of the vertex, and knows which corner it is (for the edges).
 */
export interface SurfaceArrays {
  /** x, y, z of each corner in the frame: within distance 1 of the origin. */
  corners: Float32Array<ArrayBuffer>;
  /** Normals for smooth shading, one a corner. */
  normals: Float32Array<ArrayBuffer>;
}

/** Takes time in proportion to the surface: call it in a worker (see prepareSurface). */
export function surfaceArrays({ position, triangles }: Triangles, { centre, radius }: Frame): SurfaceArrays {
  const corners = new Float32Array(3 * triangles.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    // What is no surface stays in one place: at its points there may be anything, NaN too.
    if (!isTriangle(triangles, corner - (corner % 3))) continue;
    const vertex = triangles[corner];
    for (let axis = 0; axis < 3; axis++) {
      corners[3 * corner + axis] = (position[3 * vertex + axis] - centre[axis]) / radius;
    }
  }
  const normals = cornerNormals(corners, triangles, position.length / 3);
  return { corners, normals };
}
