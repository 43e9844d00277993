import type { ValueColormap } from '../colour/colormaps.ts';
import { type Component, componentsOf } from '../colour/field.ts';
import type { OpenSurface } from '../session/session.ts';

/** How the surfaces are looked at. */
export interface ViewSettings {
  /** What both surfaces are coloured by. */
  variable: string;
  component: Component;
  map: ValueColormap;
  /** The variable whose error / bound the reduced side shows instead of values; null for values. */
  errorOf: string | null;
  /** Flat shading with edges: the tessellation. */
  edges: boolean;
  /** One camera for both sides. */
  linked: boolean;
}

export const firstView: ViewSettings = {
  variable: 'position',
  component: 'magnitude',
  map: 'viridis',
  errorOf: null,
  edges: false,
  linked: true,
};

/** The same view of another surface: what it does not have is replaced, a variable by the first one that varies. */
export function settingsFor({ variables }: OpenSurface, settings: ViewSettings): ViewSettings {
  const has = (name: string | null) => variables.some((variable) => variable.name === name);
  const errorOf = has(settings.errorOf) ? settings.errorOf : null;
  if (settings.variable !== 'position' && has(settings.variable)) return { ...settings, errorOf };
  const [position, ...data] = variables;
  const { name, components } = data.find(({ constant }) => !constant) ?? data[0] ?? position;
  return { ...settings, errorOf, variable: name, component: componentsOf(components)[0].component };
}
