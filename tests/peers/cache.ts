import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { places } from './places.ts';

/** What a result depends on. */
export type Key = Record<string, string | number>;

export function contentHash(path: string): string {
  return createHash('sha256').update(readFileSync(path)).digest('hex').slice(0, 16);
}

/** The result kept under a name, if it was made with the same key; else it is made, and kept. */
export async function cached<Result>(name: string, key: Key, make: () => Promise<Result>): Promise<Result> {
  const path = join(places.cache, `${name}.json`);
  if (existsSync(path)) {
    const kept = JSON.parse(readFileSync(path, 'utf8'));
    if (JSON.stringify(kept.key) === JSON.stringify(key)) return kept.result;
  }
  const result = await make();
  mkdirSync(places.cache, { recursive: true });
  writeFileSync(path, `${JSON.stringify({ key, result }, null, 2)}\n`);
  return result;
}
