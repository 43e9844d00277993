import { readFile } from 'node:fs/promises';
import { expect, type Locator, type Page, test } from '@playwright/test';

/** The sentence that states the result. */
export function sentence(page: Page): Locator {
  return page.locator('.sentence');
}

/** Opens the page and waits for its first result. */
export async function openPage(page: Page): Promise<void> {
  await page.goto('./');
  await expect(sentence(page)).toContainText('proved');
  await settled(page);
}

/**
 * One page, opened once for all tests of a file, one after the other; a failed test gives the next one a page of its own.
 * Each test sets what it needs, whatever the one before left behind.
 */
export function sharePage(): () => Page {
  let page: Page;
  test.describe.configure({ mode: 'default' });
  test.beforeAll(async ({ browser }) => {
    page = await browser.newPage();
    await openPage(page);
  });
  test.afterAll(() => page.close());
  return () => page;
}

/** Sets a view by the controls of the toolbar; what is left out is as at first. */
export async function look(
  page: Page,
  { colour = 'pressure', show = 'values', map = 'viridis', edges = false, linked = true } = {},
): Promise<void> {
  await page.getByLabel('Show').selectOption({ label: 'values' });
  await page.getByLabel('Map').selectOption(map);
  // Which variables there are to choose depends on what is shown; signs, on the variable.
  if (show !== 'values') await page.getByLabel('Show').selectOption({ label: 'error / bound' });
  await page.getByLabel('Colour').selectOption({ label: colour });
  await page.getByLabel('Show').selectOption({ label: show });
  await page.getByLabel('Edges').setChecked(edges);
  await page.getByLabel('One camera').setChecked(linked);
  await page.getByRole('button', { name: 'Fit' }).click();
}

/** Types a percentage into a field, and waits for the result. */
export async function typePercent(page: Page, label: string, percent: string): Promise<void> {
  const field = page.getByLabel(`${label} in percent`);
  await field.fill(percent);
  await field.press('Enter');
  await settled(page);
}

/** Waits until nothing is read or reduced any more. */
export async function settled(page: Page): Promise<void> {
  await expect(page.locator('.numbers')).toContainText('removed');
}

export interface Counts {
  after: number;
  before: number;
}

/** The numbers of triangles that the sentence states. */
export async function counts(page: Page): Promise<Counts> {
  await expect(sentence(page)).not.toContainText(/Provisional|bounds before/);
  const text = (await sentence(page).innerText()).replace(/[\u202f\u00a0]/g, '');
  const [, after, before] = /^(\d+) of (\d+) triangles/.exec(text) ?? [];
  return { after: Number(after), before: Number(before) };
}

/** Chooses a file as the Open button does. */
export async function chooseFile(page: Page, name: string, content: Buffer): Promise<void> {
  const file = { name, mimeType: 'application/octet-stream', buffer: content };
  await page.locator('input[type=file]').setInputFiles(file);
}

/** Saves the result by the menu: in a format, or its map. */
export async function saved(shown: Page, format: string, menu = 'Save…'): Promise<{ name: string; bytes: Uint8Array }> {
  const started = shown.waitForEvent('download');
  await shown.getByRole('button', { name: menu }).click();
  const name = { map: 'Map (VTP)', report: 'Report (JSON)', levels: 'Levels (GLB)' }[format] ?? format.toUpperCase();
  await shown.getByRole('button', { name, exact: true }).click();
  const download = await started;
  return { name: download.suggestedFilename(), bytes: new Uint8Array(await readFile(await download.path())) };
}

/** Drops a file onto the page. */
export async function dropFile(page: Page, name: string, content: Buffer): Promise<void> {
  const transfer = await page.evaluateHandle(
    ({ fileName, base64 }) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const data = new DataTransfer();
      data.items.add(new File([bytes], fileName));
      return data;
    },
    { fileName: name, base64: content.toString('base64') },
  );
  for (const event of ['dragenter', 'dragover', 'drop']) {
    await page.dispatchEvent('meshbound-app', event, { dataTransfer: transfer });
  }
}
