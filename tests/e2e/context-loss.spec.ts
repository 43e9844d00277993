import { expect, type Page, test } from '@playwright/test';
import { chooseFile, counts, look, openPage, settled } from './open-page.ts';
import { coverage, difference, pictureOf } from './picture.ts';
import { sheet } from './surfaces.ts';

const sides = ['original', 'reduced'] as const;

/** Takes the graphics card away from the page, as a driver does that starts anew, or gives it back. */
function card(page: Page, change: 'loseContext' | 'restoreContext'): Promise<void> {
  return page.evaluate(async (name) => {
    const stage = document.querySelector('meshbound-app')?.shadowRoot?.querySelector('meshbound-viewer')?.shadowRoot;
    const canvas = stage?.querySelector('meshbound-stage')?.shadowRoot?.querySelector('canvas') as HTMLCanvasElement;
    const told = name === 'loseContext' ? 'webglcontextlost' : 'webglcontextrestored';
    const done = new Promise((resolve) => canvas.addEventListener(told, resolve, { once: true }));
    const kept = window as unknown as { loss?: WEBGL_lose_context | null };
    // A lost context gives out no extensions.
    kept.loss ??= canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context');
    kept.loss?.[name]();
    await done;
  }, change);
}

test('a graphics card that goes and comes back leaves the picture as it was', async ({ page }) => {
  const faults: string[] = [];
  page.on('pageerror', ({ message }) => faults.push(message));
  await openPage(page);
  await look(page, { edges: true });
  for (const side of sides) await expect.poll(async () => coverage(await pictureOf(page, side))).toBeGreaterThan(0.1);
  const before = [await pictureOf(page, 'original'), await pictureOf(page, 'reduced')];

  await card(page, 'loseContext');
  await expect.poll(async () => coverage(await pictureOf(page, 'original'))).toBe(0);
  await card(page, 'restoreContext');
  for (const [index, side] of sides.entries()) {
    await expect.poll(async () => difference(before[index], await pictureOf(page, side))).toBe(0);
  }
  expect(faults).toEqual([]);
});

test('what is opened and chosen while the graphics card is away is there when it comes back', async ({ page }) => {
  await openPage(page);
  await card(page, 'loseContext');
  await chooseFile(page, 'sheet.ply', sheet(30));
  await expect.poll(async () => (await counts(page)).before).toBe(2 * 29 * 29);
  await settled(page);
  await look(page, { colour: 'wind', map: 'cividis' });
  await card(page, 'restoreContext');
  await expect.poll(async () => coverage(await pictureOf(page, 'reduced'))).toBeGreaterThan(0.1);
  const restored = [await pictureOf(page, 'original'), await pictureOf(page, 'reduced')];

  // The same as on a page that never lost it.
  await page.reload();
  await settled(page);
  await chooseFile(page, 'sheet.ply', sheet(30));
  await expect.poll(async () => (await counts(page)).before).toBe(2 * 29 * 29);
  await settled(page);
  await look(page, { colour: 'wind', map: 'cividis' });
  for (const [index, side] of sides.entries()) {
    await expect.poll(async () => difference(restored[index], await pictureOf(page, side))).toBe(0);
  }
});
