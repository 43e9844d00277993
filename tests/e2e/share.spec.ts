import { readFile } from 'node:fs/promises';
import { expect, type Page, test } from '@playwright/test';
import { chooseFile, counts, dropFile, sentence, settled, sharePage, typePercent } from './open-page.ts';
import { sheet } from './surfaces.ts';

const page = sharePage();

async function choose(shown: Page, menu: string, item: string): Promise<void> {
  await shown.getByRole('button', { name: menu }).click();
  await shown.getByRole('button', { name: item, exact: true }).click();
}

test('undoes and redoes changes of bounds, a drag of a slider as one', async () => {
  const [undo, redo] = ['Undo', 'Redo'].map((name) => page().getByRole('button', { name }));
  await expect(undo).toBeDisabled();
  const first = await counts(page());
  await typePercent(page(), 'Bound of pressure', '9');
  const slider = page().getByRole('slider', { name: 'All bounds' });
  const box = await slider.boundingBox();
  const [x, y] = [(box?.x ?? 0) + 0.74 * (box?.width ?? 0), (box?.y ?? 0) + 10];
  await page().mouse.move(x, y);
  await page().mouse.down();
  await page().mouse.move(x + 60, y, { steps: 6 });
  await page().mouse.up();
  await settled(page());
  const loose = await counts(page());
  expect(loose.after).toBeLessThan(first.after);
  await undo.click();
  await expect(page().getByLabel('Bound of pressure in percent')).toHaveValue('9');
  await page().keyboard.press('Control+z');
  await expect.poll(() => counts(page())).toEqual(first);
  await expect(undo).toBeDisabled();
  await page().keyboard.press('Control+y');
  await redo.click();
  await expect.poll(() => counts(page())).toEqual(loose);
  await expect(redo).toBeDisabled();
});

test('bounds can be chosen ready-made, and stated in the variable’s unit', async () => {
  await choose(page(), 'Presets', 'Shape only');
  await expect(sentence(page())).toContainText(/within 1.% in space: proved.*nothing guaranteed: density/);
  await choose(page(), 'Presets', 'Usual');
  await page().getByLabel('How the bound of temperature is stated').selectOption('K');
  const field = page().getByLabel('Bound of temperature in K');
  await field.fill('50');
  await field.press('Enter');
  await expect(sentence(page())).toContainText(/3\.54.% in temperature/);
  await page().getByLabel('How the bound of temperature is stated').selectOption('%');
  await expect(page().getByLabel('Bound of temperature in percent')).toHaveValue('3.532');
});

test('draws how many triangles other bounds would leave, with the present ones among them', async () => {
  await choose(page(), 'Presets', 'Usual');
  await settled(page());
  await page().getByText('Triangles by bound').click();
  const chart = page().getByRole('img', { name: /^Triangles left by the largest bound/ });
  await expect(chart.locator('circle')).toHaveCount(6);
  await expect(chart.locator('circle.present')).toHaveCount(1);
  const heights = await chart
    .locator('circle')
    .evaluateAll((all) => all.map((each) => Number(each.getAttribute('cy'))));
  expect(heights).toEqual([...heights].sort((a, b) => a - b));
  await page().getByText('Triangles by bound').click();
});

test('the address holds the surface, the bounds and the view, and so do a link and a file', async ({ browser }) => {
  await page().getByLabel('Sample').selectOption('impact');
  await settled(page());
  await typePercent(page(), 'Bound of iron', '7');
  await page().getByLabel('Show').selectOption({ label: 'error / bound' });
  await page().getByLabel('Edges').check();
  await expect.poll(() => page().url()).toMatch(/#src=samples%2Fimpact\.ply&bounds=.*iron.*&show=error&edges=$/);
  const result = await sentence(page()).innerText();

  await page().context().grantPermissions(['clipboard-read', 'clipboard-write']);
  const copied = () => page().evaluate(() => navigator.clipboard.readText());
  await choose(page(), 'Share…', 'Copy link');
  await expect(page().getByRole('button', { name: 'Copied' })).toBeVisible();
  expect(await copied()).toBe(page().url());
  await expect(page().getByRole('button', { name: 'Share…' })).toBeVisible();
  await choose(page(), 'Share…', 'Copy embed code');
  await expect.poll(copied).toContain(`src="${new URL('samples/impact.ply', page().url()).href}"`);
  expect(await copied()).toContain('show="error"');
  const download = page().waitForEvent('download');
  await choose(page(), 'Share…', 'Save state');
  const state = await readFile(await (await download).path());

  const other = await browser.newPage();
  await other.goto(page().url());
  await expect(sentence(other)).toHaveText(result);
  await expect(other.getByLabel('Show')).toHaveValue('error');
  await expect(other.getByLabel('Edges')).toBeChecked();
  // Another address in the same page, as by a link in a note.
  await other.evaluate(() => {
    location.hash = '#src=samples/fireballs.ply&bounds=*:+20%25&variable=temperature';
  });
  await expect(sentence(other)).toContainText(/20.% in space, density, pressure/);
  await expect(other.getByLabel('Show')).toHaveValue('value');
  await expect(other.locator('meshbound-legend .title').first()).toHaveText('temperature [K]');
  await dropFile(other, 'state.json', state);
  await expect(sentence(other)).toHaveText(result);
  await dropFile(other, 'other.json', Buffer.from('{}'));
  await expect(other.getByRole('alert')).toContainText('other.json: This is no state of the viewer');
  await other.close();
});

test('levels of detail, and which is shown, are in the address', async ({ browser }) => {
  await page().getByLabel('Sample').selectOption('fireballs');
  await settled(page());
  await page().getByLabel('Levels of detail').selectOption('2');
  const position = page().getByRole('slider', { name: 'Position among levels' });
  await expect(position).toBeEnabled();
  await page().getByRole('button', { name: 'Level 2' }).click();
  await expect.poll(() => page().url()).toMatch(/level-count=2&level=2$/);
  const other = await browser.newPage();
  await other.goto(page().url());
  await expect(other.locator('#reduced .caption')).toContainText('Level 2');
  await expect(other.getByLabel('Levels of detail')).toHaveValue('2');
  expect(await other.locator('#reduced .caption').innerText()).toBe(
    await page().locator('#reduced .caption').innerText(),
  );
  await other.close();
  await page().getByLabel('Levels of detail').selectOption('0');
  await expect.poll(() => page().url()).not.toContain('level');
});

test('a file of the user’s leaves no trace in the address', async () => {
  await chooseFile(page(), 'secret.ply', sheet(20));
  await expect.poll(async () => (await counts(page())).before).toBe(2 * 19 * 19);
  await expect.poll(() => page().url()).not.toContain('#');
  await page().getByRole('button', { name: 'Share…' }).click();
  await expect(page().getByRole('button', { name: 'Copy link' })).toBeDisabled();
  await expect(page().getByRole('button', { name: 'Copy link' })).toHaveAttribute(
    'title',
    /cannot hold a file of yours/,
  );
});
