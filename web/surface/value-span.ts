import type { NonFinite, Variable } from '../../wasm/types.ts';
import { usedPoints } from './used-points.ts';

/** The values of one component; lowest and highest of the finite ones, infinite and empty where there is none. */
export interface ComponentSpan {
  lowest: number;
  highest: number;
}

/** What the values of a variable span, in its unit. Values that are not finite are counted and otherwise left out. */
export interface ValueSpan {
  components: ComponentSpan[];
  /** Length of the diagonal of the box of the values: max − min for a scalar. A relative bound is a fraction of it. */
  extent: number;
  /** Largest absolute value of a component. */
  magnitude: number;
  /** The extent is rounding noise; a relative bound is taken from the magnitude instead. Never said of `position`. */
  constant: boolean;
  nan: number;
  infinite: number;
  /** Left out where all values are finite. */
  nonFinite?: NonFinite;
}

/** A variable whose extent is below this fraction of its magnitude is constant up to rounding (core: constant_extent). */
const constantExtent = 1e-6;

/** Of the points that triangles use, as the core measures. */
export function spanOf({ name, components, values }: Variable, triangles: Uint32Array): ValueSpan {
  const used = usedPoints(triangles, values.length / components);
  const spans = Array.from({ length: components }, () => ({
    lowest: Number.POSITIVE_INFINITY,
    highest: Number.NEGATIVE_INFINITY,
  }));
  let [nan, infinite] = [0, 0];
  let nonFinite: NonFinite | undefined;
  let lastPoint = -1;
  for (let i = 0; i < values.length; i++) {
    const point = Math.floor(i / components);
    if (!used[point]) continue;
    const value = values[i];
    if (!Number.isFinite(value)) {
      if (Number.isNaN(value)) nan++;
      else infinite++;
      if (point !== lastPoint)
        nonFinite = { vertices: (nonFinite?.vertices ?? 0) + 1, first: nonFinite?.first ?? point };
      lastPoint = point;
      continue;
    }
    const span = spans[i % components];
    if (value < span.lowest) span.lowest = value;
    if (value > span.highest) span.highest = value;
  }
  const seen = spans.filter(({ lowest, highest }) => lowest <= highest);
  const extent = Math.hypot(...seen.map(({ lowest, highest }) => highest - lowest));
  const magnitude = Math.max(0, ...seen.map(({ lowest, highest }) => Math.max(Math.abs(lowest), Math.abs(highest))));
  const constant = name !== 'position' && extent <= constantExtent * magnitude;
  return { components: spans, extent, magnitude, constant, nan, infinite, ...(nonFinite ? { nonFinite } : {}) };
}

/** What a relative bound is a fraction of; any scale serves a variable that is zero everywhere. */
export function scaleOf({ extent, magnitude, constant }: ValueSpan): number {
  return (constant ? magnitude : extent) || 1;
}
