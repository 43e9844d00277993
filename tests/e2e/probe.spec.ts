import AxeBuilder from '@axe-core/playwright';
import { expect, type Locator, test } from '@playwright/test';
import type { Mesh } from '../../wasm/types.ts';
import type { MeshboundViewer } from '../../web/element/meshbound-viewer.ts';
import { distance } from '../../web/probe/place.ts';
import type { Probe, ProbedPlace, Side } from '../../web/probe/probe.ts';
import { look, openPage, settled, sharePage, typePercent } from './open-page.ts';
import { coverage, difference, pictureOf } from './picture.ts';

const page = sharePage();
const card = () => page().getByRole('group', { name: 'Probe' });
const marker = (side: Side) => page().locator(`.marker.${side}`);
const view = () => page().getByRole('combobox', { name: 'View' });

/** Of sums of a few values up to some thousand. */
const rounding = 1e-9;

/** What an element's event last told. */
interface Told {
  probe: Probe | null;
  pinned: boolean;
}

test.beforeEach(async () => {
  await page().keyboard.press('Escape');
  await page().mouse.move(2, 2);
  await view().selectOption('split');
  await look(page());
  await expect(card()).toHaveCount(0);
});

/** Moves the pointer to a place of a pane, 0…1 across and down, and waits until both surfaces are known there. */
async function pointAt(side: Side, across: number, down: number): Promise<{ x: number; y: number }> {
  await page().evaluate(() => {
    const viewer = document.querySelector('meshbound-app')?.shadowRoot?.querySelector('meshbound-viewer');
    viewer?.addEventListener('probe', (event) => Object.assign(window, { told: (event as CustomEvent).detail }));
  });
  const box = await boxOf(page().locator(`#${side}`));
  const at = { x: box.x + across * box.width, y: box.y + down * box.height };
  await page().mouse.move(at.x, at.y);
  await expect(card()).toBeVisible();
  await expect(card()).not.toContainText('…');
  return at;
}

async function boxOf(locator: Locator) {
  const box = await locator.boundingBox();
  if (!box) throw new Error('It is not shown.');
  return box;
}

async function middleOf(locator: Locator): Promise<{ x: number; y: number }> {
  const { x, y, width, height } = await boxOf(locator);
  return { x: x + width / 2, y: y + height / 2 };
}

function told(): Promise<Told> {
  return page().evaluate(() => (window as unknown as { told: Told }).told);
}

/** Position and values that the two surfaces have at the places of a probe, by their arrays. */
function valuesThere(probe: Probe): Promise<Record<Side, number[][]>> {
  return page().evaluate(({ original, reduced }) => {
    const viewer = document
      .querySelector('meshbound-app')
      ?.shadowRoot?.querySelector('meshbound-viewer') as MeshboundViewer;
    const mixed = ({ position, triangles, variables }: Mesh, { triangle, barycentric }: ProbedPlace) =>
      [{ components: 3, values: position }, ...variables].map(({ components, values }) =>
        Array.from({ length: components }, (_, component) =>
          barycentric.reduce(
            (sum, share, corner) => sum + share * values[components * triangles[3 * triangle + corner] + component],
            0,
          ),
        ),
      );
    return {
      original: mixed(viewer.session.state.surface?.mesh as Mesh, original as ProbedPlace),
      reduced: mixed(viewer.reduction?.mesh as Mesh, reduced as ProbedPlace),
    };
  }, probe);
}

for (const side of ['original', 'reduced'] as const) {
  test(`the pointer on the ${side} surface shows the place on both, with each variable’s values and error`, async () => {
    const at = await pointAt(side, 0.5, 0.5);
    const { probe, pinned } = await told();
    expect(pinned).toBe(false);
    expect(probe?.from).toBe(side);
    const there = await valuesThere(probe as Probe);
    for (const [index, { original, reduced, error, bound, ratio }] of (probe?.variables ?? []).entries()) {
      const [here, elsewhere] = [there.original[index], there.reduced[index]];
      expect(distance(original ?? [], here)).toBeLessThan(rounding);
      expect(distance(reduced ?? [], elsewhere)).toBeLessThan(rounding);
      expect(error).toBeCloseTo(distance(here, elsewhere), 9);
      expect(ratio).toBeCloseTo((error as number) / bound, 9);
      expect(ratio).toBeLessThanOrEqual(1 + rounding);
    }
    const rows = card().getByRole('row');
    expect(await rows.count()).toBe(1 + (probe?.variables.length ?? 0));
    await expect(rows.nth(3)).toContainText('pressure');
    // Under the pointer here, and at the same place under the same camera there, but for an error of at most 1 % of the size.
    const seen = await middleOf(marker(side));
    expect(Math.hypot(seen.x - at.x, seen.y - at.y)).toBeLessThan(1.5);
    const panes = [await boxOf(page().locator('#original')), await boxOf(page().locator('#reduced'))];
    const [one, other] = [await middleOf(marker('original')), await middleOf(marker('reduced'))];
    const apart = Math.hypot(other.x - panes[1].x - (one.x - panes[0].x), other.y - one.y);
    expect(apart).toBeLessThan(0.02 * panes[0].width);
  });
}

test('a click pins the place, which stays through other bounds, and Escape lets it go', async () => {
  const { x, y } = await pointAt('original', 0.45, 0.6);
  await page().mouse.click(x, y);
  await expect(card()).toContainText('Pinned');
  const before = (await told()).probe?.original;
  await page().mouse.move(x + 40, y - 40);
  await typePercent(page(), 'Bound of pressure', '5');
  await expect(card()).not.toContainText('…');
  expect((await told()).probe?.original).toEqual(before);
  await typePercent(page(), 'Bound of pressure', '3');
  // The view may be turned: that is no click.
  await page().mouse.move(x, y);
  await page().mouse.down();
  await page().mouse.move(x + 30, y + 10, { steps: 3 });
  await page().mouse.up();
  expect((await told()).probe?.original).toEqual(before);
  const moved = await middleOf(marker('original'));
  expect(Math.hypot(moved.x - x, moved.y - y)).toBeGreaterThan(5);
  await page().keyboard.press('Escape');
  await expect(card()).toHaveCount(0);
  await expect(marker('original')).toHaveCount(0);
  expect(await told()).toEqual({ probe: null, pinned: false });
});

test('from the keyboard, the middle of a pane is pinned and told, and let go', async () => {
  await page().locator('#reduced').press('Enter');
  await expect(card()).toContainText('Pinned');
  await expect(page().locator('meshbound-probe-layer').getByRole('status')).toHaveText(
    /^Pinned\. Largest error: .+\s% of its bound/,
  );
  const [pane, there] = [await middleOf(page().locator('#reduced')), await middleOf(marker('reduced'))];
  expect(Math.hypot(pane.x - there.x, pane.y - there.y)).toBeLessThan(1.5);
  await page().getByRole('button', { name: 'Unpin' }).press('Escape');
  await expect(card()).toHaveCount(0);
});

test('the worst place of each variable is one click away, in sight on both surfaces', async () => {
  const rows = page().locator('meshbound-bound-row');
  await pointAt('original', 0.5, 0.5);
  for (const [index, row] of (await rows.all()).entries()) {
    await row.locator('.error').click();
    const reported = await page().evaluate(
      (variable) =>
        document.querySelector('meshbound-app')?.shadowRoot?.querySelector('meshbound-viewer')?.report?.variables[
          variable
        ],
      index,
    );
    await expect.poll(async () => (await told()).probe?.variables[index].error).toBeCloseTo(reported?.error ?? NaN, 5);
    await expect(page().locator('.marker:not(.hidden)')).toHaveCount(2);
  }
  await expect(card()).toContainText('Pinned');
  await card().getByRole('button', { name: 'pressure' }).click();
  await expect(card().getByRole('row', { name: /^pressure/ })).toContainText(/9\d(\.\d)?\s%|100\s%/);
});

test('one over the other, the divider says which surface is pointed at; alone, one marker is seen', async () => {
  await view().selectOption('wipe');
  const divider = page().getByRole('slider', { name: 'How much of the stage shows the original' });
  for (const key of ['Home', ...Array(25).fill('ArrowRight')]) await divider.press(key);
  await pointAt('original', 0.42, 0.5);
  expect((await told()).probe?.from).toBe('original');
  await expect(marker('original')).not.toHaveClass(/hidden/);
  await expect(marker('reduced')).toHaveClass(/hidden/);
  await pointAt('original', 0.56, 0.5);
  await expect.poll(async () => (await told()).probe?.from).toBe('reduced');
  await expect(marker('original')).toHaveClass(/hidden/);
  await view().selectOption('reduced');
  await pointAt('reduced', 0.5, 0.5);
  await expect(page().locator('.marker')).toHaveCount(1);
  expect((await told()).probe?.original).not.toBeNull();
});

test('with propagated errors the limit of a reduced triangle is told, and no place on the original', async () => {
  await page()
    .getByText(/^Method/)
    .click();
  await page().getByLabel('Errors').selectOption('propagated');
  await settled(page());
  await expect(page().locator('meshbound-bound-row').first()).toContainText('≤');
  await pointAt('reduced', 0.5, 0.5);
  await expect(card()).toContainText('error\u00a0≤');
  expect((await told()).probe?.original).toBeNull();
  for (const { ratio } of (await told()).probe?.variables ?? []) expect(ratio).toBeLessThanOrEqual(1);
  await page().getByLabel('Errors').selectOption('tracked');
  await settled(page());
});

test('of levels of detail the one that is shown is probed, and none between two', async () => {
  await page().getByLabel('Levels of detail').selectOption('3');
  const slider = page().getByLabel('Position among levels');
  await expect(slider).toBeEnabled();
  await slider.fill('3');
  await expect(page().locator('#reduced .caption')).toContainText('Level 3');
  await pointAt('reduced', 0.5, 0.5);
  const { probe } = await told();
  const level = await page().evaluate(
    () =>
      document.querySelector('meshbound-app')?.shadowRoot?.querySelector('meshbound-viewer')?.shown?.result.report
        .variables,
  );
  expect(probe?.variables.map(({ bound }) => bound)).toEqual(level?.map(({ bound }) => bound));
  await page().mouse.move(2, 2);
  await slider.fill('2.5');
  await expect(page().locator('#reduced .caption')).toContainText('On the way');
  await page().locator('#reduced').hover();
  await expect(card()).toHaveCount(0);
  // The worst place is that of the nearer level, which is shown then.
  await page().locator('meshbound-bound-row').first().locator('.error').click();
  await expect(page().locator('#reduced .caption')).toContainText('Level 3');
  await expect(card()).toContainText('Pinned');
  await expect(page().locator('.marker:not(.hidden)')).toHaveCount(2);
  await expect
    .poll(async () => (await told()).probe?.variables[0].ratio)
    .toBeCloseTo(level?.[0].ratio ?? Number.NaN, 5);
  await page().getByLabel('Levels of detail').selectOption('0');
});

test('axe finds nothing wrong with a pinned place, light and dark', async ({ page: own }) => {
  await openPage(own);
  await own.locator('#original').press('Enter');
  await expect(own.getByRole('group', { name: 'Probe' })).toContainText('Pinned');
  for (const colorScheme of ['light', 'dark'] as const) {
    await own.emulateMedia({ colorScheme });
    const { violations } = await new AxeBuilder({ page: own }).analyze();
    expect(violations.map(({ id, nodes }) => [id, ...nodes.map(({ target }) => target)])).toEqual([]);
  }
});

for (const [width, height] of [
  [320, 640],
  [390, 844],
]) {
  test(`a finger probes by a tap at ${width} × ${height}, and both surfaces stay drawn`, async ({ browser }) => {
    const context = await browser.newContext({ viewport: { width, height }, hasTouch: true });
    const own = await context.newPage();
    await openPage(own);
    await own.locator('#original').scrollIntoViewIfNeeded();
    await expect.poll(async () => coverage(await pictureOf(own, 'original'))).toBeGreaterThan(0.05);
    const before = await pictureOf(own, 'original');
    await own.locator('#original').tap();
    const shown = own.getByRole('group', { name: 'Probe' });
    await expect(shown).toContainText('Pinned');
    await expect(shown).not.toContainText('…');
    await expect(own.locator('.marker')).toHaveCount(2);
    const [stage, over] = [await boxOf(own.locator('meshbound-stage')), await boxOf(shown)];
    expect(over.x).toBeGreaterThanOrEqual(stage.x);
    expect(over.x + over.width).toBeLessThanOrEqual(stage.x + stage.width);
    expect(over.y).toBeGreaterThanOrEqual(stage.y);
    expect(over.y + over.height).toBeLessThanOrEqual(stage.y + stage.height);
    expect(await shown.evaluate((element) => element.scrollWidth - element.clientWidth)).toBe(0);
    // The card lies over the other surface; of this one the marker hides little.
    expect(difference(before, await pictureOf(own, 'original'))).toBeLessThan(0.05);
    await shown.getByRole('button', { name: 'Unpin' }).tap();
    await expect(shown).toHaveCount(0);
    await context.close();
  });
}
