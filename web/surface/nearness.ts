import { Triangle, Vector3 } from 'three';
import type { Mesh } from '../../wasm/types.ts';
import { isTriangle } from './used-points.ts';

/** How far each triangle of a mesh is from a point, at its nearest place. */
function distancesOf({ position, triangles }: Mesh, point: Vector3): Float64Array {
  const triangle = new Triangle();
  const nearest = new Vector3();
  return Float64Array.from({ length: triangles.length / 3 }, (_, index) => {
    [triangle.a, triangle.b, triangle.c].forEach((corner, i) => {
      corner.fromArray(position, 3 * triangles[3 * index + i]);
    });
    return triangle.closestPointToPoint(point, nearest).distanceTo(point);
  });
}

/** `factor` within the radius, 1 beyond twice the radius, linear in between. */
function multiplierAt(distance: number, radius: number, factor: number): number {
  const beyond = Math.min(Math.max(distance / radius - 1, 0), 1);
  return factor + beyond * (1 - factor);
}

/**
 * What multiplies the bounds at each vertex for them to be finer near a point: linear on the triangles, it is at most `factor`
 * (0…1) at every point of the surface within `radius`, and 1 where no triangle comes within twice the radius. So that no
 * triangle is too large to be near, what counts of a vertex is the nearest of the triangles around it.
 */
export function multiplierNear(
  mesh: Mesh,
  { point, radius, factor }: { point: readonly [number, number, number]; radius: number; factor: number },
): Float64Array {
  const multiplier = new Float64Array(mesh.position.length / 3).fill(1);
  distancesOf(mesh, new Vector3(...point)).forEach((distance, triangle) => {
    if (!isTriangle(mesh.triangles, 3 * triangle)) return;
    const here = multiplierAt(distance, radius, factor);
    for (const vertex of mesh.triangles.subarray(3 * triangle, 3 * triangle + 3)) {
      multiplier[vertex] = Math.min(multiplier[vertex], here);
    }
  });
  return multiplier;
}
