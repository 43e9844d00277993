import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';
import { counts, dropFile, look, openPage, settled, sharePage } from './open-page.ts';
import { coverage, difference, pictureOf } from './picture.ts';
import { squareWithNaN } from './surfaces.ts';

async function violations(page: Page): Promise<string[]> {
  const result = await new AxeBuilder({ page }).analyze();
  return result.violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target, failureSummary }) => `${id} ${target} ${failureSummary}`),
  );
}

test('axe finds nothing wrong, light and dark, with values, errors, the method, notices and faults', async ({
  page,
}) => {
  await openPage(page);
  const both = async () => {
    for (const colorScheme of ['light', 'dark'] as const) {
      await page.emulateMedia({ colorScheme });
      expect(await violations(page)).toEqual([]);
    }
  };
  await both();
  await page.getByLabel('Show').selectOption({ label: 'signed error' });
  await page.getByText(/^Method/).click();
  await page.getByText('Errors by area').click();
  await dropFile(page, 'square.ply', squareWithNaN());
  await expect(page.getByRole('button', { name: 'Leave out “pressure”' })).toBeVisible();
  const field = page.getByLabel('Bound of position in percent');
  await field.fill('0');
  await field.press('Enter');
  await expect(page.getByRole('alert')).toHaveCount(1);
  await expect(page.getByRole('checkbox', { name: 'pressure bounded' })).not.toBeChecked();
  await settled(page);
  await both();
});

test('axe finds nothing wrong in what opens, and on a narrow page', async ({ page }) => {
  test.slow();
  await openPage(page);
  await page.getByText('Triangles by bound').click();
  await page.getByText('Errors by area').click();
  await page.getByRole('combobox', { name: 'View' }).selectOption('wipe');
  await page.getByLabel('Levels of detail').selectOption('2');
  await expect(page.getByRole('slider', { name: 'Position among levels' })).toBeEnabled();
  expect(await violations(page)).toEqual([]);
  for (const opener of ['More', 'Save…', 'Share…', 'Presets', 'Keys']) {
    await page.getByRole('button', { name: opener }).click();
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press('Escape');
  }
  await page.setViewportSize({ width: 320, height: 640 });
  expect(await violations(page)).toEqual([]);
});

test('nothing moves of its own accord, but for progress', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openPage(page);
  const moving = await page.evaluate(() => {
    const found: string[] = [];
    const visit = (root: ParentNode) => {
      for (const element of root.querySelectorAll('*')) {
        const { transitionDuration, animationDuration } = getComputedStyle(element);
        const durations = `${transitionDuration}, ${animationDuration}`.split(', ');
        if (durations.some((duration) => Number.parseFloat(duration) > 0)) found.push(element.outerHTML.slice(0, 80));
        if (element.shadowRoot) visit(element.shadowRoot);
      }
    };
    visit(document);
    return found;
  });
  expect(moving).toEqual([]);
});

test('everything works from the keyboard, with the focus in sight', async ({ page }) => {
  await openPage(page);
  const first = await counts(page);
  const focused: string[] = [];
  for (let press = 0; press < 26; press++) {
    await page.keyboard.press('Tab');
    focused.push(await describeFocus(page));
  }
  expect(focused.map((text) => text.split('|')[1])).not.toContain('hidden');
  const names = focused.map((text) => text.split('|')[0]);
  for (const name of ['Open…', 'Sample', 'Edges', 'Fit', 'All bounds', 'Bound of position', 'position bounded']) {
    expect(names).toContain(name);
  }

  const slider = page.getByRole('slider', { name: 'All bounds' });
  await slider.focus();
  for (let press = 0; press < 5; press++) await slider.press('PageUp');
  await expect.poll(async () => (await counts(page)).after).toBeLessThan(first.after);

  const pane = page.locator('#original');
  await expect.poll(async () => coverage(await pictureOf(page, 'original'))).toBeGreaterThan(0.1);
  const before = await pictureOf(page, 'original');
  for (const key of ['ArrowLeft', 'ArrowUp', 'Shift+ArrowRight', '+']) await pane.press(key);
  await expect.poll(async () => difference(before, await pictureOf(page, 'original'))).toBeGreaterThan(0.05);
  await pane.press('0');
  await expect.poll(async () => difference(before, await pictureOf(page, 'original'))).toBeLessThan(0.001);
});

/** Name of what has the focus, and whether one can see that it has. */
function describeFocus(page: Page): Promise<string> {
  return page.evaluate(() => {
    let element = document.activeElement;
    while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
    if (!element) return '|hidden';
    const label =
      (element as HTMLInputElement).labels?.[0]?.querySelector('span') ?? (element as HTMLInputElement).labels?.[0];
    const name = element.getAttribute('aria-label') ?? label?.textContent ?? element.textContent ?? '';
    const { outlineStyle, outlineWidth } = getComputedStyle(element);
    const visible = outlineStyle !== 'none' && Number.parseFloat(outlineWidth) >= 2;
    return `${name.trim()}|${visible ? 'visible' : 'hidden'}`;
  });
}

test.describe('at every size', () => {
  const page = sharePage();

  for (const [width, height] of [
    [320, 640],
    [390, 844],
    [1024, 700],
    [3840, 2160],
  ]) {
    test(`fits ${width} × ${height}`, async () => {
      await page().setViewportSize({ width, height });
      // With the largest legends.
      await look(page(), { colour: 'position', show: 'signed error' });
      expect(await page().evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
      for (const side of ['original', 'reduced'] as const) {
        await page().locator(`#${side}`).scrollIntoViewIfNeeded();
        await expect.poll(async () => coverage(await pictureOf(page(), side))).toBeGreaterThan(0.05);
      }
      await page().getByLabel('Bound of temperature in percent').scrollIntoViewIfNeeded();
      await expect(page().getByLabel('Bound of temperature in percent')).toBeInViewport({ ratio: 1 });
    });
  }
});
