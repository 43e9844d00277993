import type { Sample } from './services.ts';

/** Where the sample surfaces lie, relative to the page. */
const folder = 'samples/';

/** Fetches bytes; rejects with a sentence where they are not to be had. */
export async function fetchBytes(url: string): Promise<Uint8Array<ArrayBuffer>> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url} cannot be loaded (status ${response.status}).`);
  return new Uint8Array(await response.arrayBuffer());
}

/** The samples that come with the page, the one to begin with first. */
export async function fetchSamples(): Promise<Sample[]> {
  const listing = new TextDecoder().decode(await fetchBytes(`${folder}samples.json`));
  const samples = JSON.parse(listing) as { name: string; title: string }[];
  return samples.map(({ name, title }) => ({ name, title, url: `${folder}${name}.ply` }));
}
