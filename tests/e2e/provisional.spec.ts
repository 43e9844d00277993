// While a slider moves a large surface is answered at once, and what is shown meanwhile says that it is provisional.
import { expect, type Page, test } from '@playwright/test';
import { chooseFile, counts, saved, sentence } from './open-page.ts';
import { slope } from './surfaces.ts';

type Viewer = HTMLElementTagNameMap['meshbound-viewer'];

const bound = (page: Page) => page.getByRole('slider', { name: 'Bound of position' });
const caption = (page: Page) => page.locator('#reduced .caption');

declare global {
  interface Window {
    /** Lets reductions from the original begin that wait for it, and all that come later; before, they are held back. */
    release: (() => void) | undefined;
    hold(): void;
  }
}

/** Runs in the page before anything else does. */
function watchReductions(): void {
  const { Worker } = window;
  let held: (() => void)[] = [];
  window.hold = () => {
    window.release = () => {
      for (const begin of held) begin();
      held = [];
      window.release = undefined;
    };
  };
  window.Worker = class extends Worker {
    override postMessage(message: unknown, options?: StructuredSerializeOptions | Transferable[]): void {
      const begin = () => super.postMessage(message, options as StructuredSerializeOptions);
      const { task } = message as { task?: { kind: string } };
      if (window.release && task?.kind === 'reduce') held.push(begin);
      else begin();
    }
  };
}

/** With a surface whose reduction takes so long that it is answered from a checkpoint meanwhile. */
async function openLarge(page: Page): Promise<void> {
  await page.addInitScript(watchReductions);
  await page.goto('./#src=samples/fireballs-fine.ply');
  await expect(caption(page)).toContainText(/Reduced [1-9]/);
  await page.evaluate(() => window.hold());
}

test('an answer from a checkpoint says what it is, and makes room for the exact one without a jump', async ({
  page,
}) => {
  await openLarge(page);
  const first = await counts(page);
  await page.evaluate(() => {
    const viewer = document.querySelector('meshbound-app')?.shadowRoot?.querySelector('meshbound-viewer');
    const told: boolean[] = [];
    viewer?.addEventListener('reduce', (event) => told.push((event as CustomEvent).detail.errorsAreUpperBounds));
    Object.assign(window, { told });
  });
  await bound(page).focus();
  await page.keyboard.press('ArrowRight');
  await expect(sentence(page)).toContainText(/Provisional: \d+ of/);
  await expect(sentence(page)).toContainText('proved');
  await expect(page.locator('.numbers')).toContainText('Exact answer…');
  await expect(caption(page)).toContainText('provisional');
  const room = () => page.locator('meshbound-stage').boundingBox();
  const before = await room();
  await page.evaluate(() => window.release?.());
  await expect(sentence(page)).not.toContainText('Provisional');
  await expect(page.locator('.numbers')).toContainText('removed');
  await expect(caption(page)).not.toContainText('provisional');
  expect(await room()).toEqual(before);
  expect((await counts(page)).after).not.toBe(first.after);
  expect(await page.evaluate(() => (window as unknown as { told: boolean[] }).told)).toEqual([false]);
});

test('errors that the original shows stay while the answer is provisional', async ({ page }) => {
  await openLarge(page);
  await page.getByLabel('Show').selectOption('error');
  const legend = page.locator('#original meshbound-legend');
  const reducedLegend = page.locator('#reduced meshbound-legend');
  await expect(reducedLegend).toContainText('largest error in each triangle');
  const size = await reducedLegend.boundingBox();
  await expect(legend).toContainText('true error at each vertex');
  await bound(page).focus();
  await page.keyboard.press('ArrowRight');
  await expect(caption(page)).toContainText('provisional');
  await expect(reducedLegend).toContainText('limit of the error');
  expect(await reducedLegend.boundingBox()).toEqual(size);
  await expect(legend).toContainText('true error at each vertex');
});

/** Collects from now on what a screen reader is told of the result and of the pinned place; empties say nothing. */
async function listenToStatus(page: Page): Promise<() => Promise<string[]>> {
  for (const part of ['meshbound-result-bar', 'meshbound-probe-layer']) {
    await page
      .locator(part)
      .getByRole('status')
      .first()
      .evaluate((status) => {
        const { told } = Object.assign(window, { told: (window as unknown as { told?: string[] }).told ?? [] });
        const listen = () => told.push(status.textContent?.trim() ?? '');
        new MutationObserver(listen).observe(status, { childList: true, characterData: true, subtree: true });
      });
  }
  return async () => (await page.evaluate(() => (window as unknown as { told: string[] }).told)).filter(Boolean);
}

test('provisional answers are to be read, but read out is the exact one alone', async ({ page }) => {
  await openLarge(page);
  await page.locator('#original').press('Enter');
  const pinned = page.locator('meshbound-probe-layer').getByRole('status');
  await expect(pinned).toContainText('Largest error');
  const told = await listenToStatus(page);
  await bound(page).focus();
  for (let moves = 0; moves < 3; moves++) await page.keyboard.press('ArrowRight');
  await expect(sentence(page)).toContainText('Provisional');
  await expect(caption(page)).toContainText('provisional');
  expect(await told()).toEqual([]);
  await page.evaluate(() => window.release?.());
  await expect(sentence(page)).not.toContainText('Provisional');
  await expect(pinned).toContainText('Largest error');
  const exact = [await sentence(page).innerText(), await pinned.innerText()];
  expect(await told()).toEqual(exact);
});

test('what is saved is the exact answer', async ({ page }) => {
  await openLarge(page);
  await bound(page).focus();
  await page.keyboard.press('ArrowRight');
  await expect(sentence(page)).toContainText('Provisional');
  const saving = saved(page, 'report');
  await expect(page.getByText('Saved as soon as the answer to what is asked for is there')).toBeVisible();
  await page.evaluate(() => window.release?.());
  const report = JSON.parse(new TextDecoder().decode((await saving).bytes));
  expect(report.triangles.after).toBe((await counts(page)).after);
});

test('a cancelled reduction leaves the last exact answer, and saves nothing', async ({ page }) => {
  await openLarge(page);
  const first = await counts(page);
  await bound(page).focus();
  await page.keyboard.press('ArrowRight');
  await expect(sentence(page)).toContainText('Provisional');
  let downloads = 0;
  page.on('download', () => downloads++);
  await page.getByRole('button', { name: 'Save…' }).click();
  await page.getByRole('button', { name: 'PLY', exact: true }).click();
  await expect(page.getByText('Saved as soon as the answer to what is asked for is there')).toBeVisible();
  await page.getByRole('button', { name: 'Cancel', exact: true }).click();
  await expect(caption(page)).not.toContainText('provisional');
  await expect(sentence(page)).toContainText('which was cancelled, but with the bounds before: ');
  const shown = (await sentence(page).innerText()).replace(/[\u202f\u00a0]/g, '');
  expect(shown).toContain(`: ${first.after} of ${first.before} triangles.`);
  expect(downloads).toBe(0);
});

test('who waits for what is saved is told where the viewer is removed, but not where it is moved', async ({ page }) => {
  await openLarge(page);
  await bound(page).focus();
  await page.keyboard.press('ArrowRight');
  await expect(sentence(page)).toContainText('Provisional');
  const ends = await page.evaluate(async () => {
    const viewer = document.querySelector('meshbound-app')?.shadowRoot?.querySelector('meshbound-viewer');
    if (!viewer) return [];
    let saving = '';
    const wait = viewer.save('ply').then(
      () => (saving = 'saved'),
      (error) => (saving = `${error.name}: ${error.message}`),
    );
    viewer.parentNode?.append(viewer);
    await viewer.updateComplete;
    const moved = saving;
    viewer.remove();
    await wait;
    return [moved, saving];
  });
  expect(ends).toEqual(['', 'AbortError: The reduction was aborted.']);
});

test('that a locked box meets nothing is said of the original, whatever a provisional surface meets', async ({
  page,
}) => {
  await openLarge(page);
  await page.evaluate(() => window.release?.());
  await chooseFile(page, 'slope.ply', slope(201));
  await expect(page.locator('meshbound-bounds-panel')).not.toContainText('density');
  const viewer = page.locator('meshbound-viewer');
  // Not at the sheet, but between the ends of the large triangles that are left of it.
  await viewer.evaluate((element: Viewer) => Object.assign(element, { lockBox: '0.4,0.4,0.7,0.5,0.5,0.8' }));
  const unmet = page.getByText('No triangle meets the box');
  await expect(unmet).toHaveCount(1);
  await page.evaluate(() => window.hold());
  await bound(page).focus();
  await page.keyboard.press('ArrowRight');
  await expect(caption(page)).toContainText('provisional');
  const met = await viewer.evaluate(
    ({ session }: Viewer) => session.state.provisional?.result.report.unusedLockedBoxes,
  );
  expect(met).toEqual([]);
  await expect(unmet).toHaveCount(1);
});

test('only the side that changes is drawn, and the other one stays as it is', async ({ page }) => {
  await page.addInitScript(() => {
    const drawn: number[] = [];
    Object.assign(window, { drawn });
    const { drawArrays } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.drawArrays = function (mode: number, first: number, count: number) {
      drawn.push(count / 3);
      drawArrays.call(this, mode, first, count);
    };
  });
  await openLarge(page);
  const drawn = () => page.evaluate(() => (window as unknown as { drawn: number[] }).drawn.splice(0));
  await expect.poll(drawn).toEqual([]); // all at rest
  const picture = await page.locator('#original').screenshot();
  await bound(page).focus();
  await page.keyboard.press('ArrowRight');
  await expect(caption(page)).toContainText('provisional');
  await page.evaluate(() => window.release?.());
  await expect(page.locator('.numbers')).toContainText('removed');
  await expect(caption(page)).not.toContainText('provisional');
  const { after, before } = await counts(page);
  const all: number[] = [];
  await expect.poll(async () => all.push(...(await drawn())) && all).toContain(after);
  expect(all).not.toContain(before);
  expect((await page.locator('#original').screenshot()).equals(picture)).toBe(true);
});
