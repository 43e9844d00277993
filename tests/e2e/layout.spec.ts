import { expect, type Page, test } from '@playwright/test';
import { openPage, settled, typePercent } from './open-page.ts';
import { coverage, pictureOf } from './picture.ts';

/** Where the parts of the page have stood, each time that one of them stood elsewhere; how far it is scrolled aside. */
async function watchParts(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const seen: string[] = [];
    Object.assign(window, { seen });
    const parts = ['meshbound-toolbar', 'meshbound-viewer', 'meshbound-levels-panel', '.bounds'];
    const look = () => {
      requestAnimationFrame(look);
      const page = document.querySelector('meshbound-app')?.shadowRoot;
      const panel = page?.querySelector('meshbound-bounds-panel')?.shadowRoot;
      const boxes = [...parts.map((part) => page?.querySelector(part)), panel?.querySelector('.row')].map((element) => {
        const box = element?.getBoundingClientRect();
        return box && `${element?.className || element?.localName} ${box.x} ${box.y + scrollY} ${box.width}`;
      });
      // Not before everything is there.
      if (boxes.every((box) => box) && boxes.join('; ') !== seen.at(-1)) seen.push(boxes.join('; '));
    };
    look();
  });
}

test('on a narrow page a guarantee of more lines than there is room for can be read whole', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await openPage(page);
  const sentence = page.locator('.sentence');
  const isCut = () => sentence.evaluate(({ scrollHeight, clientHeight }) => scrollHeight > clientHeight);
  const whole = page.getByRole('button', { name: 'Show all' });
  await page.locator('summary', { hasText: 'Finer bounds' }).click();
  await page.getByLabel('Finer near a place').check();
  await expect(sentence).toContainText('the multiplier there');
  await expect.poll(isCut).toBe(true);
  await whole.focus();
  await page.keyboard.press('Enter');
  await expect.poll(isCut).toBe(false);
  await expect(sentence).toBeInViewport({ ratio: 1 });
  const less = page.getByRole('button', { name: 'Show less' });
  await expect(less).toBeFocused();
  await less.click();
  await expect.poll(isCut).toBe(true);
  await page.setViewportSize({ width: 1280, height: 800 });
  await expect.poll(isCut).toBe(false);
  await expect(whole).toHaveCount(0);
});

test('on a narrow page the place where an error is largest is brought into the window, from the bounds below', async ({
  page,
}) => {
  await page.setViewportSize({ width: 320, height: 640 });
  await openPage(page);
  await page
    .getByRole('button', { name: /^error/ })
    .nth(2)
    .click();
  await expect(page.getByRole('group', { name: 'Probe' })).toBeInViewport();
  await expect(page.locator('.marker:not(.hidden)').first()).toBeInViewport();
});

test('menus keep off the edge of the window', async ({ page }) => {
  await openPage(page);
  for (const opener of ['Save…', 'More']) {
    await page.getByRole('button', { name: opener, exact: true }).click();
    const box = await page.locator('[popover]:popover-open').boundingBox();
    expect((box?.x ?? 0) + (box?.width ?? Infinity)).toBeLessThanOrEqual(1280 - 4);
    await page.keyboard.press('Escape');
  }
});

for (const [width, height] of [
  [320, 640],
  [800, 900],
  [1280, 800],
  [1920, 1080],
]) {
  test(`nothing jumps while a surface comes and bounds change, at ${width} × ${height}`, async ({ page }) => {
    await watchParts(page);
    await page.setViewportSize({ width, height });
    await openPage(page);
    await expect.poll(async () => coverage(await pictureOf(page, 'original'))).toBeGreaterThan(0.05);
    for (const percent of ['5', '40', '0.4']) await typePercent(page, 'Largest bound', percent);
    await page.getByRole('checkbox', { name: 'vx bounded' }).uncheck();
    await settled(page);
    await page.getByLabel('Sample').selectOption('impact');
    await expect(page.locator('.sentence')).toContainText('iron');
    await settled(page);
    expect(await page.evaluate(() => (window as unknown as { seen: string[] }).seen)).toHaveLength(1);
    await page.evaluate(() => scrollTo(0, 0));
    await expect.poll(async () => coverage(await pictureOf(page, 'original'))).toBeGreaterThan(0.05);
  });
}
