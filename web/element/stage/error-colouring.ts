import type { Mesh, TriangleErrors } from '../../../wasm/types.ts';
import {
  flatPlaces,
  largerInSize,
  type PlaceOf,
  placeByShare,
  placeBySign,
  vertexPlaces,
} from '../../colour/error-places.ts';
import type { Labels } from '../../formats/surface.ts';
import { type Multiplied, vertexShares } from '../../probe/multiplied.ts';
import { english } from '../../words/english.ts';
import type { ViewSettings } from '../attributes/view-settings.ts';
import { isFree, isMeasured } from '../result/guarantee-words.ts';
import type { Colouring, Meaning } from './colouring.ts';

/** What the legend of an original says that keeps its values where errors are looked at. */
export const unknownErrors = english.legend.unknownErrors;

/**
 * The errors of the chosen variable on the original surface: that of every vertex, to be interpolated. Null where they are
 * not known (propagated errors).
 */
export function originalErrors(
  { triangles }: Mesh,
  reduction: Multiplied,
  labels: Labels,
  settings: ViewSettings,
): Colouring | null {
  const index = chosenIndex(reduction, settings);
  const signed = settings.quantity === 'signed-error';
  const shown = signed ? reduction.vertexErrors?.[index].signedError : vertexShares(reduction, index);
  if (!shown) return null;
  const { placeOf, meaning } = scaleOf(reduction, labels, settings);
  const detail = `${english.legend.atVertices}${note(reduction, settings)}`;
  return { places: vertexPlaces(shown, triangles, placeOf), meaning: { ...meaning, detail } };
}

/** The errors of the chosen variable on the reduced surface: the largest in every triangle, flat. */
export function reducedErrors(reduction: Multiplied, labels: Labels, settings: ViewSettings): Colouring {
  const { ratio, lowest, highest } = reduction.triangleErrors[chosenIndex(reduction, settings)];
  const { placeOf, meaning } = scaleOf(reduction, labels, settings);
  const shown = settings.quantity === 'signed-error' ? largerInSize(lowest, highest) : ratio;
  const which = isMeasured(reduction) ? english.legend.inTriangles : english.legend.limitInTriangles;
  return {
    places: flatPlaces(shown, placeOf),
    meaning: { ...meaning, detail: `${which}${note(reduction, settings)}` },
  };
}

function chosenIndex({ report }: Multiplied, { variable }: ViewSettings): number {
  return Math.max(
    0,
    report.variables.findIndex(({ name }) => name === variable),
  );
}

/** How errors become places in a map, and what that means; the same for both surfaces. */
interface Scale {
  placeOf: PlaceOf;
  meaning: Omit<Meaning, 'detail'>;
}

function scaleOf(reduction: Multiplied, labels: Labels, settings: ViewSettings): Scale {
  return settings.quantity === 'signed-error'
    ? signScale(reduction, labels, settings)
    : shareScale(reduction, settings);
}

/** Error / bound, always over 0…1. */
function shareScale(reduction: Multiplied, settings: ViewSettings): Scale {
  const variable = reduction.report.variables[chosenIndex(reduction, settings)];
  const free = isFree(variable);
  return {
    // The errors themselves are shares already.
    placeOf: placeByShare(free ? Infinity : 1),
    meaning: {
      quantity: 'error',
      title: english.legend.share(variable.name, free),
      unit: undefined,
      map: 'share',
      range: { lowest: 0, highest: 1 },
      ends: null,
      bounded: !free,
      free,
    },
  };
}

/**
 * Signed errors in the variable's unit, from −bound to +bound; as far as they reach where no bound holds them, or not the same
 * one everywhere.
 */
function signScale(reduction: Multiplied, labels: Labels, settings: ViewSettings): Scale {
  const index = chosenIndex(reduction, settings);
  const variable = reduction.report.variables[index];
  const bounded = !isFree(variable) && !isDiagnostic(reduction, settings) && !reduction.multiplier;
  const isKnown = !isDiagnostic(reduction, settings) && !Number.isNaN(variable.error);
  const largest = isKnown ? variable.error : largestSize(reduction.triangleErrors[index]);
  const reach = bounded ? variable.bound : largest;
  const { lowestBound, highestBound, lowestError, highestError } = english.legend;
  return {
    placeOf: placeBySign(reach),
    meaning: {
      quantity: 'signed-error',
      title: english.legend.signed(variable.name),
      unit: labels.units[variable.name],
      map: 'RdBu',
      range: { lowest: -reach, highest: reach },
      ends: bounded ? [lowestBound, highestBound] : [lowestError, highestError],
      bounded,
      free: false,
    },
  };
}

/** Propagated distances along normals are added up while the normals turn: the bound does not hold them (§3.3.1). */
function isDiagnostic(reduction: Multiplied, { variable }: ViewSettings): boolean {
  return variable === 'position' && !isMeasured(reduction);
}

/** Of those that are known. */
function largestSize({ lowest, highest }: TriangleErrors): number {
  const size = (largest: number, error: number) => (Math.abs(error) > largest ? Math.abs(error) : largest);
  return largerInSize(lowest, highest).reduce(size, 0);
}

/** What the sign of an error means, or what it is a share of. */
function note(reduction: Multiplied, settings: ViewSettings): string {
  if (settings.quantity !== 'signed-error') return reduction.multiplier ? english.legend.multiplied : '';
  if (settings.variable !== 'position') return english.legend.difference;
  return isDiagnostic(reduction, settings) ? english.legend.summedAlongNormals : english.legend.alongNormal;
}
