import { listed } from './wording.ts';

/** Names cell data that could part the surface into regions, where nothing asks for that: a sentence, or none. */
export function regionNotes(regions: ReadonlyMap<string, unknown> = new Map()): string[] {
  return regions.size > 0 ? [`Not carried: cell data ${listed([...regions.keys()])}.`] : [];
}
