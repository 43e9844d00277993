import type { Box, Report } from '../../../wasm/index.ts';
import type { Bounds } from '../bounds/bound-text.ts';
import type { FocusPoint } from '../constraints/focus-point.ts';
import { whyLittleWent } from './why-little-went.ts';

/** How a reduction was asked for. */
export interface ReportOptions {
  bounds: Bounds;
  errors: 'tracked' | 'propagated';
  cost: 'maximum' | 'introduced';
  refusePiercing: boolean;
  limitToFeatureSize: boolean;
  dropSmallComponents: boolean;
  /** The variable that multiplies the bounds. */
  boundMultiplier: string | null;
  /** A place near which they are finer still. */
  focusPoint?: FocusPoint | null;
  /** The cell data that part the surface into regions. */
  region: string | null;
  /** Lists of points as people write them, `3,17,20-40`. */
  lockPoints: readonly string[];
  /** Their numbers, or what they are called. */
  lockRegions: readonly (number | string)[];
  lockBoxes: readonly Box[];
}

/** What the reading of a file found of points in one place, where that is known. */
export interface Seams {
  /** Points on seams, reduced together. */
  points: number;
  /** Points where sheets touch without a seam; they stay. */
  touching: number;
}

/** What is known beside the report, where it is. */
export interface ReportSurroundings {
  seams?: Seams;
  /** What the labels of regions stand for. */
  names?: ReadonlyMap<number, string>;
  /** The file whose errors these are; errors are those in memory where there is none. */
  file?: string;
}

/**
 * The report as a file; its shape is documented in docs/command-line.md and stable.
 */
export function reportJson(
  report: Report,
  options: ReportOptions,
  { seams, names, file }: ReportSurroundings = {},
): string {
  const {
    triangles,
    flippedNormals,
    dropped,
    featureSize = null,
    unusedLockedBoxes,
    nonManifoldVertices,
    seconds,
    termination,
  } = report;
  const { flippedTriangles, unorientableComponents, copiedTriangles, twoSidedTriangles } = report.defects;
  const { cells, foldedCells } = report;
  const variables = report.variables.map(
    ({
      name,
      components,
      kind = 'quantity',
      nonFinite = null,
      extent,
      constant,
      bound,
      error,
      ratio,
      rounding = 0,
    }) => ({
      name,
      components,
      kind,
      extent,
      constant,
      bound: Number.isFinite(bound) ? bound : null,
      error: Number.isNaN(error) ? null : error,
      nonFinite,
      ratio: Number.isFinite(bound) ? ratio : null,
      ...(rounding > 0 ? { rounding } : {}),
    }),
  );
  const regions = report.regions.map(({ label, ...rest }) => ({ label, name: names?.get(label), ...rest }));
  const vanishedRegions = regions.filter((region) => region.triangles.after === 0).map(({ label }) => label);
  const facts = {
    file,
    triangles,
    defects: { flippedTriangles, unorientableComponents, copiedTriangles, twoSidedTriangles },
    nonManifoldVertices,
    seams,
    map: options.errors === 'tracked' ? { cells, foldedCells } : null,
    flippedNormals,
    dropped,
    featureSize,
    unusedLockedBoxes,
    variables,
    refused: refusedFacts(report),
    regions,
    vanishedRegions,
  };
  return `${JSON.stringify({ ...facts, seconds, options, termination }, undefined, 2)}\n`;
}

/** Why vertices that are left could not go; what of them was the reason that little went, where the bounds were not. */
function refusedFacts(report: Report) {
  const bounds = Object.fromEntries(report.variables.map(({ name, refused }) => [name, refused]));
  return { candidates: report.candidates, bounds, ...report.refused, whyLittleWent: whyLittleWent(report) ?? null };
}
