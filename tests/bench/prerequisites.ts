import { existsSync } from 'node:fs';
import { fromRoot } from './cases.ts';

/** What the commands that measure the page start from: a browser, and the page as built. Throws what to do where one is missing. */
export function chromiumPath(): string {
  const path = process.env.CHROMIUM ?? '/usr/bin/chromium';
  if (!existsSync(path)) {
    throw new Error(
      `There is no Chromium at ${path}: apt-get install --no-install-recommends chromium, or give its path in CHROMIUM.`,
    );
  }
  return path;
}

export function checkPageIsBuilt(): void {
  if (!existsSync(fromRoot('dist/index.html'))) throw new Error('The page is not built: run npm run build.');
}

/** Prepares for measuring. What is missing is said by itself, without where in the program it was missed. */
export function prepared<Thing>(prepare: () => Thing): Thing {
  try {
    return prepare();
  } catch (error) {
    console.error(error instanceof Error ? error.message : error);
    process.exit(1);
  }
}
