import { listed } from './wording.ts';

/** Names cell data that could part the surface into regions, where nothing asks for that: a sentence, or none. */
export function regionNotes(regions: ReadonlyMap<string, unknown> = new Map()): string[] {
  return regions.size > 0 ? [`Not carried: cell data ${listed([...regions.keys()])}.`] : [];
}

/** The same notes where regions can be chosen after reading. */
export function choosableRegionNotes(notes: readonly string[], regions?: ReadonlyMap<string, unknown>): string[] {
  const neutral = regionNotes(regions);
  const names = [...(regions?.keys() ?? [])];
  const choosable = `Cell data ${listed(names)} can part the surface into regions; what is not chosen for that is not carried.`;
  return notes.map((note) => (neutral.includes(note) ? choosable : note));
}
