import { expect, test } from '@playwright/test';
import { look, openPage, sharePage, typePercent } from './open-page.ts';
import { coverage, difference, pictureOf, shareFromMap } from './picture.ts';

const sides = ['original', 'reduced'] as const;

test.describe('on one page', () => {
  const page = sharePage();
  const picture = (side: (typeof sides)[number]) => pictureOf(page(), side);
  const both = async () => [await picture('original'), await picture('reduced')];

  test.beforeEach(async () => {
    await look(page());
    for (const side of sides) await expect.poll(async () => coverage(await picture(side))).toBeGreaterThan(0.1);
  });

  test('draws both surfaces, in the colours of the map', async () => {
    for (const side of sides) {
      expect(shareFromMap(await picture(side), 'viridis')).toBeGreaterThan(0.99);
      expect(shareFromMap(await picture(side), 'cividis')).toBeLessThan(0.9);
    }
    const [original, reduced] = await both();
    expect(difference(original, reduced)).toBeGreaterThan(0);
    // Within such bounds it is the same object to the eye.
    expect(Math.abs(coverage(original) - coverage(reduced))).toBeLessThan(0.02);
  });

  test('another variable and another map recolour both sides, with the same range', async () => {
    const before = { original: await picture('original'), reduced: await picture('reduced') };
    await page().getByLabel('Colour').selectOption({ label: 'temperature' });
    await page().getByLabel('Map').selectOption('cividis');
    for (const side of sides) {
      await expect.poll(async () => difference(before[side], await picture(side))).toBeGreaterThan(0.1);
      expect(shareFromMap(await picture(side), 'cividis')).toBeGreaterThan(0.99);
    }
    const legends = page().locator('meshbound-legend');
    await expect(legends.locator('.title')).toHaveText(['temperature [K]', 'temperature [K]']);
    const numbers = await legends.locator('.ticks').allInnerTexts();
    expect(numbers[0]).toMatch(/\d/);
    expect(numbers[1]).toBe(numbers[0]);
  });

  test('shows a diverging map centred on zero', async () => {
    await look(page(), { colour: 'vx', map: 'RdBu' });
    const zero = page().locator('#original meshbound-legend .ticks span', { hasText: /^0$/ });
    await expect(zero).toHaveAttribute('style', /left: 50%/);
  });

  test('shows the tessellation', async () => {
    const smooth = await picture('reduced');
    await page().getByLabel('Edges').check();
    await expect.poll(async () => difference(smooth, await picture('reduced'))).toBeGreaterThan(0.05);
    // Where both sides show edges, fewer triangles cannot be missed.
    const [original, reduced] = await both();
    expect(difference(original, reduced)).toBeGreaterThan(0.05);
  });

  test('one camera turns both sides, two cameras one each, and fit brings both back', async () => {
    const first = await both();
    const pane = await page().locator('#original').boundingBox();
    const [x, y] = [(pane?.x ?? 0) + (pane?.width ?? 0) / 2, (pane?.y ?? 0) + (pane?.height ?? 0) / 2];
    await page().mouse.move(x, y);
    await page().mouse.down();
    await page().mouse.move(x + 80, y + 20, { steps: 4 });
    await page().mouse.up();
    // Nothing is pointed at in the pictures.
    await page().mouse.move(2, 2);
    await expect.poll(async () => difference(first[1], await picture('reduced'))).toBeGreaterThan(0.05);
    const turned = await both();
    expect(difference(first[0], turned[0])).toBeGreaterThan(0.05);
    expect(Math.abs(coverage(turned[0]) - coverage(turned[1]))).toBeLessThan(0.02);

    await page().getByLabel('One camera').uncheck();
    await page().locator('#reduced').press('ArrowLeft');
    await expect.poll(async () => difference(turned[1], await picture('reduced'))).toBeGreaterThan(0.02);
    expect(difference(turned[0], await picture('original'))).toBe(0);

    await page().getByRole('button', { name: 'Fit' }).click();
    await expect.poll(async () => difference(first[0], await picture('original'))).toBeLessThan(0.001);
    expect(difference(first[1], await picture('reduced'))).toBeLessThan(0.001);
  });

  test('draws in a dark scheme too', async () => {
    await page().emulateMedia({ colorScheme: 'dark' });
    const dark = async () => Math.max(...(await picture('reduced')).pixels.subarray(0, 3));
    await expect.poll(dark).toBeLessThan(80);
    expect(shareFromMap(await picture('reduced'), 'viridis')).toBeGreaterThan(0.99);
    await page().emulateMedia({ colorScheme: 'light' });
    await expect.poll(dark).toBeGreaterThan(150);
  });

  test('a coarser surface looks different, and the original stays', async () => {
    const [original, reduced] = await both();
    await typePercent(page(), 'Largest bound', '20');
    await expect.poll(async () => difference(reduced, await picture('reduced'))).toBeGreaterThan(0.02);
    expect(difference(original, await picture('original'))).toBe(0);
    await typePercent(page(), 'Largest bound', '3');
    await expect.poll(async () => difference(reduced, await picture('reduced'))).toBe(0);
  });
});

test('reduces and says so where nothing can be drawn', async ({ page }) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await openPage(page);
  await expect(page.getByRole('alert')).toContainText('no WebGL 2');
});
