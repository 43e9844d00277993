import type { Mesh } from '../../wasm/types.ts';
import { type Multiplied, vertexShares } from './multiplied.ts';
import { normalOf } from './place.ts';

/** Into how many parts error / bound, 0…1, is cut. */
export const histogramBins = 20;

/** How much of a surface has which error: shares of its area by error / bound, from 0…1/20 to 19/20…1. They add up to 1. */
export type ErrorHistogram = Float64Array;

/**
 * The errors of each variable by area: position first, then the variables in their order; null for a free one. Where errors
 * were measured, each vertex of the original stands for a third of the triangles around it; where they are limits (propagated
 * errors), each reduced triangle stands for itself.
 */
export function errorHistograms(mesh: Mesh, reduction: Multiplied): (ErrorHistogram | null)[] {
  const { vertexErrors, triangleErrors, report } = reduction;
  const areas = vertexErrors ? vertexAreas(mesh) : triangleAreas(reduction.mesh);
  return report.variables.map(({ bound }, index) => {
    if (!Number.isFinite(bound)) return null;
    return histogram(vertexShares(reduction, index) ?? triangleErrors[index].ratio, areas);
  });
}

/** Below which error / bound this share of the area certainly stays: the end of one of the histogram's parts. */
export function quantile(histogram: ErrorHistogram, share: number): number {
  let sum = 0;
  // Added up, all parts may miss 1 by rounding.
  const last = histogram.findIndex((part) => {
    sum += part;
    return sum >= share;
  });
  return last < 0 ? 1 : (last + 1) / histogramBins;
}

function histogram(shares: Float32Array | Float64Array, areas: Float64Array): ErrorHistogram {
  const bins = new Float64Array(histogramBins);
  let whole = 0;
  for (let each = 0; each < shares.length; each++) {
    // All of the bound belongs to the last part.
    bins[Math.min(histogramBins - 1, Math.floor(histogramBins * shares[each]))] += areas[each];
    whole += areas[each];
  }
  return whole > 0 ? bins.map((area) => area / whole) : bins;
}

function vertexAreas(mesh: Mesh): Float64Array {
  const ofTriangles = triangleAreas(mesh);
  const areas = new Float64Array(mesh.position.length / 3);
  for (let corner = 0; corner < mesh.triangles.length; corner++) {
    areas[mesh.triangles[corner]] += ofTriangles[Math.floor(corner / 3)] / 3;
  }
  return areas;
}

function triangleAreas(mesh: Mesh): Float64Array {
  const areas = new Float64Array(mesh.triangles.length / 3);
  for (let triangle = 0; triangle < areas.length; triangle++) {
    const [x, y, z] = normalOf(mesh, triangle);
    areas[triangle] = Math.sqrt(x * x + y * y + z * z) / 2;
  }
  return areas;
}
