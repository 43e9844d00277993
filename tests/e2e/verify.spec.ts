// Verify, in the panel: the judge is loaded when he is asked, and says what he found of the result that is shown.
import { expect, type Page, test } from '@playwright/test';
import { chooseFile, counts, openPage, settled, typePercent } from './open-page.ts';
import { sheet } from './surfaces.ts';

const group = (page: Page) => page.locator('meshbound-verification');
const summary = (page: Page) => group(page).locator('summary');
const verify = (page: Page) => group(page).getByRole('button', { name: 'Verify' });

test('says how far the farthest points are, in bounds, and of another result nothing', async ({ page }) => {
  const loaded: string[] = [];
  page.on('request', (request) => loaded.push(request.url()));
  const faults: string[] = [];
  page.on('pageerror', ({ message }) => faults.push(message));
  page.on('console', (message) => message.type() === 'error' && faults.push(message.text()));
  await openPage(page);
  await expect(summary(page)).toContainText('not asked for');
  expect(loaded.filter((address) => address.includes('judge'))).toEqual([]);

  await summary(page).click();
  await verify(page).click();
  await expect(group(page).getByRole('status')).toContainText('Every bound holds at each of');
  await expect(summary(page)).toContainText('bounds hold');
  expect(loaded.filter((address) => /judge.*\.wasm/.test(address))).toHaveLength(1);
  const [there, back] = await group(page).locator('dd').allInnerTexts();
  for (const found of [there, back]) {
    expect(found).toMatch(/^[\d.]+.%, in \w+$/);
    expect(Number.parseFloat(found)).toBeLessThanOrEqual(100);
  }
  expect(Number.parseFloat(there)).toBeGreaterThan(50);

  await typePercent(page, 'Largest bound', '2');
  await expect(summary(page)).toContainText('not asked for');
  expect(await group(page).locator('dd').count()).toBe(0);
  expect(faults).toEqual([]);
});

test('is cancelled, and stops for a reduction', async ({ page }) => {
  await openPage(page);
  await chooseFile(page, 'sheet.ply', sheet(320));
  await expect.poll(async () => (await counts(page)).before).toBe(2 * 319 * 319);
  await settled(page);
  await summary(page).click();
  await verify(page).click();
  await expect(summary(page)).toContainText('%');
  // At once: to wait until nothing moves would be to wait for the verdict.
  await group(page).getByRole('button', { name: 'Cancel' }).dispatchEvent('click');
  await expect(summary(page)).toContainText('not asked for');

  await verify(page).click();
  await expect(summary(page)).toContainText('%');
  await typePercent(page, 'Largest bound', '2');
  await expect(summary(page)).toContainText('not asked for');
  await verify(page).click();
  await expect(summary(page)).toContainText('bounds hold');
});
