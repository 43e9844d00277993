import { readFile } from 'node:fs/promises';
import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';
import { readSurface } from '../../web/formats/read.ts';
import { look, openPage, sentence, sharePage } from './open-page.ts';
import { coverage, difference, hasBrokenBound, type Picture, pictureOf } from './picture.ts';

const page = sharePage();

async function makeLevels(shown: Page, count: string): Promise<void> {
  await shown.getByLabel('Levels of detail').selectOption(count);
  await expect(shown.getByLabel('Position among levels')).toBeEnabled();
}

/** Moves the slider, and waits until the picture rests. */
async function moveTo(shown: Page, position: number): Promise<Picture> {
  await shown.getByLabel('Position among levels').fill(String(position));
  return rested(shown);
}

async function rested(shown: Page): Promise<Picture> {
  let last = await pictureOf(shown, 'reduced');
  await expect
    .poll(async () => {
      const before = last;
      last = await pictureOf(shown, 'reduced');
      return difference(before, last);
    })
    .toBe(0);
  return last;
}

/**
 * Leaves out triangles that show their back, or no longer: of a closed surface only the front is seen, and through a hole in it
 * the background, as far as none of its back is drawn.
 */
async function leaveBacksOut(shown: Page, out: boolean): Promise<void> {
  await shown.locator('meshbound-viewer').evaluate((viewer, wanted) => viewer.toggleAttribute('cull', wanted), out);
}

/** Background pixels that the surface encloses: holes. */
function holes({ width, height, pixels }: Picture): number {
  const isBackground = (pixel: number) =>
    [0, 1, 2].every((part) => Math.abs(pixels[4 * pixel + part] - pixels[part]) <= 6);
  const open = [0];
  const outside = new Uint8Array(width * height);
  outside[0] = 1;
  for (let pixel = open.pop(); pixel !== undefined; pixel = open.pop()) {
    const [x, y] = [pixel % width, Math.floor(pixel / width)];
    for (const [nx, ny] of [
      [x - 1, y],
      [x + 1, y],
      [x, y - 1],
      [x, y + 1],
    ]) {
      const next = ny * width + nx;
      if (nx < 0 || ny < 0 || nx >= width || ny >= height || outside[next] || !isBackground(next)) continue;
      outside[next] = 1;
      open.push(next);
    }
  }
  return outside.filter((reached, pixel) => !reached && isBackground(pixel)).length;
}

test('a slider leads through all levels without a hole or a jump', async () => {
  await look(page());
  await makeLevels(page(), '3');
  const positions = Array.from({ length: 13 }, (_, i) => i / 4);
  const pictures: Picture[] = [];
  for (const position of positions) pictures.push(await moveTo(page(), position));
  await leaveBacksOut(page(), true);
  const fronts: Picture[] = [];
  for (const position of positions) fronts.push(await moveTo(page(), position));
  await leaveBacksOut(page(), false);
  for (const [i, front] of fronts.entries()) {
    expect(coverage(front)).toBeGreaterThan(0.05);
    expect(holes(front)).toBe(0);
    // Nor is much seen of the backs of folded pieces.
    expect(difference(front, pictures[i])).toBeLessThan(0.002);
  }
  expect(difference(pictures[0], await pictureOf(page(), 'original'))).toBeLessThan(0.002);
  expect(difference(pictures[0], pictures[12])).toBeGreaterThan(0.02);
});

/** Shows a position that the slider's steps leave out, and waits until the picture rests. */
async function showAt(shown: Page, position: number): Promise<Picture> {
  await shown.evaluate((where) => {
    const app = document.querySelector('meshbound-app') as unknown as {
      viewer: { levels: { setPosition(position: number): void } };
    };
    app.viewer.levels.setPosition(where);
  }, position);
  await expect(shown.locator('#reduced .caption')).toContainText(position % 1 === 0 ? 'Level' : 'On the way');
  return rested(shown);
}

/** This close to a level nothing has moved by a pixel. */
const hair = 1e-4;

// A few pixels differ where pieces that are smaller than these meet: at outlines, and more of them where edges are drawn.
for (const { name, show, edges, flat, few } of [
  { name: 'in values, shaded smooth', show: 'values', edges: false, flat: false, few: 0.001 },
  { name: 'in values, shaded flat', show: 'values', edges: false, flat: true, few: 0.001 },
  { name: 'in errors, with edges', show: 'error / bound', edges: true, flat: false, few: 0.005 },
]) {
  test(`the ends of a morph look like the levels themselves, ${name}`, async () => {
    await look(page(), { show, edges });
    await page().evaluate((wanted) => {
      const app = document.querySelector('meshbound-app') as unknown as { viewer: { flat: boolean } };
      app.viewer.flat = wanted;
    }, flat);
    await makeLevels(page(), '3');
    for (const level of [1, 2]) {
      const exact = await showAt(page(), level);
      expect(hasBrokenBound(exact)).toBe(false);
      for (const near of [level - hair, level + hair]) {
        expect(difference(exact, await showAt(page(), near))).toBeLessThan(few);
      }
    }
  });
}

test('a level is what the caption, the sentence and the file say', async () => {
  await look(page());
  await makeLevels(page(), '3');
  const texts: string[] = [];
  for (const level of [1, 2, 3]) {
    await page()
      .getByRole('button', { name: `Level ${level}`, exact: true })
      .click();
    const caption = page().locator('#reduced .caption');
    await expect(caption).toContainText(`Level ${level}`);
    const count = (await caption.locator('b').innerText()).trim();
    await expect(sentence(page())).toContainText(`${count} of`);
    await expect(sentence(page())).toContainText(`within ${2 ** (level - 1)} % in space`);
    texts.push(count);
  }
  expect(new Set(texts).size).toBe(3);
  await page().getByRole('button', { name: 'Original', exact: true }).click();
  await expect(page().locator('#reduced .caption')).toContainText('Original');
});

test('all levels are saved in one file, and only where there are some', async () => {
  await page().getByLabel('Levels of detail').selectOption('0');
  await page().getByRole('button', { name: 'Save…' }).click();
  await expect(page().getByRole('button', { name: 'GLB', exact: true })).toBeVisible();
  await expect(page().getByRole('button', { name: 'Levels (GLB)' })).toHaveCount(0);
  await page().keyboard.press('Escape');
  await makeLevels(page(), '3');
  await page().getByRole('button', { name: 'Level 3', exact: true }).click();
  const started = page().waitForEvent('download');
  await page().getByRole('button', { name: 'Save…' }).click();
  await page().getByRole('button', { name: 'Levels (GLB)' }).click();
  const download = await started;
  expect(download.suggestedFilename()).toBe('fireballs-levels.glb');
  const bytes = new Uint8Array(await readFile(await download.path()));
  const text = new TextDecoder('latin1').decode(bytes);
  expect(text).toContain('"MSFT_lod":{"ids":[1,2]}');
  // Whatever is shown, programs that do not know the extension read the finest.
  await page().getByRole('button', { name: 'Level 1', exact: true }).click();
  const finest = (await page().locator('#reduced .caption b').innerText()).replace(/\D/g, '');
  expect(`${(await readSurface('levels.glb', bytes)).mesh.triangles.length / 3}`).toBe(finest);
});

test('one draw call shows a morph, however many levels there are', async () => {
  await makeLevels(page(), '4');
  const calls = await page().evaluate(async () => {
    const counted = { calls: 0, vertices: 0 };
    const draw = WebGL2RenderingContext.prototype.drawArrays;
    WebGL2RenderingContext.prototype.drawArrays = function (mode, first, count) {
      counted.calls++;
      counted.vertices += count;
      draw.call(this, mode, first, count);
    };
    const app = document.querySelector('meshbound-app') as unknown as {
      viewer: { levels: { setPosition(position: number): void } };
    };
    app.viewer.levels.setPosition(2.5);
    await new Promise((resolve) => setTimeout(resolve, 1500));
    Object.assign(counted, { calls: 0, vertices: 0 });
    app.viewer.levels.setPosition(2.6);
    await new Promise((resolve) => setTimeout(resolve, 500));
    WebGL2RenderingContext.prototype.drawArrays = draw;
    return counted;
  });
  expect(calls.calls).toBe(1); // the original stays as it is
  expect(calls.vertices).toBeGreaterThan(3 * 1000);
});

test('the size on screen chooses the level, on a smooth way there and back', async () => {
  await look(page());
  await makeLevels(page(), '4');
  await page().getByRole('button', { name: 'Level 3', exact: true }).click();
  await page().getByLabel('Which level').selectOption('error ≤ 10 px');
  const slider = page().getByLabel('Position among levels');
  await expect(slider).toHaveValue('1'); // twice that error is too much from here
  const seen = new Set<number>();
  for (let press = 0; press < 30; press++) {
    await page().locator('#reduced').press('-');
    seen.add(Number(await slider.inputValue()));
  }
  await expect(slider).toHaveValue('4');
  expect([...seen].some((position) => position % 1 !== 0)).toBe(true);
  expect([...seen]).toEqual([...seen].toSorted((a, b) => a - b));
  await page().getByRole('button', { name: 'Fit' }).click();
  await expect(slider).toHaveValue('1');
  await slider.fill('2');
  await expect(page().getByLabel('Which level')).toHaveValue('');
  await expect(page().locator('#reduced .caption')).toContainText('Level 2');
});

test('without levels the result is back', async () => {
  await makeLevels(page(), '2');
  await page().getByLabel('Levels of detail').selectOption('0');
  await expect(page().locator('#reduced .caption')).toContainText('Reduced');
  await expect(page().getByLabel('Position among levels')).toHaveCount(0);
});

test('axe finds nothing wrong with them, light and dark', async ({ page: own }) => {
  await openPage(own);
  await makeLevels(own, '3');
  for (const colorScheme of ['light', 'dark'] as const) {
    await own.emulateMedia({ colorScheme });
    const { violations } = await new AxeBuilder({ page: own }).analyze();
    expect(violations.map(({ id, nodes }) => `${id} ${nodes.map(({ target }) => target)}`)).toEqual([]);
  }
});

test('they fit a narrow window', async () => {
  await makeLevels(page(), '3');
  await page().setViewportSize({ width: 320, height: 640 });
  expect(await page().evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
  await page().getByLabel('Position among levels').scrollIntoViewIfNeeded();
  await expect(page().getByLabel('Position among levels')).toBeInViewport({ ratio: 1 });
  await page().setViewportSize({ width: 1280, height: 800 });
});
