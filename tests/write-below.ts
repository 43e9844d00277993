import { existsSync, readFileSync, writeFileSync } from 'node:fs';

/** Replaces what a file has below the line `marker`, or adds both; what stands above is kept. */
export function writeBelow(path: string, marker: string, text: string): void {
  const before = existsSync(path) ? readFileSync(path, 'utf8').split(marker)[0] : '';
  writeFileSync(path, `${before}${marker}\n\n${text}\n`);
}
