import type { Mesh } from '../../wasm/types.ts';
import { isTriangle } from '../surface/used-points.ts';
import { type Multiplied, vertexShares } from './multiplied.ts';
import { normalOf } from './place.ts';

/** Into how many parts error / bound, 0…1, is cut. */
export const histogramBins = 20;

/** How much of a surface has which error. */
export interface ErrorHistogram {
  /** Shares of its area by error / bound, from 0…1/20 to 19/20…1. They add up to 1. */
  parts: Float64Array;
  /** Of half and of 95 % of the area no error / bound is larger than this. */
  half: number;
  most: number;
}

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

function histogram(shares: Float32Array | Float64Array, areas: Float64Array): ErrorHistogram {
  const parts = new Float64Array(histogramBins);
  let whole = 0;
  for (let each = 0; each < shares.length; each++) {
    // What has no area does not count: at a vertex that no triangle uses nothing is known.
    if (areas[each] === 0) continue;
    // All of the bound belongs to the last part.
    parts[Math.min(histogramBins - 1, Math.floor(histogramBins * shares[each]))] += areas[each];
    whole += areas[each];
  }
  const [half, most] = quantiles(shares, areas, whole);
  return { parts: whole > 0 ? parts.map((area) => area / whole) : parts, half, most };
}

/** The smallest values that half and 95 % of the area do not exceed. */
function quantiles(shares: Float32Array | Float64Array, areas: Float64Array, whole: number): [number, number] {
  const order = Uint32Array.from(shares.keys())
    .filter((each) => areas[each] > 0)
    .sort((a, b) => shares[a] - shares[b]);
  let sum = 0;
  let next = 0;
  const reached = (share: number): number => {
    // Added up, all areas may miss the whole by rounding.
    while (next < order.length - 1 && sum + areas[order[next]] < share * whole) sum += areas[order[next++]];
    return order.length > 0 ? shares[order[next]] : 0;
  };
  return [reached(0.5), reached(0.95)];
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
    if (!isTriangle(mesh.triangles, 3 * triangle)) continue;
    const [x, y, z] = normalOf(mesh, triangle);
    areas[triangle] = Math.sqrt(x * x + y * y + z * z) / 2;
  }
  return areas;
}
