import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { places } from './places.ts';

/** What a result depends on. */
export type Key = Record<string, string | number>;

export function contentHash(path: string): string {
  return createHash('sha256').update(readFileSync(path)).digest('hex').slice(0, 16);
}

/**
 * The result kept under a name, if it was made with the same key and at least this effort; else it is made, on top of what
 * a smaller effort gave, and kept.
 */
export async function cached<Result>(
  name: string,
  key: Key,
  effort: number,
  make: (before: Result | undefined) => Promise<Result>,
): Promise<Result> {
  const path = join(places.cache, `${name}.json`);
  const kept = existsSync(path) ? JSON.parse(readFileSync(path, 'utf8')) : undefined;
  const isSame = JSON.stringify(kept?.key) === JSON.stringify(key);
  if (isSame && kept.effort >= effort) return kept.result;
  const result = await make(isSame ? kept.result : undefined);
  mkdirSync(places.cache, { recursive: true });
  writeFileSync(path, `${JSON.stringify({ key, effort, result }, null, 2)}\n`);
  return result;
}
