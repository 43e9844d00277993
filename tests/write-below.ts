import { existsSync, readFileSync, writeFileSync } from 'node:fs';

/** Ends what is replaced; without it that goes to the end of the file. */
const endMarker = '<!-- End -->';

/** Replaces what a file has below the line `marker`, or adds both; whatever stands above it and below the end stays. */
export function writeBelow(path: string, marker: string, text: string): void {
  const [above = '', below = ''] = existsSync(path) ? readFileSync(path, 'utf8').split(marker) : [];
  const end = below.indexOf(endMarker);
  const kept = end < 0 ? '' : `\n${below.slice(end)}`;
  writeFileSync(path, `${above}${marker}\n\n${text}\n${kept}`);
}
