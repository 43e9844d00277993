import type { Mesh } from '../../../wasm/types.ts';
import {
  aboveBoundColour,
  aboveRangeColour,
  belowRangeColour,
  type Colour,
  colourTable,
  missingColour,
} from '../../colour/colormaps.ts';
import type { Multiplied } from '../../probe/multiplied.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import type { ShownColour } from '../../viewer/lookup-material.ts';
import type { Lookup } from '../../viewer/surface.ts';
import type { ViewSettings } from '../attributes/view-settings.ts';
import { type Colouring, type Meaning, valueColouring } from './colouring.ts';
import { originalErrors, reducedErrors, unknownErrors } from './error-colouring.ts';

/** The colours of the original; values where errors are asked for and there is no result, or none that knows them there. */
export function originalColouring(
  mesh: Mesh,
  surface: OpenSurface,
  result: Multiplied | null,
  settings: ViewSettings,
): Colouring {
  const values = () => valueColouring(mesh, surface, settings);
  if (settings.quantity === 'value' || !result) return values();
  const errors = originalErrors(mesh, result, surface.labels, settings);
  if (errors) return errors;
  const { places, meaning } = values();
  return { places, meaning: { ...meaning, detail: unknownErrors } };
}

/** The colours of the reduced surface; values where there is no result. */
export function reducedColouring(
  mesh: Mesh,
  surface: OpenSurface,
  result: Multiplied | null,
  settings: ViewSettings,
): Colouring {
  if (settings.quantity === 'value' || !result) return valueColouring(mesh, surface, settings);
  return reducedErrors(result, surface.labels, settings);
}

/** What a viewer draws colours of this meaning with. */
export function lookupOf({ map, quantity, beyond }: Meaning): Lookup {
  return {
    table: colourTable(map),
    markAbove: quantity !== 'value' || beyond?.above === true,
    above: shown(quantity === 'value' ? aboveRangeColour : aboveBoundColour),
    below: beyond?.below ? shown(belowRangeColour) : undefined,
    missing: shown(missingColour),
  };
}

function shown([red, green, blue]: Colour): ShownColour {
  return [red / 255, green / 255, blue / 255];
}
