/**
 * Measures what the page, and a viewer on a page of one's own, transfer and how soon they show something, and how many frames
 * a second a turning surface gets, in Chromium; writes docs/page.md below the line that says so:
 *
 *     npm run bench:page
 *
 * PORT is the port to serve the page on; the machine should be quiet.
 */
import { readFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { gzipSync } from 'node:zlib';
import { type Browser, chromium, type Page } from '@playwright/test';
import { preview } from 'vite';
import { portOr } from '../port.ts';
import { writeBelow } from '../write-below.ts';
import { fromRoot } from './cases.ts';
import { checkPageIsBuilt, chromiumPath, prepared } from './prerequisites.ts';

const marker = '<!-- Below: tests/bench/page.ts -->';
const port = prepared(() => portOr(4319));
const address = `http://localhost:${port}/`;
const patience = 120_000;
/** Each is loaded so often, and the median taken. */
const loads = 5;
/** How long a surface turns, in milliseconds. */
const turning = 10_000;

/** A page with nothing but a viewer. */
const ownPage = `<!doctype html><html lang="en"><title>A viewer</title>
  <script type="module" src="element/meshbound-viewer.js"></script>
  <meshbound-viewer src="samples/fireballs.ply"></meshbound-viewer></html>`;

interface Load {
  /** From the beginning of the load, in milliseconds. */
  firstPaint: number;
  original: number;
  reduced: number;
  /** Of all answers but surfaces, in bytes, packed by gzip. */
  transferred: number;
  requests: number;
}

async function openPage(browser: Browser, path: string, listen = (_page: Page) => {}): Promise<Page> {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  page.setDefaultTimeout(patience);
  listen(page);
  await page.route('**/own.html', (route) => route.fulfill({ contentType: 'text/html', body: ownPage }));
  // The compiler that ran over the function names functions by a helper that the page has not.
  await page.addInitScript(`globalThis.__name = (named) => named; (${watchCaptions.toString()})()`);
  await page.goto(address + path);
  return page;
}

/** Runs in the page: keeps when each side's caption first names a count. */
function watchCaptions(): void {
  const shown: Record<string, number> = {};
  Object.assign(window, { shown });
  const find = (root: ParentNode, selector: string): Element | null => {
    const found = root.querySelector(selector);
    if (found) return found;
    for (const { shadowRoot } of root.querySelectorAll('*')) {
      const inside = shadowRoot && find(shadowRoot, selector);
      if (inside) return inside;
    }
    return null;
  };
  const look = () => {
    for (const side of ['original', 'reduced']) {
      const drawn = find(document, `#${side} .caption b`) && find(document, `#${side} meshbound-legend`);
      if (drawn) shown[side] ??= performance.now();
    }
    if (Object.keys(shown).length < 2) requestAnimationFrame(look);
  };
  look();
}

async function load(browser: Browser, path: string): Promise<Load> {
  const requested = new Set<string>();
  // Those of workers are seen by the context only.
  const count = (page: Page) => page.context().on('request', (request) => requested.add(request.url()));
  const page = await openPage(browser, path, count);
  await page.waitForFunction(() => Object.keys((window as unknown as { shown: object }).shown).length === 2);
  const times = await page.evaluate(() => ({
    ...(window as unknown as { shown: { original: number; reduced: number } }).shown,
    firstPaint: performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? Number.NaN,
  }));
  await page.close();
  const sizes = [...requested].filter(isCounted).map(packedSize);
  return { ...times, transferred: sizes.reduce((sum, size) => sum + size, 0), requests: sizes.length };
}

function isCounted(url: string): boolean {
  return url.startsWith(address) && !/\.(ply|json)$/.test(url);
}

/** Of a file of the built page, in bytes. */
function packedSize(url: string): number {
  const { pathname } = new URL(url);
  if (pathname === '/own.html') return gzipSync(ownPage).length;
  return gzipSync(readFileSync(fromRoot(`dist${pathname === '/' ? '/index.html' : pathname}`))).length;
}

/** How many triangles a side has, and the frames a second while it turns by a little in each, as cells of a table. */
async function framesPerSecond(browser: Browser, sample: string, side: 'original' | 'reduced'): Promise<string> {
  const page = await openPage(browser, `#src=samples/${sample}.ply&view=${side}`);
  await page.locator('.numbers').getByText('removed').waitFor();
  await page.waitForTimeout(2000);
  const triangles = await page.locator(`#${side} .caption b`).innerText();
  const frames = await page.evaluate(async (duration) => {
    const stage = document
      .querySelector('meshbound-app')
      ?.shadowRoot?.querySelector('meshbound-viewer')
      ?.shadowRoot?.querySelector('meshbound-stage')?.shadowRoot;
    const pane = stage?.querySelector('.pane');
    const gl = stage?.querySelector('canvas')?.getContext('webgl2') as WebGL2RenderingContext;
    const pixel = new Uint8Array(4);
    const begin = performance.now();
    let count = 0;
    while (performance.now() - begin < duration) {
      pane?.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft' }));
      await new Promise(requestAnimationFrame);
      // Not asked for sooner than it is drawn.
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      count++;
    }
    return (1000 * count) / (performance.now() - begin);
  }, turning);
  await page.close();
  return `${triangles} | ${frames.toFixed(1)}`;
}

function median(numbers: number[]): number {
  return numbers.sort((a, b) => a - b)[Math.floor(numbers.length / 2)];
}

async function loadRow(browser: Browser, name: string, path: string): Promise<string> {
  const all: Load[] = [];
  for (let each = 0; each < loads; each++) all.push(await load(browser, path));
  const middle = (key: keyof Load) => median(all.map((one) => one[key]));
  const seconds = (key: keyof Load) => (middle(key) / 1000).toFixed(2);
  const kilobytes = Math.round(middle('transferred') / 1000);
  return `| ${name} | ${kilobytes} | ${middle('requests')} | ${seconds('firstPaint')} | ${seconds('original')} | ${seconds('reduced')} |`;
}

const executablePath = prepared(() => {
  checkPageIsBuilt();
  return chromiumPath();
});
const server = await preview({
  configFile: fromRoot('web/vite.config.ts'),
  preview: { port, strictPort: true },
  logLevel: 'error',
});
const browser = await chromium.launch({ executablePath, args: ['--no-sandbox'] });
try {
  const rows = [
    await loadRow(browser, 'the page', ''),
    await loadRow(browser, 'a viewer on a page of one’s own, not isolated', 'own.html'),
  ];
  const frames: string[] = [];
  for (const sample of ['fireballs', 'fireballs-fine']) {
    const original = await framesPerSecond(browser, sample, 'original');
    const reduced = await framesPerSecond(browser, sample, 'reduced');
    frames.push(`| ${sample} | ${original} | ${reduced} |`);
  }
  const text = `${cpus()[0].model}, ${cpus().length} cores, Chromium ${browser.version()}, drawn by SwiftShader: without a graphics card.

| | kB, packed | requests | first paint, s | original, s | reduced, s |
| --- | ---: | ---: | ---: | ---: | ---: |
${rows.join('\n')}

| sample | original: triangles | frames a second | reduced: triangles | frames a second |
| --- | ---: | ---: | ---: | ---: |
${frames.join('\n')}
`;
  process.stdout.write(text);
  writeBelow(fromRoot('docs/page.md'), marker, text);
} finally {
  await browser.close();
  await server.close();
}
