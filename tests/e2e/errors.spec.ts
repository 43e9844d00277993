import { expect, type Page, test } from '@playwright/test';
import { chooseFile, counts, look, openPage, sentence, settled, sharePage, typePercent } from './open-page.ts';
import { coverage, hasBrokenBound, pictureOf, placesIn, type ShownPlace, shareFromMap } from './picture.ts';
import { hillAndHollow } from './surfaces.ts';

const sides = ['original', 'reduced'] as const;
const page = sharePage();

async function drawn(shown: Page): Promise<void> {
  for (const side of sides) await expect.poll(async () => coverage(await pictureOf(shown, side))).toBeGreaterThan(0.05);
}

function details(shown: Page) {
  return shown.locator('meshbound-legend .detail');
}

/** How finely a place can be told by its colour. */
const colourStep = 0.01;

const mean = (shown: ShownPlace[]) => shown.reduce((sum, { place }) => sum + place, 0) / shown.length;
const largest = (shown: ShownPlace[]) => Math.max(...shown.map(({ place }) => place));
const smallest = (shown: ShownPlace[]) => Math.min(...shown.map(({ place }) => place));
const leftOf = (shown: ShownPlace[]) => shown.filter(({ x }) => x < 0.5);
const rightOf = (shown: ShownPlace[]) => shown.filter(({ x }) => x > 0.5);

/** Waits until both sides show colours of `map`, and tells what they stand for. */
async function shownIn(shown: Page, map: 'share' | 'RdBu'): Promise<{ original: ShownPlace[]; reduced: ShownPlace[] }> {
  const places = async (side: (typeof sides)[number]) => {
    let picture = await pictureOf(shown, side);
    const share = async () => {
      picture = await pictureOf(shown, side);
      return shareFromMap(picture, map);
    };
    // Where two flat triangles meet, smoothing mixes their colours.
    if (shareFromMap(picture, map) <= 0.9) await expect.poll(share).toBeGreaterThan(0.9);
    expect(hasBrokenBound(picture)).toBe(false);
    return placesIn(picture, map);
  };
  return { original: await places('original'), reduced: await places('reduced') };
}

test('error / bound of every variable, on both sides, never above 1', async () => {
  await look(page(), { show: 'error / bound' });
  await drawn(page());
  const names = await page().getByLabel('Colour').locator('option').allInnerTexts();
  expect(names).toEqual(['position', 'density', 'pressure', 'vx', 'vy', 'vz', 'energy', 'temperature']);
  for (const name of names) {
    await page().getByLabel('Colour').selectOption({ label: name });
    await expect(page().locator('meshbound-legend .title')).toHaveText(Array(2).fill(`error / bound: ${name}`));
    await expect(details(page())).toHaveText(['true error at each vertex', 'largest error in each triangle']);
    for (const side of sides) {
      const ticks = page().locator(`#${side} meshbound-legend .ticks span`);
      await expect(ticks).toHaveText(['0', '0.2', '0.4', '0.6', '0.8', '1']);
    }
    const { original, reduced } = await shownIn(page(), 'share');
    // The largest error in a triangle is at least that of any vertex in it.
    expect(mean(reduced)).toBeGreaterThan(mean(original) - colourStep);
    if (name !== 'density') expect(largest(reduced)).toBeGreaterThan(0.7);
  }
});

test('signed errors stand around zero, from −bound to +bound, with the same numbers on both sides', async () => {
  await look(page(), { show: 'signed error', colour: 'pressure' });
  await expect(page().locator('meshbound-legend .title')).toHaveText(Array(2).fill('signed error: pressure [MPa]'));
  const [original, reduced] = await page().locator('meshbound-legend .ticks').allInnerTexts();
  expect(original).toMatch(/−\d.*0.*\d/s);
  expect(reduced).toBe(original);
  const zeros = page().locator('meshbound-legend .ticks span', { hasText: /^0$/ });
  for (const zero of await zeros.all()) await expect(zero).toHaveAttribute('style', /left: 50%/);
  const places = await shownIn(page(), 'RdBu');
  for (const side of sides) {
    expect(largest(places[side])).toBeGreaterThan(0.7);
    expect(smallest(places[side])).toBeLessThan(0.3);
  }
});

test('errors have maps of their own', async () => {
  await look(page(), { show: 'error / bound' });
  await expect(page().getByLabel('Map')).toBeDisabled();
  await expect(page().getByLabel('Map')).toHaveValue('YlOrBr');
  await look(page(), { show: 'values', map: 'cividis' });
  await expect(page().getByLabel('Map')).toHaveValue('cividis');
  for (const side of sides) {
    await expect.poll(async () => shareFromMap(await pictureOf(page(), side), 'cividis')).toBeGreaterThan(0.99);
  }
});

test('a variable without a bound has no error / bound, but a signed error', async () => {
  await look(page(), { show: 'error / bound', colour: 'vz' });
  await page().getByRole('checkbox', { name: 'vz bounded' }).uncheck();
  await expect(sentence(page())).toContainText('nothing guaranteed: vz');
  await expect(page().locator('meshbound-legend .title')).toHaveText(
    Array(2).fill('error / bound: vz (free: no bound)'),
  );
  await expect(page().locator('meshbound-legend .ends')).toHaveText([/no bound/, /no bound/]);
  await expect(page().getByLabel('Colour').locator('option', { hasText: 'vz' })).toBeDisabled();
  await page().getByLabel('Show').selectOption({ label: 'signed error' });
  await expect(page().locator('meshbound-legend .ends').first()).toHaveText(/−largest\s*\+largest/);
  await shownIn(page(), 'RdBu');
  await page().getByRole('checkbox', { name: 'vz bounded' }).check();
  await expect(sentence(page())).not.toContainText('nothing guaranteed');
  await settled(page());
});

test('propagated errors: more triangles, errors as limits, and the original keeps its values', async () => {
  const tracked = await counts(page());
  await expect(sentence(page())).not.toContainText('at most');
  await page()
    .getByText(/^Method/)
    .click();
  await page().getByLabel('Errors').selectOption('propagated');
  await expect(sentence(page())).toContainText(/proved; most used: .*, at most .*% of its bound/);
  const introduced = await counts(page());
  expect(introduced.after).toBeGreaterThan(tracked.after);
  await expect(page().locator('meshbound-bound-row .error').first()).toContainText('≤');

  await look(page(), { show: 'error / bound' });
  await expect(details(page())).toHaveText([
    'values: errors at its vertices are known only when tracked',
    'limit of the error in each triangle',
  ]);
  await expect.poll(async () => shareFromMap(await pictureOf(page(), 'original'), 'viridis')).toBeGreaterThan(0.99);
  await expect.poll(async () => shareFromMap(await pictureOf(page(), 'reduced'), 'share')).toBeGreaterThan(0.9);

  await page().getByLabel('Keeps small').selectOption({ label: 'maximum error' });
  await expect.poll(async () => (await counts(page())).after).not.toBe(introduced.after);
  await page().getByLabel('Errors').selectOption({ label: 'tracked' });
  await expect.poll(() => counts(page())).toEqual(tracked);
  await expect(page().getByLabel('Keeps small')).toHaveCount(0);
  await page()
    .getByText(/^Method/)
    .click();
});

test('shows errors where they are, with their signs', async () => {
  await chooseFile(page(), 'hill.ply', hillAndHollow(41));
  await expect(page().getByTitle('heat', { exact: true })).toBeVisible();
  // So loose that only the flat outline is left: every value above or below zero is an error.
  await typePercent(page(), 'Largest bound', '60');
  await expect.poll(async () => (await counts(page())).after).toBe(2);
  await look(page(), { colour: 'heat', show: 'signed error' });
  await drawn(page());
  const { original, reduced } = await shownIn(page(), 'RdBu');
  // 1 of a bound of 1.2.
  expect(largest(leftOf(original))).toBeGreaterThan(0.85);
  expect(smallest(leftOf(original))).toBeGreaterThan(0.45);
  expect(smallest(rightOf(original))).toBeLessThan(0.15);
  expect(largest(rightOf(original))).toBeLessThan(0.55);
  const full = reduced.filter(({ place }) => Math.abs(place - 0.5) > 0.35);
  expect(full.length / reduced.length).toBeGreaterThan(0.95);

  // The reduced surface lies inside under the hill and outside over the hollow.
  await page().getByLabel('Colour').selectOption({ label: 'position' });
  await expect(details(page()).first()).toContainText('+ where the reduced surface is outside');
  const position = (await shownIn(page(), 'RdBu')).original;
  expect(smallest(leftOf(position))).toBeLessThan(0.45);
  expect(largest(rightOf(position))).toBeGreaterThan(0.55);

  await look(page(), { colour: 'heat', show: 'error / bound' });
  const shares = (await shownIn(page(), 'share')).original;
  for (const half of [leftOf(shares), rightOf(shares)]) {
    expect(largest(half)).toBeGreaterThan(0.7);
    expect(smallest(half)).toBeLessThan(0.1);
  }
});

test('errors of a vector have no sign', async () => {
  await chooseFile(page(), 'hill.ply', hillAndHollow(21));
  await expect.poll(async () => (await counts(page())).before).toBe(800);
  await settled(page());
  await look(page(), { colour: 'heat', show: 'signed error' });
  await page().getByLabel('Colour').selectOption({ label: 'wind' });
  await expect(page().getByLabel('Show')).toHaveValue('error');
  await expect(page().getByLabel('Show').locator('option', { hasText: 'signed' })).toBeDisabled();
  await expect(page().locator('meshbound-legend .title')).toHaveText(Array(2).fill('error / bound: wind'));
  await shownIn(page(), 'share');
});

test('shows how the errors of each variable are spread over the area, up to the bound and no further', async () => {
  await openPage(page());
  await page().getByText('Errors by area').click();
  const drawing = page().getByRole('img', { name: /^pressure: half of the area/ });
  await expect(drawing).toBeVisible();
  const bars = await drawing
    .locator('rect')
    .evaluateAll((each) => each.map((bar) => Number(bar.getAttribute('height'))));
  // Counted here anew: of each corner of the original a third of its triangle.
  const shares = await page().evaluate((parts) => {
    const viewer = document.querySelector('meshbound-app')?.shadowRoot?.querySelector('meshbound-viewer');
    const mesh = viewer?.session.state.surface?.mesh;
    const index = viewer?.report?.variables.findIndex(({ name }) => name === 'pressure') ?? -1;
    const bound = viewer?.report?.variables[index].bound ?? Number.NaN;
    const counted: number[] = Array(parts).fill(0);
    if (!mesh) return counted;
    for (let first = 0; first < mesh.triangles.length; first += 3) {
      const corners = [...mesh.triangles.subarray(first, first + 3)];
      const [a, b, c] = corners.map((vertex) => [...mesh.position.subarray(3 * vertex, 3 * vertex + 3)]);
      const [u, v] = [b, c].map((to) => to.map((coordinate, axis) => coordinate - a[axis]));
      const dot = (one: number[], other: number[]) => one.reduce((sum, each, axis) => sum + each * other[axis], 0);
      const area = Math.sqrt(Math.max(0, dot(u, u) * dot(v, v) - dot(u, v) ** 2)) / 2;
      for (const vertex of corners) {
        const error = viewer?.reduction?.vertexErrors?.[index].error[vertex] ?? Number.NaN;
        counted[Math.min(parts - 1, Math.floor((parts * error) / bound))] += area;
      }
    }
    return counted;
  }, bars.length);
  expect(bars).toHaveLength(20);
  const [highest, most] = [Math.max(...bars), Math.max(...shares)];
  bars.forEach((bar, index) => {
    expect(bar / highest).toBeCloseTo(shares[index] / most, 3);
  });
  const { largest, width } = await drawing.evaluate((picture: Element) => ({
    largest: Number(picture.querySelector('.largest')?.getAttribute('x1')),
    width: (picture as SVGSVGElement).viewBox.baseVal.width,
  }));
  expect(largest / width).toBeGreaterThan(0.5);
  expect(largest / width).toBeLessThanOrEqual(1);
  const { cells, foldedCells } = await page().evaluate(() => {
    const app = document.querySelector('meshbound-app')?.shadowRoot;
    return app?.querySelector('meshbound-viewer')?.report ?? { cells: 0, foldedCells: 0 };
  });
  expect(cells).toBeGreaterThan(0);
  const digits = (await page().locator('.folds').innerText()).replace(/\(.*\)|[^\d ]|(?<=\d)[\u202f\u00a0](?=\d)/g, '');
  expect(digits.split(/ +/).filter(Boolean).map(Number)).toEqual([cells, foldedCells]);

  await page().getByRole('checkbox', { name: 'pressure bounded' }).uncheck();
  await expect(page().locator('meshbound-error-spread')).toContainText(/pressure\s*free/);
  await page().getByRole('checkbox', { name: 'pressure bounded' }).check();
  await expect(drawing).toBeVisible();
});
