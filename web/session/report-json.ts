import type { Box, Report } from '../../wasm/index.ts';
import type { Bounds } from './bound-text.ts';
import type { FocusPoint } from './focus-point.ts';

/** How a reduction was asked for. */
export interface ReportOptions {
  bounds: Bounds;
  errors: 'tracked' | 'propagated';
  cost: 'max' | 'introduced';
  refusePiercing: boolean;
  limitToFeatureSize: boolean;
  dropSmallParts: boolean;
  /** The variable that multiplies the bounds. */
  focus: string | null;
  /** A place near which they are finer still. */
  focusPoint?: FocusPoint | null;
  /** The cell data that part the surface into regions. */
  region: string | null;
  /** Lists of points as people write them, `3,17,20-40`. */
  lockPoints: readonly string[];
  lockRegions: readonly number[];
  lockBoxes: readonly Box[];
}

/** The report as a file; its shape is documented in docs/command-line.md and stable. */
export function reportJson(report: Report, options: ReportOptions): string {
  const { triangles, turnedAway, dropped, featureSize = null, regions, seconds, stopped } = report;
  const variables = report.variables.map(({ name, components, extent, constant, bound, error, ratio }) => ({
    name,
    components,
    extent,
    constant,
    bound: Number.isFinite(bound) ? bound : null,
    error,
    ratio: Number.isFinite(bound) ? ratio : null,
  }));
  const vanishedRegions = regions.filter((region) => region.triangles.after === 0).map(({ label }) => label);
  const facts = { triangles, turnedAway, dropped, featureSize, variables, regions, vanishedRegions };
  return `${JSON.stringify({ ...facts, seconds, options, stopped }, undefined, 2)}\n`;
}
