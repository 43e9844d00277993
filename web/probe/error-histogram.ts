import type { Mesh, Reduction } from '../../wasm/types.ts';

/** Into how many parts error / bound, 0…1, is cut. */
export const histogramBins = 20;

/** How much of a surface has which error: shares of its area by error / bound, from 0…1/20 to 19/20…1. They add up to 1. */
export type ErrorHistogram = Float64Array;

/**
 * The errors of a variable by area. Where they were measured, each vertex of the original stands for a third of the triangles
 * around it; where they are limits (propagated errors), each reduced triangle stands for itself. Null for a free variable.
 *
 * @param index 0 for position, then the variables in their order
 */
export function errorHistogram(mesh: Mesh, reduction: Reduction, index: number): ErrorHistogram | null {
  const { bound } = reduction.report.variables[index];
  if (!Number.isFinite(bound)) return null;
  const measured = reduction.vertexErrors?.[index].error;
  return measured
    ? histogram(measured, vertexAreas(mesh), bound)
    : histogram(reduction.triangleErrors[index].largest, triangleAreas(reduction.mesh), bound);
}

function histogram(errors: Float32Array, areas: Float64Array, bound: number): ErrorHistogram {
  const bins = new Float64Array(histogramBins);
  let whole = 0;
  for (let each = 0; each < errors.length; each++) {
    // All of the bound belongs to the last part.
    bins[Math.min(histogramBins - 1, Math.floor((histogramBins * errors[each]) / bound))] += areas[each];
    whole += areas[each];
  }
  return whole > 0 ? bins.map((area) => area / whole) : bins;
}

function vertexAreas(mesh: Mesh): Float64Array {
  const ofTriangles = triangleAreas(mesh);
  const areas = new Float64Array(mesh.position.length / 3);
  mesh.triangles.forEach((vertex, corner) => {
    areas[vertex] += ofTriangles[Math.floor(corner / 3)] / 3;
  });
  return areas;
}

function triangleAreas({ position, triangles }: Mesh): Float64Array {
  const edge = (from: number, to: number, axis: number) => position[3 * to + axis] - position[3 * from + axis];
  return Float64Array.from({ length: triangles.length / 3 }, (_, triangle) => {
    const [a, b, c] = triangles.subarray(3 * triangle, 3 * triangle + 3);
    const part = (i: number, j: number) => edge(a, b, i) * edge(a, c, j) - edge(a, b, j) * edge(a, c, i);
    return Math.hypot(part(1, 2), part(2, 0), part(0, 1)) / 2;
  });
}
