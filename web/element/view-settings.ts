import type { ValueColormap } from '../colour/colormaps.ts';
import { type Component, componentsOf } from '../colour/field.ts';
import type { OpenSurface } from '../session/session.ts';

/** What is shown of a variable: its values, the errors as shares of the bound, or the errors with their signs. */
export type Quantity = 'value' | 'error' | 'signed-error';

/** How the surfaces are looked at. */
export interface ViewSettings {
  /** What both surfaces are coloured by. */
  variable: string;
  /** Of its values; an error is always that of the whole variable. */
  component: Component;
  /** For values; errors have maps of their own. */
  colormap: ValueColormap;
  quantity: Quantity;
  /** Flat shading with edges: the tessellation. */
  edges: boolean;
  /** One camera for both sides. */
  linked: boolean;
}

export const firstView: ViewSettings = {
  // None of any surface, so that the first surface chooses.
  variable: '',
  component: 'magnitude',
  colormap: 'viridis',
  quantity: 'value',
  edges: false,
  linked: true,
};

/** Whether errors of a variable have signs: a vector's has none, but a position lies outside or inside. */
export function hasSign({ name, components }: { name: string; components: number }): boolean {
  return components === 1 || name === 'position';
}

/** The same view of another surface: a variable that it does not have is replaced by the first one that varies. */
export function settingsFor({ variables }: OpenSurface, settings: ViewSettings): ViewSettings {
  const [position, ...data] = variables;
  const kept = variables.find(({ name }) => name === settings.variable);
  return showing(kept ?? data.find(({ constant }) => !constant) ?? data[0] ?? position, settings);
}

/** The same view of this variable, as far as it has what is shown. */
export function showing(variable: { name: string; components: number }, settings: ViewSettings): ViewSettings {
  const { name, components } = variable;
  const offered = componentsOf(components).map(({ component }) => component);
  const keeps = name === settings.variable && offered.includes(settings.component);
  const quantity = settings.quantity === 'signed-error' && !hasSign(variable) ? 'error' : settings.quantity;
  return { ...settings, variable: name, component: keeps ? settings.component : offered[0], quantity };
}
