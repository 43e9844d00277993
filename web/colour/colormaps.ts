import { rgb } from 'd3-color';
import {
  interpolateCividis,
  interpolateMagma,
  interpolatePuOr,
  interpolateRdBu,
  interpolateViridis,
  interpolateYlOrBr,
} from 'd3-scale-chromatic';

/** The maps whose middle is zero: ColorBrewer's that any colour vision can read. */
export const divergingColormaps = ['RdBu', 'PuOr'] as const;
/** The maps offered for values: sequential ones, readable with any colour vision, and those centred on zero. */
export const valueColormaps = ['viridis', 'cividis', 'magma', ...divergingColormaps] as const;
export type ValueColormap = (typeof valueColormaps)[number];

/** `share` is kept for error / bound, so that an error never looks like a value. */
export type Colormap = ValueColormap | 'share';

/** Red, green, blue, each 0…255, as shown on screen (sRGB). */
export type Colour = readonly [red: number, green: number, blue: number];

/** Error / bound above 1: loud, and far from every map, because it must never appear. */
export const aboveBoundColour: Colour = [255, 0, 255];

/** Values below and above a range that does not hold them all: far from every map, and dark against bright. */
export const belowRangeColour: Colour = [0, 0, 255];
export const aboveRangeColour: Colour = [0, 255, 255];

/** Where there is no number to show. */
export const missingColour: Colour = [150, 150, 150];

const interpolators: Record<Colormap, (place: number) => string> = {
  viridis: interpolateViridis,
  cividis: interpolateCividis,
  magma: interpolateMagma,
  // Turned round, so that warm is positive.
  RdBu: (place) => interpolateRdBu(1 - place),
  PuOr: interpolatePuOr,
  share: interpolateYlOrBr,
};

export function isDiverging(map: Colormap): boolean {
  return divergingColormaps.some((name) => name === map);
}

/** The colour at `place`, 0…1 along the map. */
export function colourAt(map: Colormap, place: number): Colour {
  const { r, g, b } = rgb(interpolators[map](place));
  return [r, g, b];
}

/** How many colours a look-up table holds. */
export const tableSize = 256;

/** The map as bytes, red, green, blue, alpha, `tableSize` times: what a texture takes. */
export function colourTable(map: Colormap): Uint8Array {
  const table = new Uint8Array(4 * tableSize);
  for (let entry = 0; entry < tableSize; entry++) {
    table.set([...colourAt(map, entry / (tableSize - 1)), 255], 4 * entry);
  }
  return table;
}

/** How many stops draw a map as a smooth gradient. */
const gradientStops = 17;

/** The map as a CSS gradient that runs in `direction`. */
export function cssGradient(map: Colormap, direction: string): string {
  const stops = Array.from({ length: gradientStops }, (_, stop) =>
    cssColour(colourAt(map, stop / (gradientStops - 1))),
  );
  return `linear-gradient(${direction}, ${stops.join(', ')})`;
}

export function cssColour([red, green, blue]: Colour): string {
  return `rgb(${red}, ${green}, ${blue})`;
}
