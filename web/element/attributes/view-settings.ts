import type { VariableExtent } from '../../../wasm/index.ts';
import { type ValueColormap, valueColormaps } from '../../colour/colormaps.ts';
import { parseRange } from '../../colour/colour-range.ts';
import { type Component, componentsOf } from '../../colour/field.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import { parseClip } from '../../viewer/look.ts';

/** What is shown of a variable: its values, the errors as shares of the bound, or the errors with their signs. */
export const quantities = ['value', 'error', 'signed-error'] as const;
export type Quantity = (typeof quantities)[number];

/** Both side by side, one over the other with a divider to drag, one alone, or the reduced one in its levels of detail. */
export const views = ['split', 'wipe', 'original', 'reduced', 'morph'] as const;
export type View = (typeof views)[number];

/** How the surfaces are looked at. */
export interface ViewSettings {
  /** What both surfaces are coloured by. */
  variable: string;
  /** Of its values; an error is always that of the whole variable. */
  component: Component;
  /** For values; errors have maps of their own. */
  colormap: ValueColormap;
  quantity: Quantity;
  /** What the map for values spans. */
  range: string;
  /** Which surfaces are to be seen, and how they share the stage. */
  view: View;
  /** The edges of the triangles. */
  edges: boolean;
  /** Every triangle as the plane that it is. */
  flat: boolean;
  /** The backs of triangles too; otherwise one looks through them. */
  doubleSided: boolean;
  /** Parallels stay parallel. */
  orthographic: boolean;
  /** A plane across an axis, which cuts off one side, as text. */
  clip: string;
  /** One camera for both sides. */
  linked: boolean;
}

export const firstView: ViewSettings = {
  // None of any surface, so that the first surface chooses.
  variable: '',
  component: 'magnitude',
  colormap: 'viridis',
  quantity: 'value',
  range: 'data',
  view: 'split',
  edges: false,
  flat: false,
  doubleSided: true,
  orthographic: false,
  clip: '',
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
  range: string | null;
  view: string | null;
  edges: boolean;
  flat: boolean;
  cull: boolean;
  orthographic: boolean;
  clip: string | null;
  unlinked: boolean;
}

/** What is wanted, as far as the surface has it. */
export function settingsFor(surface: OpenSurface | null, wanted: WantedView): ViewSettings {
  const settings: ViewSettings = {
    ...firstView,
    colormap: valueColormaps.find((name) => name === wanted.colormap) ?? firstView.colormap,
    quantity: quantities.find((name) => name === wanted.show) ?? firstView.quantity,
    range: wanted.range && parseRange(wanted.range) ? wanted.range : firstView.range,
    view: views.find((name) => name === wanted.view) ?? firstView.view,
    edges: wanted.edges,
    flat: wanted.flat,
    doubleSided: !wanted.cull,
    orthographic: wanted.orthographic,
    clip: wanted.clip && parseClip(wanted.clip) ? wanted.clip : firstView.clip,
    // One over the other, two cameras would make no sense.
    linked: !wanted.unlinked || wanted.view === 'wipe',
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
