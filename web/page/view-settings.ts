import type { ValueColormap } from '../colour/colormaps.ts';
import type { Component } from '../colour/field.ts';

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
