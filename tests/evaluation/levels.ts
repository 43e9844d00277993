/**
 * Watches the morphs between levels of detail, with places and crossings of the map chosen and as laid out, and writes
 * docs/levels.md: sizes, folds, what is seen of them, and what a frame asks of the graphics card. Wants a build.
 *
 *     npm run evaluate:levels
 */

import { writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { chromium, type Page } from '@playwright/test';
import { createServer } from 'vite';
import { browserOptions } from './browser.ts';
import { levelsDocument, type WatchedSurface } from './levels-document.ts';
import type { Freedom } from './watched-morphs.ts';
import type { WatchedStep } from './watched-steps.ts';

/** Pictures on each way from a level to the next: at 60 a second it would take two thirds of one. */
const frames = 40;

const chosen = { optimizeVertexImages: true, optimizeEdgeCrossings: true };
const laidOut = { optimizeVertexImages: false, optimizeEdgeCrossings: false };

/** Lends a page, empty, that can import the project's modules, with the samples under `samples/`. */
async function withModules(work: (page: Page) => Promise<void>): Promise<void> {
  const server = await createServer({
    configFile: 'web/vite.config.ts',
    logLevel: 'error',
    optimizeDeps: { noDiscovery: true },
    server: { port: 0, hmr: false, fs: { allow: [resolve('.')] } },
  });
  await server.listen();
  const browser = await chromium.launch(browserOptions);
  try {
    const page = await browser.newPage({ baseURL: server.resolvedUrls?.local[0] });
    await page.route('**/empty', (route) => route.fulfill({ contentType: 'text/html', body: '<!doctype html>' }));
    await page.goto('/empty');
    await work(page);
  } finally {
    await browser.close();
    await server.close();
  }
}

function watch(page: Page, sample: string, freedom: Freedom): Promise<WatchedStep[]> {
  console.log(`${sample}, ${freedom.optimizeVertexImages ? 'chosen' : 'as laid out'} …`);
  const module = `/@fs${resolve('tests/evaluation/watched-morphs.ts')}`;
  return page.evaluate(
    async ([path, address, free, pictures]) => {
      const { watchMorphs } = (await import(path)) as typeof import('./watched-morphs.ts');
      return watchMorphs(address, free, pictures);
    },
    [module, `/samples/${sample}.ply`, freedom, frames] as const,
  );
}

await withModules(async (page) => {
  const surfaces: WatchedSurface[] = [];
  for (const name of ['fireballs', 'impact', 'fireballs-fine', 'impact-fine']) {
    surfaces.push({ name, chosen: await watch(page, name, chosen), laidOut: await watch(page, name, laidOut) });
  }
  writeFileSync('docs/levels.md', levelsDocument(surfaces, frames));
  console.log('docs/levels.md is written.');
});
