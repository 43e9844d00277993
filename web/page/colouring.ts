import type { Mesh, Reduction, Variable } from '../../wasm/types.ts';
import type { Colormap } from '../colour/colormaps.ts';
import { type ColourRange, centredOnZero } from '../colour/colour-range.ts';
import { cornerShares } from '../colour/error-share.ts';
import { allVariables, componentsOf, cornerPlaces, type Field, fieldOf, fieldRange } from '../colour/field.ts';
import type { Labels } from '../formats/surface.ts';
import type { OpenSurface } from '../session/session.ts';
import type { ViewSettings } from './view-settings.ts';

/** What the colours of a surface mean: all that a legend needs. */
export interface Meaning {
  title: string;
  unit: string | undefined;
  map: Colormap;
  /** What the ends of the map stand for. */
  range: ColourRange;
  /** What the original surface holds. */
  data: ColourRange;
  /** Error / bound: a place above 1 is a broken promise. */
  share: boolean;
}

/** The colours of one surface and their meaning. */
export interface Colouring {
  /** The place in the map of every triangle corner, 0…1. */
  places: Float32Array;
  meaning: Meaning;
}

/** The values of the chosen variable on `mesh`, over the range that they have on the original surface. */
export function valueColouring(mesh: Mesh, { mesh: original, labels }: OpenSurface, settings: ViewSettings): Colouring {
  const whole = fieldRange(chosenField(original, settings), original.triangles);
  const range = settings.map === 'diverging' ? centredOnZero(whole) : whole;
  return {
    places: cornerPlaces(chosenField(mesh, settings), mesh.triangles, range),
    meaning: {
      title: chosenTitle(chosenVariable(mesh, settings), labels, settings),
      unit: labels.units[settings.variable],
      map: settings.map,
      range,
      data: whole,
      share: false,
    },
  };
}

const fullShare: ColourRange = { lowest: 0, highest: 1 };

/** Error / bound of one variable on every triangle of a reduced surface, always over 0…1. */
export function errorColouring({ triangleErrors, report }: Reduction, variable: string): Colouring {
  const index = Math.max(
    0,
    report.variables.findIndex(({ name }) => name === variable),
  );
  const { name, bound } = report.variables[index];
  const title = `error / bound: ${name}${Number.isFinite(bound) ? '' : ' (free: no bound)'}`;
  return {
    places: cornerShares(triangleErrors[index].largest, bound),
    meaning: { title, unit: undefined, map: 'share', range: fullShare, data: fullShare, share: true },
  };
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
