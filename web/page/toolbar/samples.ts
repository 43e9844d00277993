import { fetchBytes } from '../../session/reading/fetch-bytes.ts';

/** A surface that comes with the page. */
export interface Sample {
  name: string;
  title: string;
  /** Where its file is, relative to the page. */
  address: string;
}

/** Where the sample surfaces lie, relative to the page. */
const folder = 'samples/';

/** The samples that come with the page, the one to begin with first. */
export async function fetchSamples(): Promise<Sample[]> {
  const listing = new TextDecoder().decode(await fetchBytes(`${folder}samples.json`));
  const samples = JSON.parse(listing) as { name: string; title: string }[];
  return samples.map(({ name, title }) => ({ name, title, address: `${folder}${name}.ply` }));
}
