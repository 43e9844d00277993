import { readFile } from 'node:fs/promises';
import { expect, test } from '@playwright/test';
import { look, sharePage } from './open-page.ts';
import { coverage, difference, pictureOf, shareFromMap } from './picture.ts';

const page = sharePage();
const picture = (side: 'original' | 'reduced') => pictureOf(page(), side);

test.beforeEach(async () => {
  await page().getByRole('combobox', { name: 'View' }).selectOption('split');
  await look(page());
});

test('one surface alone, and one over the other with a divider', async () => {
  const view = page().getByRole('combobox', { name: 'View' });
  await view.selectOption('original');
  await expect(page().locator('#reduced')).toBeHidden();
  const original = await picture('original');
  expect(coverage(original)).toBeGreaterThan(0.1);
  await view.selectOption('reduced');
  await expect(page().locator('#original')).toBeHidden();
  const reduced = await picture('reduced');
  expect(difference(original, reduced)).toBeGreaterThan(0.02);

  await view.selectOption('wipe');
  const divider = page().getByRole('slider', { name: 'How much of the stage shows the original' });
  await divider.press('End');
  await divider.press('End');
  await expect.poll(async () => difference(await picture('original'), original)).toBeLessThan(0.02);
  await divider.press('Home');
  await expect.poll(async () => difference(await picture('original'), reduced)).toBeLessThan(0.02);
  const handle = await divider.boundingBox();
  const stage = await page().locator('meshbound-stage').boundingBox();
  await page().mouse.move((handle?.x ?? 0) + 16, (stage?.y ?? 0) + 300);
  await page().mouse.down();
  await page().mouse.move((stage?.x ?? 0) + 0.25 * (stage?.width ?? 0), (stage?.y ?? 0) + 300, { steps: 3 });
  await page().mouse.up();
  await expect(divider).toHaveAttribute('aria-valuenow', '25');
});

test('looks along axes, in parallel, through a plane, shaded flat, and keeps all of it in the address', async () => {
  const first = await picture('original');
  await page().getByRole('button', { name: 'More' }).click();
  await page().getByRole('button', { name: 'From +x' }).click();
  await expect.poll(async () => difference(first, await picture('original'))).toBeGreaterThan(0.05);
  const along = await picture('original');
  await page().getByLabel('Parallel, no perspective').check();
  await expect.poll(async () => difference(along, await picture('original'))).toBeGreaterThan(0.005);
  await page().getByLabel('Flat shading').check();
  const whole = coverage(await picture('original'));
  const cut = page().getByLabel('Cut at');
  await cut.fill('y < nowhere');
  await cut.press('Enter');
  await expect(cut).toHaveAttribute('aria-invalid', 'true');
  await cut.fill('y < 0');
  await cut.press('Enter');
  await expect.poll(async () => coverage(await picture('original'))).toBeLessThan(0.8 * whole);
  await expect.poll(() => page().url()).toMatch(/flat=&orthographic=&clip=y\+%3C\+0&camera=/);
  await page().getByLabel('Flat shading').uncheck();
  await page().getByLabel('Parallel, no perspective').uncheck();
  await cut.fill('');
  await cut.press('Enter');
  await page().keyboard.press('Escape');
  await page().getByRole('button', { name: 'Fit' }).click();
  await expect.poll(() => page().url()).not.toMatch(/flat|orthographic|clip|camera|view|show/);
  expect(difference(first, await picture('original'))).toBeLessThan(0.001);
});

test('colours a range that is chosen, and marks what lies beyond it', async () => {
  await page().getByRole('button', { name: 'More' }).click();
  const range = page().getByLabel('Range');
  await range.fill('0.1…0.2');
  await range.press('Enter');
  const legend = page().locator('#original meshbound-legend');
  await expect(legend.locator('.swatch')).toHaveCount(2);
  await expect.poll(async () => shareFromMap(await picture('original'), 'viridis')).toBeLessThan(0.9);
  await range.fill('');
  await range.press('Enter');
  await expect(legend.locator('.swatch')).toHaveCount(0);
  await page().keyboard.press('Escape');
});

test('a range of percentiles can be chosen, and leaves what is beyond it marked in the picture, too', async () => {
  await page().getByRole('button', { name: 'More' }).click();
  const range = page().getByLabel('Range');
  expect(await range.evaluate((input: HTMLInputElement) => input.list?.options.length)).toBeGreaterThan(2);
  const ticks = page().locator('#original meshbound-legend .ticks');
  const before = await ticks.innerText();
  await range.fill('10%…90%');
  await range.press('Enter');
  await expect(ticks).not.toHaveText(before);
  const saved = await page()
    .locator('meshbound-viewer')
    .evaluate(async (viewer: HTMLElementTagNameMap['meshbound-viewer']) => {
      const bitmap = await createImageBitmap(await viewer.toBlob());
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      context?.drawImage(bitmap, 0, 0);
      // The last line of the legend on the left.
      const data = context?.getImageData(0, bitmap.height - 30, 300, 30).data ?? [];
      const count = (wanted: number[]) =>
        Array.from({ length: 300 * 30 }, (_, pixel) => pixel).filter((pixel) =>
          wanted.every((part, index) => data[4 * pixel + index] === part),
        ).length;
      return { below: count([0, 0, 255]), above: count([0, 255, 255]) };
    });
  expect(saved).toEqual({ below: 100, above: 100 });
  await range.fill('');
  await range.press('Enter');
  await page().keyboard.press('Escape');
});

test('a cut is moved by a slider, and triangles may be drawn on their fronts only', async () => {
  const whole = coverage(await picture('original'));
  await page().getByRole('button', { name: 'More' }).click();
  const slider = page().getByRole('slider', { name: 'Place of the cut' });
  await expect(slider).toBeDisabled();
  await page().getByLabel('What the cut keeps').selectOption('x <');
  await expect.poll(async () => coverage(await picture('original'))).toBeLessThan(0.9 * whole);
  const half = coverage(await picture('original'));
  const inside = await picture('original');
  await page().getByLabel('Both sides of triangles').uncheck();
  await expect.poll(async () => difference(inside, await picture('original'))).toBeGreaterThan(0.01);
  await expect.poll(() => page().url()).toMatch(/cull=&clip=x/);
  await page().getByLabel('Both sides of triangles').check();
  await slider.press('Home');
  await expect.poll(async () => coverage(await picture('original'))).toBeLessThan(0.01);
  await slider.press('End');
  await expect.poll(async () => coverage(await picture('original'))).toBeGreaterThan(half);
  await page().getByLabel('What the cut keeps').selectOption('all');
  await expect.poll(async () => coverage(await picture('original'))).toBe(whole);
  await page().keyboard.press('Escape');
});

test('two cameras are in the address, both of them, and Fit takes them out', async ({ browser }) => {
  await page().getByLabel('One camera').uncheck();
  await page().locator('#reduced').press('ArrowLeft');
  await page().locator('#original').press('ArrowUp');
  await expect.poll(() => page().url()).toMatch(/unlinked=&camera=[^&]*%3B/);
  const sides = ['original', 'reduced'] as const;
  const other = await browser.newPage();
  await other.goto(page().url());
  for (const side of sides) {
    await expect.poll(async () => difference(await picture(side), await pictureOf(other, side))).toBeLessThan(0.005);
  }
  await other.getByRole('button', { name: 'Fit' }).click();
  await expect.poll(() => other.url()).not.toContain('camera');
  await other.close();
  await page().getByLabel('One camera').check();
});

test('one notice says all that a saved file has no place for', async () => {
  await page().getByRole('button', { name: 'Save…' }).click();
  await page().getByRole('button', { name: 'STL', exact: true }).click();
  const notices = page().locator('meshbound-notices [role=status]');
  await expect(notices.first()).toContainText(/variables .*“temperature”\. .*units of “position”\./);
  await expect(notices).toHaveCount(1);
  await notices.getByRole('button', { name: 'Dismiss' }).click();
});

test('saves a picture, with the legends or without', async () => {
  const saved = async (item: string) => {
    const started = page().waitForEvent('download');
    await page().getByRole('button', { name: 'Save…' }).click();
    await page().getByRole('button', { name: item, exact: true }).click();
    const download = await started;
    expect(download.suggestedFilename()).toBe('fireballs-picture.png');
    const base64 = (await readFile(await download.path())).toString('base64');
    // How much of the lower left corner, where the legend is, is not background.
    return page().evaluate(async (content) => {
      const bytes = Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const context = new OffscreenCanvas(300, 70).getContext('2d') as OffscreenCanvasRenderingContext2D;
      context.drawImage(bitmap, 0, 70 - bitmap.height);
      const { data } = context.getImageData(0, 0, 300, 70);
      const differs = (pixel: number) => [0, 1, 2].some((part) => Math.abs(data[4 * pixel + part] - data[part]) > 8);
      const count = Array.from({ length: 300 * 70 }, (_, pixel) => differs(pixel)).filter(Boolean).length;
      return { width: bitmap.width, height: bitmap.height, legend: count / (300 * 70) };
    }, base64);
  };
  const stage = await page().locator('meshbound-stage').boundingBox();
  const withLegends = await saved('Picture (PNG)');
  expect(withLegends).toMatchObject({ width: Math.round(stage?.width ?? 0), height: Math.round(stage?.height ?? 0) });
  expect(withLegends.legend).toBeGreaterThan(0.1);
  expect((await saved('Picture, no legends')).legend).toBe(0);
});

test('keys work anywhere, and a list of them is at hand', async () => {
  await page().locator('#original').press('h');
  const list = page().getByRole('dialog', { name: 'Keys' });
  await expect(list).toContainText('undo and redo');
  await page().keyboard.press('h');
  await expect(list).toBeHidden();
  await page().getByRole('button', { name: 'Keys' }).click();
  await list.getByRole('button', { name: 'Close' }).click();
  await page().locator('#original').press('e');
  await expect(page().getByLabel('Edges')).toBeChecked();
  await page().getByLabel('Bound of pressure in percent').press('e');
  await expect(page().getByLabel('Edges')).toBeChecked();
  await page().getByLabel('Bound of pressure in percent').press('Escape');
});
