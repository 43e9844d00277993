import type { Mesh, Variable } from '../../../wasm/types.ts';
import { type Colormap, isDiverging } from '../../colour/colormaps.ts';
import { type ColourRange, centredOnZero, chosenRange, parseRange } from '../../colour/colour-range.ts';
import {
  allVariables,
  componentsOf,
  cornerPlaces,
  type Field,
  fieldOf,
  fieldRange,
  usedValues,
} from '../../colour/field.ts';
import type { Labels } from '../../formats/surface.ts';
import { rangeDigits } from '../../session/bounds/rounding.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import { english } from '../../words/english.ts';
import type { Quantity, ViewSettings } from '../attributes/view-settings.ts';
import { valueText } from '../number-text.ts';

/** What the colours of a surface mean: all that a legend needs. */
export interface Meaning {
  quantity: Quantity;
  title: string;
  /** What the title leaves open; empty where that is nothing. */
  detail: string;
  unit: string | undefined;
  map: Colormap;
  /** What the ends of the map stand for. */
  range: ColourRange;
  /** Whether there are values beyond the two ends, which then have colours of their own. */
  beyond?: { below: boolean; above: boolean };
  /** What is written at the two ends of the map; none where its numbers say all. */
  ends: readonly [lowest: string, highest: string] | null;
  /** Places above 1 are broken guarantees. */
  bounded: boolean;
  /** There is nothing to show, because the variable has no bound. */
  free: boolean;
  /** Somewhere there is nothing to show, because the variable is no number there. */
  missing?: boolean;
}

/** Whether one legend can stand for both. */
export function meanTheSame(one: Meaning, other: Meaning): boolean {
  return JSON.stringify(one) === JSON.stringify(other);
}

/** The colours of one surface and their meaning. */
export interface Colouring {
  /** The place in the map of every triangle corner, 0…1. */
  places: Float32Array;
  meaning: Meaning;
}

/** The values of the chosen variable on `mesh`, over the range that they have on the original surface. */
export function valueColouring(
  mesh: Mesh,
  { mesh: original, labels, variables }: OpenSurface,
  settings: ViewSettings,
): Colouring {
  const { nonFinite } = variables.find(({ name }) => name === settings.variable) ?? {};
  const whole = fieldRange(chosenField(original, settings), original.triangles);
  const range = shownRange(original, whole, settings);
  return {
    places: cornerPlaces(chosenField(mesh, settings), mesh.triangles, range),
    meaning: {
      quantity: 'value',
      title: chosenTitle(chosenVariable(mesh, settings), labels, settings),
      detail: '',
      unit: labels.units[settings.variable],
      map: settings.colormap,
      range,
      beyond: { below: whole.lowest < range.lowest, above: whole.highest > range.highest },
      ends: [
        english.legend.lowest(endText(whole.lowest, whole)),
        english.legend.highest(endText(whole.highest, whole)),
      ],
      bounded: false,
      free: false,
      ...(nonFinite ? { missing: true } : {}),
    },
  };
}

/** An end of the range of all values, with as many digits as tell it from the other one. */
function endText(value: number, { lowest, highest }: ColourRange): string {
  return valueText(value, rangeDigits(lowest, highest, 4));
}

/** What the ends of the map stand for: the values' own range, or what was chosen; around zero for maps whose middle that is. */
function shownRange({ triangles, ...mesh }: Mesh, whole: ColourRange, settings: ViewSettings): ColourRange {
  const choice = parseRange(settings.range) ?? 'data';
  if (choice !== 'data' && !('percentiles' in choice)) return choice;
  const values = () => usedValues(chosenField({ triangles, ...mesh }, settings), triangles);
  const range = choice === 'data' ? whole : chosenRange(values(), choice);
  return isDiverging(settings.colormap) ? centredOnZero(range) : range;
}

function chosenVariable(mesh: Mesh, { variable }: ViewSettings): Variable {
  const all = allVariables(mesh);
  return all.find(({ name }) => name === variable) ?? all[0];
}

function chosenField(mesh: Mesh, settings: ViewSettings): Field {
  return fieldOf(chosenVariable(mesh, settings), settings.component);
}

function chosenTitle({ name, components }: Variable, labels: Labels, { component }: ViewSettings): string {
  if (components === 1) return name;
  const label = componentsOf(components, labels.componentNames[name]).find(
    (choice) => choice.component === component,
  )?.label;
  return label ? `${name}, ${label}` : name;
}
