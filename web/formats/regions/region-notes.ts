import { listed } from '../text/wording.ts';

/** Names cell data that could part the surface into regions, where nothing asks for that: a sentence, or none. */
export function regionNotes(regions: ReadonlyMap<string, unknown> = new Map()): string[] {
  return regions.size > 0 ? [`Not carried: cell data ${listed([...regions.keys()])}.`] : [];
}

/** The notes of a reader without that sentence, for who has more to say of it. */
export function withoutRegionNotes(notes: readonly string[], regions?: ReadonlyMap<string, unknown>): string[] {
  const neutral = regionNotes(regions);
  return notes.filter((note) => !neutral.includes(note));
}

/** Names cell data that can be chosen after reading, beside those that are: a sentence, or none. */
export function choosableRegionNotes(
  regions: ReadonlyMap<string, unknown> = new Map(),
  chosen: string | null,
): string[] {
  const names = [...regions.keys()].filter((name) => name !== chosen);
  if (names.length === 0) return [];
  return [`Cell data ${listed(names)} can part the surface into regions; what is not chosen for that is not carried.`];
}
