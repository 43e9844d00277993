import type { VariableExtent } from '../../wasm/index.ts';
import { type ValueColormap, valueColormaps } from '../colour/colormaps.ts';
import { type Component, componentsOf } from '../colour/field.ts';
import type { OpenSurface } from '../session/session.ts';

/** What is shown of a variable: its values, the errors as shares of the bound, or the errors with their signs. */
export const quantities = ['value', 'error', 'signed-error'] as const;
export type Quantity = (typeof quantities)[number];

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

/** What a viewer is asked to show, whatever surface is open. Null and what does not exist leave the choice to the viewer. */
export interface WantedView {
  variable: string | null;
  /** `magnitude`, or what a component is called. */
  component: string | null;
  show: string | null;
  colormap: string | null;
  edges: boolean;
  unlinked: boolean;
}

/** What is wanted, as far as the surface has it. */
export function settingsFor(surface: OpenSurface | null, wanted: WantedView): ViewSettings {
  const settings: ViewSettings = {
    ...firstView,
    colormap: valueColormaps.find((name) => name === wanted.colormap) ?? firstView.colormap,
    quantity: quantities.find((name) => name === wanted.show) ?? firstView.quantity,
    edges: wanted.edges,
    linked: !wanted.unlinked,
  };
  return surface ? { ...settings, ...shownVariable(surface, wanted, settings.quantity) } : settings;
}

function shownVariable(
  { variables, labels }: OpenSurface,
  wanted: WantedView,
  quantity: Quantity,
): Pick<ViewSettings, 'variable' | 'component' | 'quantity'> {
  const variable = variables.find(({ name }) => name === wanted.variable) ?? firstShown(variables);
  const choices = componentsOf(variable.components, labels.componentNames[variable.name]);
  const { component } = choices.find(({ label }) => label === wanted.component) ?? choices[0];
  const shown = quantity === 'signed-error' && !hasSign(variable) ? 'error' : quantity;
  return { variable: variable.name, component, quantity: shown };
}

/** The first variable that varies; the geometry where there is none. */
function firstShown([position, ...data]: VariableExtent[]): VariableExtent {
  return data.find(({ constant }) => !constant) ?? data[0] ?? position;
}

export function sameView(one: ViewSettings, other: ViewSettings): boolean {
  return Object.entries(one).every(([key, value]) => other[key as keyof ViewSettings] === value);
}
