import { expect, test } from '@playwright/test';
import { chooseFile, counts, openPage, settled } from './open-page.ts';
import { coverage, difference, hasBrokenBound, pictureOf, shareFromMap } from './picture.ts';
import { sheet } from './surfaces.ts';

test('draws both surfaces, in the colours of the map', async ({ page }) => {
  await openPage(page);
  for (const side of ['original', 'reduced'] as const) {
    await expect.poll(async () => coverage(await pictureOf(page, side))).toBeGreaterThan(0.1);
    const picture = await pictureOf(page, side);
    expect(shareFromMap(picture, 'viridis')).toBeGreaterThan(0.99);
    expect(shareFromMap(picture, 'cividis')).toBeLessThan(0.9);
  }
  const [original, reduced] = [await pictureOf(page, 'original'), await pictureOf(page, 'reduced')];
  expect(difference(original, reduced)).toBeGreaterThan(0);
  // Within such bounds it is the same object to the eye.
  expect(Math.abs(coverage(original) - coverage(reduced))).toBeLessThan(0.02);
});

test('a coarser surface looks different, and the original stays', async ({ page }) => {
  await openPage(page);
  await expect.poll(async () => coverage(await pictureOf(page, 'reduced'))).toBeGreaterThan(0.1);
  const [original, reduced] = [await pictureOf(page, 'original'), await pictureOf(page, 'reduced')];
  const field = page.getByLabel('Largest bound in percent');
  await field.fill('20');
  await field.press('Enter');
  await expect.poll(async () => difference(reduced, await pictureOf(page, 'reduced'))).toBeGreaterThan(0.02);
  expect(difference(original, await pictureOf(page, 'original'))).toBe(0);
});

test('another variable and another map recolour both sides, with the same range', async ({ page }) => {
  await openPage(page);
  await expect.poll(async () => coverage(await pictureOf(page, 'reduced'))).toBeGreaterThan(0.1);
  const before = { original: await pictureOf(page, 'original'), reduced: await pictureOf(page, 'reduced') };
  await page.getByLabel('Colour').selectOption({ label: 'temperature' });
  await page.getByLabel('Map').selectOption('cividis');
  for (const side of ['original', 'reduced'] as const) {
    await expect.poll(async () => difference(before[side], await pictureOf(page, side))).toBeGreaterThan(0.1);
    expect(shareFromMap(await pictureOf(page, side), 'cividis')).toBeGreaterThan(0.99);
  }
  const legends = page.locator('meshbound-legend');
  await expect(legends.locator('.title')).toHaveText(['temperature [K]', 'temperature [K]']);
  const numbers = await legends.locator('.ticks').allInnerTexts();
  expect(numbers[0]).toMatch(/\d/);
  expect(numbers[1]).toBe(numbers[0]);
});

test('shows a diverging map centred on zero', async ({ page }) => {
  await openPage(page);
  await page.getByLabel('Colour').selectOption({ label: 'vx' });
  await page.getByLabel('Map').selectOption('diverging');
  const zero = page.locator('#original meshbound-legend .ticks span', { hasText: /^0$/ });
  await expect(zero).toHaveAttribute('style', 'left:50%');
});

test('shows error / bound of every variable on the reduced side, never above 1', async ({ page }) => {
  await openPage(page);
  await expect.poll(async () => coverage(await pictureOf(page, 'reduced'))).toBeGreaterThan(0.1);
  const original = await pictureOf(page, 'original');
  const choice = page.getByLabel('Reduced shows');
  const names = await choice
    .locator('option')
    .evaluateAll((options) => options.map((option) => option.getAttribute('value')));
  expect(names.length).toBeGreaterThan(5);
  for (const name of names.filter((value) => value)) {
    await choice.selectOption(name);
    const legend = page.locator('#reduced meshbound-legend');
    await expect(legend).toContainText(`error / bound: ${name}`);
    await expect(legend.locator('.ticks span')).toHaveText(['0', '0.2', '0.4', '0.6', '0.8', '1']);
    const picture = await pictureOf(page, 'reduced');
    // Where two flat triangles meet, smoothing mixes their colours.
    expect(shareFromMap(picture, 'share')).toBeGreaterThan(0.9);
    expect(hasBrokenBound(picture)).toBe(false);
  }
  expect(difference(original, await pictureOf(page, 'original'))).toBe(0);
});

test('shows the tessellation', async ({ page }) => {
  await openPage(page);
  await expect.poll(async () => coverage(await pictureOf(page, 'reduced'))).toBeGreaterThan(0.1);
  const smooth = await pictureOf(page, 'reduced');
  await page.getByLabel('Edges').check();
  await expect.poll(async () => difference(smooth, await pictureOf(page, 'reduced'))).toBeGreaterThan(0.05);
  // Where both sides show edges, fewer triangles cannot be missed.
  expect(difference(await pictureOf(page, 'original'), await pictureOf(page, 'reduced'))).toBeGreaterThan(0.05);
});

test('one camera turns both sides, two cameras one each, and fit brings both back', async ({ page }) => {
  await openPage(page);
  await expect.poll(async () => coverage(await pictureOf(page, 'reduced'))).toBeGreaterThan(0.1);
  const both = async () => [await pictureOf(page, 'original'), await pictureOf(page, 'reduced')];
  const first = await both();
  const pane = await page.locator('#original').boundingBox();
  const [x, y] = [(pane?.x ?? 0) + (pane?.width ?? 0) / 2, (pane?.y ?? 0) + (pane?.height ?? 0) / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 80, y + 20, { steps: 4 });
  await page.mouse.up();
  await expect.poll(async () => difference(first[1], await pictureOf(page, 'reduced'))).toBeGreaterThan(0.05);
  const turned = await both();
  expect(difference(first[0], turned[0])).toBeGreaterThan(0.05);
  expect(Math.abs(coverage(turned[0]) - coverage(turned[1]))).toBeLessThan(0.02);

  await page.getByLabel('One camera').uncheck();
  await page.locator('#reduced').press('ArrowLeft');
  await expect.poll(async () => difference(turned[1], await pictureOf(page, 'reduced'))).toBeGreaterThan(0.02);
  expect(difference(turned[0], await pictureOf(page, 'original'))).toBe(0);

  await page.getByRole('button', { name: 'Fit' }).click();
  await expect.poll(async () => difference(first[0], await pictureOf(page, 'original'))).toBeLessThan(0.001);
  expect(difference(first[1], await pictureOf(page, 'reduced'))).toBeLessThan(0.001);
});

test('draws in a dark scheme too', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'dark' });
  await openPage(page);
  await settled(page);
  await expect.poll(async () => coverage(await pictureOf(page, 'reduced'))).toBeGreaterThan(0.1);
  const picture = await pictureOf(page, 'reduced');
  expect(Math.max(...picture.pixels.subarray(0, 3))).toBeLessThan(80);
  expect(shareFromMap(picture, 'viridis')).toBeGreaterThan(0.99);
});

test('reduces and says so where nothing can be drawn', async ({ page }) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await openPage(page);
  await expect(page.getByRole('alert')).toContainText('no WebGL 2');
});

test('gives back the memory of the graphics card when a surface is replaced', async ({ page }) => {
  await page.addInitScript(() => {
    const context = WebGL2RenderingContext.prototype;
    const live = { buffers: 0, textures: 0 };
    const { createBuffer, deleteBuffer, createTexture, deleteTexture } = context;
    context.createBuffer = function () {
      live.buffers++;
      return createBuffer.call(this);
    };
    context.deleteBuffer = function (buffer) {
      live.buffers--;
      deleteBuffer.call(this, buffer);
    };
    context.createTexture = function () {
      live.textures++;
      return createTexture.call(this);
    };
    context.deleteTexture = function (texture) {
      live.textures--;
      deleteTexture.call(this, texture);
    };
    Object.assign(window, { liveOnCard: live });
  });
  const live = () => page.evaluate(() => ({ ...(window as unknown as { liveOnCard: object }).liveOnCard }));
  await openPage(page);
  await expect.poll(async () => coverage(await pictureOf(page, 'reduced'))).toBeGreaterThan(0.1);
  const first = await live();
  for (const side of [12, 14, 16, 18]) {
    await chooseFile(page, 'sheet.ply', sheet(side));
    await expect.poll(async () => (await counts(page)).before).toBe(2 * (side - 1) ** 2);
    await expect.poll(live).toEqual(first);
  }
});
