import { listed } from './wording.ts';

/** What to know of cell data that are not used yet: a sentence, or nothing where there are none. */
export function regionNotes(regions: ReadonlyMap<string, unknown> = new Map()): string[] {
  if (regions.size === 0) return [];
  return [`Not carried unless it parts the surface into regions (--region): cell data ${listed([...regions.keys()])}.`];
}
