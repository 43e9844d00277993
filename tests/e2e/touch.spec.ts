import { type CDPSession, expect, type Page, test } from '@playwright/test';
import { openPage } from './open-page.ts';
import { coverage, difference, pictureOf } from './picture.ts';

test.use({ hasTouch: true, viewport: { width: 390, height: 844 } });

type Point = { x: number; y: number };

async function middleOf(page: Page, selector: string): Promise<Point> {
  const box = await page.locator(selector).boundingBox();
  if (!box) throw new Error(`${selector} is not shown`);
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Fingers that go down together, move in a few steps, and leave together. */
async function touch(session: CDPSession, fingers: { from: Point; to: Point }[]): Promise<void> {
  const steps = 5;
  const at = (share: number) =>
    fingers.map(({ from, to }, id) => ({
      id,
      x: from.x + share * (to.x - from.x),
      y: from.y + share * (to.y - from.y),
    }));
  await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: at(0) });
  for (let step = 1; step <= steps; step++) {
    await session.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: at(step / steps) });
  }
  await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
}

test('a finger turns both surfaces, two zoom, one moves the divider, and the page scrolls beside them', async ({
  page,
}) => {
  await openPage(page);
  const session = await page.context().newCDPSession(page);
  const reduced = () => pictureOf(page, 'reduced');
  await expect.poll(async () => coverage(await reduced())).toBeGreaterThan(0.1);
  const first = await reduced();
  const middle = await middleOf(page, '#original');
  await touch(session, [{ from: middle, to: { x: middle.x + 60, y: middle.y } }]);
  await expect.poll(async () => difference(first, await reduced())).toBeGreaterThan(0.02);
  expect(await page.evaluate(() => scrollY)).toBe(0);

  const before = coverage(await reduced());
  await touch(session, [
    { from: { x: middle.x - 30, y: middle.y }, to: { x: middle.x - 12, y: middle.y } },
    { from: { x: middle.x + 30, y: middle.y }, to: { x: middle.x + 12, y: middle.y } },
  ]);
  await expect.poll(async () => coverage(await reduced())).toBeLessThan(0.7 * before);

  await page.getByLabel('View').selectOption('wipe');
  const handle = await middleOf(page, '.divider');
  await touch(session, [{ from: handle, to: { x: handle.x - 100, y: handle.y } }]);
  const divider = page.getByRole('slider', { name: 'How much of the stage shows the original' });
  expect(Number(await divider.getAttribute('aria-valuenow'))).toBeLessThan(30);

  const beside = await middleOf(page, 'meshbound-levels-panel');
  await touch(session, [{ from: beside, to: { x: beside.x, y: beside.y - 200 } }]);
  await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(50);
});

test('what is to be touched is large enough', async ({ page }) => {
  await openPage(page);
  // 24 CSS pixels, as WCAG 2.2 asks for (2.5.8), of the control or of the label that works it.
  const small = await page.evaluate(() => {
    const found: string[] = [];
    const visit = (root: ParentNode) => {
      for (const element of root.querySelectorAll<HTMLElement>('*')) {
        if (element.shadowRoot) visit(element.shadowRoot);
        if (!element.matches('button, select, summary, input:not([hidden]), [role=slider]')) continue;
        const target = element.closest('label') ?? element;
        const { width, height } = target.getBoundingClientRect();
        if (width > 0 && Math.min(width, height) < 24) {
          found.push(
            `${element.localName} ${element.getAttribute('aria-label') ?? element.textContent} ${width} × ${height}`,
          );
        }
      }
    };
    visit(document);
    return found;
  });
  expect(small).toEqual([]);
});
