import {
  aboveBoundColour,
  aboveRangeColour,
  belowRangeColour,
  type Colour,
  missingColour,
} from '../../colour/colormaps.ts';
import { english } from '../../words/english.ts';
import type { Meaning } from '../stage/colouring.ts';

/** What stands under the numbers of a legend; with a colour where that colour is none of the map's. */
export interface LegendEnd {
  text: string;
  colour?: Colour;
}

/** From left to right: the lowest end, what must never appear, where there is nothing to show, the highest end. */
export function legendEnds({ ends, bounded, free, missing, beyond }: Meaning): LegendEnd[] {
  const [lowest, highest] = ends ?? [];
  return [
    ...(lowest === undefined ? [] : [{ text: lowest, ...(beyond?.below ? { colour: belowRangeColour } : {}) }]),
    ...(bounded
      ? [{ text: ends ? english.legend.beyondNever : english.legend.aboveOneNever, colour: aboveBoundColour }]
      : []),
    ...(free ? [{ text: english.legend.noBound, colour: missingColour }] : []),
    ...(missing ? [{ text: english.legend.noNumber, colour: missingColour }] : []),
    ...(highest === undefined ? [] : [{ text: highest, ...(beyond?.above ? { colour: aboveRangeColour } : {}) }]),
  ];
}
