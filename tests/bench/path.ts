/**
 * Measures the whole way from a file to the picture of its reduction, and from a move of a slider to the picture, in the
 * page in Chromium; where the time goes, in percent of the whole; --help says how.
 *
 * The tables go to standard output, and to the file in place of what it has below the line that says so. What their columns
 * mean stands in docs/speed.md. The machine should be quiet.
 */
import { cpus } from 'node:os';
import { chromium, type Page } from '@playwright/test';
import { preview } from 'vite';
import { portOr } from '../port.ts';
import { writeBelow } from '../write-below.ts';
import { fromRoot } from './cases.ts';
import { pythonWithVtk } from './contenders.ts';
import { makeMeshes } from './meshes.ts';
import { optionsOr, pathOptions } from './options.ts';
import { probePage } from './path-probe.ts';
import { dragTable, fileTable, type Way } from './path-table.ts';
import { checkPageIsBuilt, chromiumPath, prepared } from './prerequisites.ts';

const marker = '<!-- Below: tests/bench/path.ts -->';
const port = prepared(() => portOr(4318));
/** How often the slider moves. */
const moves = 5;
const patience = 600_000;

const usage = `npm run bench:path -- [--quick] [--sizes 7k,100k,1m,4m] [--out FILE]

  --quick  the two small surfaces
  --sizes  of surfaces, by their triangles; all but the largest where it is not given
  --out    a file that gets the tables, in place of those it has

PORT is the port to serve the page on (${port}), CHROMIUM the browser. The page is as npm run build left it.`;

const { sizes, out } = optionsOr(usage, pathOptions);

async function openPage(): Promise<Page> {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  page.setDefaultTimeout(patience);
  // The compiler that ran over the probe names functions by a helper that the page has not.
  await page.addInitScript(`globalThis.__name = (named) => named; (${probePage.toString()})()`);
  await page.goto(`http://localhost:${port}/`);
  await settled(page);
  return page;
}

/** Waits until a result is there and drawn. */
async function settled(page: Page): Promise<void> {
  await page.locator('.numbers').getByText('removed').waitFor();
  await page.waitForFunction(() => window.probe.isDrawn());
}

async function openFile(page: Page, path: string): Promise<Way> {
  await page.evaluate(() => window.probe.begin());
  await page.locator('input[type=file]').setInputFiles(path);
  await page.waitForFunction(() => window.probe.steps.some(({ name }) => name === 'reduce'));
  await settled(page);
  return page.evaluate(() => window.probe.way());
}

/** Moves the slider of the geometry's bound to and fro, a step at a time. */
async function moveSlider(page: Page): Promise<Way[]> {
  const ways: Way[] = [];
  for (let move = 0; move < moves; move++) {
    await page.getByRole('slider', { name: 'Bound of position' }).focus();
    await page.evaluate(() => window.probe.begin());
    await page.keyboard.press(move % 2 === 0 ? 'ArrowRight' : 'ArrowLeft');
    await page.waitForFunction(() => window.probe.steps.some(({ name }) => name === 'reduce'));
    await settled(page);
    ways.push(await page.evaluate(() => window.probe.way()));
  }
  return ways;
}

function head(): string {
  const date = new Date().toISOString().slice(0, 10);
  return (
    `Measured on ${date} on ${cpus().length} × ${cpus()[0]?.model}, Chromium ${browser.version()} drawing by software, ` +
    `by \`npm run bench:path -- ${process.argv.slice(2).join(' ')}\`.`
  );
}

const executablePath = prepared(() => {
  checkPageIsBuilt();
  makeMeshes(sizes, pythonWithVtk);
  return chromiumPath();
});
const server = await preview({
  configFile: fromRoot('web/vite.config.ts'),
  logLevel: 'warn',
  preview: { port, strictPort: true },
});
const browser = await chromium.launch({ executablePath, args: ['--no-sandbox'] });

const files: Way[] = [];
const drags: Way[][] = [];
for (const { path } of sizes) {
  const page = await openPage();
  files.push(await openFile(page, path));
  drags.push(await moveSlider(page));
  await page.close();
}
const text = `${head()}\n\n${fileTable(files)}\n\n${dragTable(drags)}`;
console.log(text);
if (out) writeBelow(out, marker, text);
await browser.close();
await server.close();
