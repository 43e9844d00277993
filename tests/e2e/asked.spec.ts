import { expect, test } from '@playwright/test';
import { chooseFile, openPage, saved, sentence, settled } from './open-page.ts';
import { sheet } from './surfaces.ts';

test('what is shown after a bound was refused is not passed off as its result', async ({ page }) => {
  await openPage(page);
  const row = page.locator('meshbound-bound-row').filter({ has: page.getByLabel('Bound of pressure in percent') });
  const field = page.getByLabel('Bound of pressure in percent');
  await field.fill('1e-9');
  await field.press('Enter');
  await page.getByRole('alert').getByRole('button', { name: 'Dismiss' }).click();
  await expect(sentence(page)).toContainText(
    /^\s*Not with what is asked for, which was refused, but with the bounds before: \d/,
  );
  await expect(row).toContainText('shown with 3 %:');
  await expect(page.getByRole('button', { name: 'Save the earlier result…' })).toBeEnabled();
  await expect(page.locator('.caption').filter({ hasText: 'Reduced' })).toContainText('earlier bounds');
  await saved(page, 'ply', 'Save the earlier result…');
  await expect(
    page.getByText(/holds the result with the bounds before, position: 1%;.* what is asked for now was not/),
  ).toBeVisible();
  // Asked for anew, the sentence is about what is asked for.
  await field.fill('3');
  await field.press('Enter');
  await expect(sentence(page)).toContainText(/^\s*\d/);
  await expect(row).not.toContainText('shown with');
});

test('a picture of an earlier result says so, and of which', async ({ page }) => {
  await openPage(page);
  const upperEdge = () =>
    page.evaluate(async () => {
      const app = document.querySelector('meshbound-app') as unknown as { viewer: { toBlob(): Promise<Blob> } };
      const picture = await createImageBitmap(await app.viewer.toBlob());
      const canvas = new OffscreenCanvas(picture.width, 20);
      const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;
      context.drawImage(picture, 0, 0);
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      const first = data.slice(0, 3).join();
      let others = 0;
      for (let at = 0; at < data.length; at += 4) if (data.slice(at, at + 3).join() !== first) others++;
      return others;
    });
  expect(await upperEdge()).toBe(0);
  const field = page.getByLabel('Bound of pressure in percent');
  await field.fill('1e-9');
  await field.press('Enter');
  await expect(sentence(page)).toContainText('refused');
  expect(await upperEdge()).toBeGreaterThan(200);
});

test('the same refused bound, asked for twice, has one message', async ({ page }) => {
  await openPage(page);
  const field = page.getByLabel('Bound of pressure in percent');
  for (const bound of ['1e-9', '1e-9']) {
    await field.fill(bound);
    await field.press('Enter');
    await expect(sentence(page)).toContainText('refused');
  }
  await expect(page.getByRole('alert')).toHaveCount(1);
});

for (const [name, width] of [
  ['wide', 1280],
  ['narrow', 390],
  ['zoomed', 640],
] as const) {
  test(`four digits with their exponent fit their field: ${name}`, async ({ page }) => {
    await page.setViewportSize({ width, height: 800 });
    await openPage(page);
    const field = page.getByLabel('Bound of pressure in percent');
    for (const text of ['0.000968', '0.003333', '1.234e-10', '0.0001234']) {
      const cut = await field.evaluate((input: HTMLInputElement, value) => {
        input.value = value;
        return input.scrollWidth - input.clientWidth;
      }, text);
      expect(cut, text).toBeLessThanOrEqual(0);
    }
  });
}

test('a bound that is shown in its unit and back is the one that was typed', async ({ page }) => {
  await openPage(page);
  const field = page.getByLabel('Bound of pressure in percent');
  await field.fill('0.01');
  await field.press('Enter');
  const stated = page.getByLabel('How the bound of pressure is stated');
  await stated.selectOption('unit');
  await stated.selectOption('percent');
  await expect(field).toHaveValue('0.01');
});

test('levels that a morph needed go with it, and those that were asked for stay', async ({ page }) => {
  await openPage(page);
  const view = page.getByLabel('View');
  const levels = page.getByLabel('Levels of detail');
  await view.selectOption('morph');
  await expect(levels.first()).toHaveValue('4');
  await view.selectOption('split');
  await expect(levels.first()).toHaveValue('0');
});

test('a link to a file of the user’s is not offered', async ({ page }) => {
  await openPage(page);
  await chooseFile(page, 'sheet.ply', sheet(12));
  await expect(page).toHaveTitle(/./);
  await settled(page);
  await page.getByRole('button', { name: 'Share…' }).click();
  await expect(page.getByRole('button', { name: 'Save state' })).toBeVisible();
  await expect(page.getByRole('button', { name: 'Copy link' })).toBeDisabled();
});

test('in a wipe each half has a legend of its own, where they show errors differently', async ({ page }) => {
  await openPage(page);
  await page.getByLabel('View').selectOption('wipe');
  await expect(page.locator('meshbound-legend:visible')).toHaveCount(1);
  await page.getByLabel('Show').first().selectOption({ label: 'error / bound' });
  await expect(page.locator('#original meshbound-legend')).toContainText('true error at each vertex');
  await expect(page.locator('#reduced meshbound-legend')).toContainText('largest error in each triangle');
  await expect(page.locator('#reduced meshbound-legend')).toBeVisible();
  const [left, right] = await Promise.all(
    ['original', 'reduced'].map((side) => page.locator(`#${side} meshbound-legend`).boundingBox()),
  );
  expect((left?.x ?? 0) + (left?.width ?? 0)).toBeLessThanOrEqual(right?.x ?? 0);
});
