import { expect, type Page, test } from '@playwright/test';
import { dropFile, openPage, sentence, settled } from './open-page.ts';
import { coverage, difference, pictureOf } from './picture.ts';
import { sheet } from './surfaces.ts';

const sides = ['original', 'reduced'] as const;

async function pictures(page: Page) {
  return { original: await pictureOf(page, 'original'), reduced: await pictureOf(page, 'reduced') };
}

test('what is downloaded can be cancelled, and all of what was there before stays', async ({ page }) => {
  await openPage(page);
  for (const side of sides) await expect.poll(async () => coverage(await pictureOf(page, side))).toBeGreaterThan(0.1);
  const before = { words: await sentence(page).innerText(), shown: await pictures(page) };
  // A server that never answers.
  await page.route('**/slow.ply', () => undefined);
  const ended = page.waitForEvent('requestfailed');
  await page.evaluate(() => {
    location.hash = '#src=slow.ply';
  });
  await expect(page.locator('.numbers')).toContainText('Downloading slow.ply…');
  await page.getByRole('button', { name: 'Cancel' }).click();
  expect((await ended).url()).toContain('slow.ply');
  await settled(page);
  expect(await sentence(page).innerText()).toBe(before.words);
  const after = await pictures(page);
  for (const side of sides) expect(difference(before.shown[side], after[side])).toBe(0);
});

test('every phase up to the result can be aborted, and the next file opens as ever', async ({ page }) => {
  await openPage(page);
  const words = await sentence(page).innerText();
  await page.evaluate(() => {
    const viewer = document.querySelector('meshbound-app')?.shadowRoot?.querySelector('meshbound-viewer');
    const told = { abortIn: '', phases: [] as string[] };
    viewer?.addEventListener('progress', (event) => {
      const { phase } = (event as unknown as CustomEvent<{ phase: string }>).detail;
      told.phases.push(phase);
      if (phase === told.abortIn) viewer.abort();
    });
    Object.assign(window, { told });
  });
  const abortIn = (phase: string) =>
    page.evaluate((name) => Object.assign((window as unknown as { told: object }).told, { abortIn: name }), phase);
  const phases = () => page.evaluate(() => (window as unknown as { told: { phases: string[] } }).told.phases);
  for (const phase of ['read', 'check']) {
    await abortIn(phase);
    await dropFile(page, 'sheet.ply', sheet(40));
    await expect.poll(async () => (await phases()).at(-1)).toBe(phase);
    await settled(page);
    expect(await sentence(page).innerText()).toBe(words);
  }
  await abortIn('reduce');
  await dropFile(page, 'sheet.ply', sheet(40));
  await expect(page.locator('.numbers')).toContainText('Cancelled');
  await expect(page.locator('#original .caption')).toContainText(/3.042/);
  await expect(page.locator('#reduced .caption')).toContainText('Not reduced');
  await abortIn('');
  await dropFile(page, 'sheet.ply', sheet(30));
  await expect(sentence(page)).toContainText(/of 1.682 triangles/);
  expect(await phases()).toContain('draw');
  await expect(page.getByRole('alert')).toHaveCount(0);
});

test('a viewer with controls says how far it is, and can be cancelled there', async ({ page }) => {
  await page.goto('./element.html');
  const viewer = page.locator('meshbound-viewer').first();
  await expect(viewer.locator('.sentence')).toContainText('proved');
  const words = await viewer.locator('.sentence').innerText();
  await page.route('**/slow.ply', () => undefined);
  await viewer.evaluate((element) => element.setAttribute('src', 'slow.ply'));
  await expect(viewer.locator('.numbers')).toContainText('Downloading slow.ply…');
  await viewer.getByRole('button', { name: 'Cancel' }).click();
  await expect(viewer.locator('.numbers')).toContainText('removed');
  expect(await viewer.locator('.sentence').innerText()).toBe(words);
});

test('the last good picture stays until the new one is ready', async ({ page }) => {
  await openPage(page);
  for (const side of sides) await expect.poll(async () => coverage(await pictureOf(page, side))).toBeGreaterThan(0.1);
  await watchFrames(page);
  const emptiest = () => page.evaluate(() => (window as unknown as { emptiest: Emptiest }).emptiest);
  await page.getByRole('slider', { name: 'All bounds' }).fill('300');
  await settled(page);
  await expect.poll(async () => (await emptiest()).frames).toBeGreaterThan(0);
  expect((await emptiest()).reduced).toBeGreaterThan(0.1);
  await page.getByLabel('Sample').selectOption('impact');
  await expect(sentence(page)).toContainText('iron');
  await settled(page);
  await expect.poll(async () => coverage(await pictureOf(page, 'reduced'))).toBeGreaterThan(0.05);
  expect((await emptiest()).original).toBeGreaterThan(0.1);
});

/** The least of each side that was covered in any frame, and how many frames there were. */
interface Emptiest {
  original: number;
  reduced: number;
  frames: number;
}

/** Looks at the canvas after everything that is drawn: later the browser has taken the picture away. */
async function watchFrames(page: Page): Promise<void> {
  await page.evaluate(() => {
    const viewer = document.querySelector('meshbound-app')?.shadowRoot?.querySelector('meshbound-viewer');
    const canvas = viewer?.shadowRoot?.querySelector('meshbound-stage')?.shadowRoot?.querySelector('canvas');
    const [width, height] = [40, 20];
    const small = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
    const emptiest = { original: 1, reduced: 1, frames: 0 };
    Object.assign(window, { emptiest });
    const look = () => {
      if (!canvas || !small) return;
      small.clearRect(0, 0, width, height);
      small.drawImage(canvas, 0, 0, width, height);
      const { data } = small.getImageData(0, 0, width, height);
      const covered = { original: 0, reduced: 0 };
      for (let pixel = 0; pixel < width * height; pixel++) {
        if (data[4 * pixel + 3] > 0) covered[pixel % width < width / 2 ? 'original' : 'reduced']++;
      }
      emptiest.frames++;
      for (const side of ['original', 'reduced'] as const) {
        emptiest[side] = Math.min(emptiest[side], covered[side] / (width * height) / 0.5);
      }
    };
    const { drawArrays } = WebGL2RenderingContext.prototype;
    let looking = false;
    // Both sides are drawn in one go: what is to be seen is there when it is over.
    WebGL2RenderingContext.prototype.drawArrays = function (...given) {
      drawArrays.apply(this, given);
      if (looking) return;
      looking = true;
      queueMicrotask(() => {
        looking = false;
        look();
      });
    };
  });
}
