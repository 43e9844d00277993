import type { Report } from '../../wasm/index.ts';
import type { Bounds } from './bound-text.ts';

/** How a reduction was asked for. */
export interface ReportOptions {
  bounds: Bounds;
  errors: 'tracked' | 'propagated';
  cost: 'max' | 'introduced';
  refusePiercing: boolean;
  limitToFeatureSize: boolean;
}

/** The report as a file; its shape is documented in docs/command-line.md and stable. */
export function reportJson(report: Report, options: ReportOptions): string {
  const { triangles, turnedAway, dropped, featureSize = null, seconds, stopped } = report;
  const variables = report.variables.map(({ name, components, extent, constant, bound, error, ratio }) => ({
    name,
    components,
    extent,
    constant,
    bound: Number.isFinite(bound) ? bound : null,
    error,
    ratio: Number.isFinite(bound) ? ratio : null,
  }));
  return `${JSON.stringify({ triangles, turnedAway, dropped, featureSize, variables, seconds, options, stopped }, undefined, 2)}\n`;
}
