import AxeBuilder from '@axe-core/playwright';
import { expect, type Locator, type Page, test } from '@playwright/test';
import type { Mesh } from '../../wasm/types.ts';
import type { MeshboundViewer } from '../../web/element/meshbound-viewer.ts';
import { readSurface } from '../../web/formats/read.ts';
import { humpAndSpike, oneTurned, patches, strips, vtp } from './kept-surfaces.ts';
import { chooseFile, counts, look, openPage, saved, sentence, settled, sharePage } from './open-page.ts';
import { difference, hasBrokenBound, pictureOf } from './picture.ts';

const page = sharePage();
const original = patches();

/** Of what is stored in single precision. */
const singlePrecision = 1e-6;

const group = (title: string) => page().locator('details', { has: page().locator('summary', { hasText: title }) });
const tick = (label: string) => page().getByLabel(label, { exact: true });

async function openMesh(name: string, mesh: Mesh): Promise<void> {
  await chooseFile(page(), name, await vtp(mesh));
  await expect.poll(async () => (await counts(page())).before).toBe(mesh.triangles.length / 3);
  await settled(page());
  for (const dismiss of await page().getByRole('button', { name: 'Dismiss' }).all()) await dismiss.click();
}

async function open(title: string): Promise<Locator> {
  const details = group(title);
  if ((await details.getAttribute('open')) === null) await details.locator('summary').click();
  return details;
}

async function type(label: string, value: number | string): Promise<void> {
  const field = page().getByLabel(label, { exact: true });
  await field.fill(String(value));
  await field.press('Enter');
}

/** Waits until what is asked for is what was reduced. */
async function reducedAsAsked(): Promise<void> {
  const isReduced = () =>
    page().evaluate(async () => {
      const app = document.querySelector('meshbound-app')?.shadowRoot;
      const viewer = app?.querySelector<MeshboundViewer>('meshbound-viewer');
      await viewer?.updateComplete;
      const { progress, reduced, keeping, method } = viewer?.session.state ?? {};
      return progress === null && reduced?.keeping === keeping && reduced?.method === method;
    });
  await expect.poll(isReduced).toBe(true);
  await settled(page());
}

async function savedMesh(): Promise<{ mesh: Mesh; regions?: ReadonlyMap<string, Int32Array> }> {
  await reducedAsAsked();
  const { name, bytes } = await saved(page(), 'vtp');
  return readSurface(name, bytes);
}

const placesOf = ({ position }: Mesh) =>
  Array.from({ length: position.length / 3 }, (_, vertex) => [...position.subarray(3 * vertex, 3 * vertex + 3)]);

/** The places of the corners of each triangle, beginning with the least, so that equal triangles have equal texts. */
function triangleTexts(mesh: Mesh): string[] {
  const places = placesOf(mesh).map(String);
  return Array.from({ length: mesh.triangles.length / 3 }, (_, triangle) => {
    const corners = [...mesh.triangles.subarray(3 * triangle, 3 * triangle + 3)].map((vertex) => places[vertex]);
    const first = corners.indexOf([...corners].sort()[0]);
    return [...corners.slice(first), ...corners.slice(0, first)].join(' ');
  });
}

/** How far the map of the reduction moves each vertex of the original: found from the map, whatever errors it states. */
function movesOf(shown: Page): Promise<number[]> {
  return shown.evaluate(() => {
    const app = document.querySelector('meshbound-app')?.shadowRoot;
    const viewer = app?.querySelector<MeshboundViewer>('meshbound-viewer');
    const { mesh, map } = viewer?.reduction ?? {};
    const before = viewer?.session.state.surface?.mesh.position;
    if (!mesh || !map || !before) throw new Error('Nothing was reduced.');
    return Array.from(map.triangle, (triangle, vertex) => {
      const away = [0, 1, 2].map((axis) => {
        let place = 0;
        for (let i = 0; i < 3; i++) {
          place += map.barycentric[3 * vertex + i] * mesh.position[3 * mesh.triangles[3 * triangle + i] + axis];
        }
        return place - before[3 * vertex + axis];
      });
      return Math.hypot(...away);
    });
  });
}

test.beforeEach(async () => {
  await page().keyboard.press('Escape');
  await look(page(), { colour: (await page().getByLabel('Colour').locator('option').allInnerTexts())[0] });
  for (const label of [
    'Let no part pierce another',
    'Limit space to feature size',
    'Drop parts smaller than the bound',
  ]) {
    await open('Method');
    await tick(label).uncheck();
  }
  // A file that is opened takes nothing over of what was kept of the one before.
  await openMesh('patches.vtp', original);
  for (const [title, summary] of [
    ['Locks and regions', 'none'],
    ['Finer bounds', 'the same everywhere'],
  ]) {
    await expect(group(title).locator('summary')).toContainText(summary);
    await open(title);
  }
});

test('what meets a box stays as it is, and the box is drawn on the original', async () => {
  const free = (await counts(page())).after;
  const without = [await pictureOf(page(), 'original'), await pictureOf(page(), 'reduced')];
  await tick('Lock what meets a box').check();
  await expect.poll(async () => (await counts(page())).after).toBeGreaterThan(free);
  const box = [
    [0.2, 0.3, -1],
    [0.45, 0.5, 1],
  ];
  for (const [end, places] of [
    ['to', box[1]],
    ['from', box[0]],
  ] as const) {
    for (const [axis, place] of places.entries()) await type(`Locked ${end} ${'xyz'[axis]}`, place);
  }
  const { mesh } = await savedMesh();
  const meets = (triangle: number) =>
    box[0].every((from, axis) => {
      const along = [0, 1, 2].map((i) => original.position[3 * original.triangles[3 * triangle + i] + axis]);
      return Math.max(...along) >= from && Math.min(...along) <= box[1][axis];
    });
  const locked = triangleTexts(original).filter((_, triangle) => meets(triangle));
  expect(locked.length).toBeGreaterThan(150);
  const kept = new Set(triangleTexts(mesh));
  expect(locked.filter((triangle) => !kept.has(triangle))).toEqual([]);
  expect(kept.size).toBeLessThan(locked.length + (original.triangles.length / 3 - locked.length) / 2);
  await expect(group('Locks and regions').locator('summary')).toContainText('a box');
  await expect.poll(async () => difference(without[0], await pictureOf(page(), 'original'))).toBeGreaterThan(0.001);

  // A box beside the surface is said to lock nothing.
  const unmet = page().getByText('No triangle meets the box');
  await expect(unmet).toHaveCount(0);
  await type('Locked from z', 5);
  await expect(unmet).toBeVisible();
  await expect.poll(async () => (await counts(page())).after).toBe(free);
  await type('Locked from z', -1);
  await type('Locked to z', 1);
  await expect(unmet).toHaveCount(0);

  // What is no number is refused, and the box stays.
  await type('Locked from x', '');
  await expect(page().getByLabel('Locked from x')).toHaveAttribute('aria-invalid', 'true');
  await expect(group('Locks and regions').getByRole('alert')).toHaveText('A number is needed.');
  expect((await savedMesh()).mesh.triangles).toHaveLength(mesh.triangles.length);
  await tick('Lock what meets a box').uncheck();
  await expect.poll(async () => (await counts(page())).after).toBe(free);
  await expect.poll(async () => difference(without[0], await pictureOf(page(), 'original'))).toBe(0);
});

test('by keys alone, a box goes to the place that is pinned', async () => {
  const surface = page().locator('#original');
  await surface.focus();
  await surface.press('Enter');
  await expect(page().getByRole('group', { name: 'Probe' })).toContainText('Pinned');
  await tick('Lock what meets a box').focus();
  await page().keyboard.press('Space');
  const place = await page().evaluate(() => {
    const app = document.querySelector('meshbound-app')?.shadowRoot;
    return app?.querySelector<MeshboundViewer>('meshbound-viewer')?.probe?.original?.position ?? [];
  });
  for (const [axis, at] of place.entries()) {
    expect(Number(await page().getByLabel(`Locked from ${'xyz'[axis]}`).inputValue())).toBeLessThan(at);
    expect(Number(await page().getByLabel(`Locked to ${'xyz'[axis]}`).inputValue())).toBeGreaterThan(at);
  }
  const from = page().getByLabel('Locked from x');
  const before = Number(await from.inputValue());
  await from.focus();
  await page().keyboard.press('ArrowUp');
  await expect.poll(async () => Number(await from.inputValue())).toBeGreaterThan(before);
});

test('points that are locked stay, and what cannot be one is said', async () => {
  const { after } = await counts(page());
  const keptOf = async () => {
    const kept = new Set(placesOf((await savedMesh()).mesh).map(String));
    return placesOf(original).map((place) => kept.has(String(place)));
  };
  const free = await keptOf();
  const first = free.findIndex((_, vertex) => vertex > 500 && ![0, 1, 2].some((next) => free[vertex + next]));
  const alone = free.indexOf(false);
  const locked = [alone, first, first + 1, first + 2];
  expect(locked.map((vertex) => free[vertex])).toEqual([false, false, false, false]);
  const field = page().getByLabel('Points', { exact: true });
  const summary = group('Locks and regions').locator('summary');
  await type('Points', `${alone}, ${first}-${first + 2}`);
  await expect(summary).toContainText('points');
  await expect(field).toHaveValue(`${alone},${first}-${first + 2}`);
  const kept = await keptOf();
  expect(locked.map((vertex) => kept[vertex])).toEqual([true, true, true, true]);
  expect(kept.filter(Boolean).length).toBeLessThan(kept.length / 2);
  const report = JSON.parse(new TextDecoder().decode((await saved(page(), 'report')).bytes));
  expect(report.options.lockPoints).toEqual([`${alone},${first}-${first + 2}`]);

  const means = await group('Locks and regions').locator('#points-mean').innerText();
  for (const [text, says] of [
    ['3,x', '“x” is no point and no range of points.'],
    ['0-1685', 'There is no point 1685 to lock: the surface has 1685, counted from 0.'],
  ]) {
    await type('Points', text);
    await expect(group('Locks and regions').getByRole('alert')).toHaveText(says);
    await expect(field).toHaveAttribute('aria-invalid', 'true');
    await expect(field).toHaveAccessibleDescription(`${says} ${means}`);
    await expect(field).toHaveValue(text);
    expect(await keptOf()).toEqual(kept);
    await field.press('Escape');
    await expect(group('Locks and regions').getByRole('alert')).toHaveCount(0);
    await expect(field).toHaveAttribute('aria-invalid', 'false');
    await expect(field).toHaveAccessibleDescription(means);
    await expect(field).toHaveValue(`${alone},${first}-${first + 2}`);
  }
  // Also what was typed and not yet entered.
  await field.fill('7');
  await field.press('Escape');
  await expect(field).toHaveValue(`${alone},${first}-${first + 2}`);
  await type('Points', '');
  await expect(group('Locks and regions').getByRole('alert')).toHaveCount(0);
  await expect(summary).toContainText('none');
  await expect.poll(async () => (await counts(page())).after).toBe(after);
});

test('the point nearest to the pinned place is added to those that are locked', async () => {
  const add = page().getByRole('button', { name: 'Add the pinned point' });
  await expect(add).toBeDisabled();
  await type('Points', '3');
  const surface = page().locator('#original');
  await surface.focus();
  await surface.press('Enter');
  await add.click();
  const position = await page().evaluate(() => {
    const app = document.querySelector('meshbound-app')?.shadowRoot;
    return app?.querySelector<MeshboundViewer>('meshbound-viewer')?.probe?.original?.position ?? [];
  });
  const awayFrom = (place: number[]) => Math.hypot(...place.map((at, axis) => at - position[axis]));
  const away = placesOf(original).map(awayFrom);
  const nearest = away.indexOf(Math.min(...away));
  await expect(page().getByLabel('Points', { exact: true })).toHaveValue(`3,${nearest}`);
  await add.click();
  await expect(page().getByLabel('Points', { exact: true })).toHaveValue(`3,${nearest}`);
  const places = placesOf((await savedMesh()).mesh).map(String);
  expect(places).toContain(String(placesOf(original)[nearest]));
  await page().keyboard.press('Escape');
});

test('regions keep their borders and labels, and those that are locked stay', async () => {
  const [free, without] = [(await counts(page())).after, await pictureOf(page(), 'original')];
  await page().getByLabel('Regions from').selectOption('material');
  await expect.poll(async () => (await counts(page())).after).toBeGreaterThan(free);
  await expect(group('Locks and regions').locator('summary')).toContainText('borders of material');
  await expect.poll(async () => difference(without, await pictureOf(page(), 'original'))).toBeGreaterThan(0.001);
  const bound = 0.01 * Math.hypot(1, 1, 0.7);
  for (const lockFive of [false, true]) {
    if (lockFive) await page().getByRole('group', { name: 'Locked regions' }).getByLabel('5').check();
    const { mesh, regions } = await savedMesh();
    const labels = [...(regions?.get('material') ?? [])];
    expect(new Set(labels)).toEqual(new Set(strips.keys()));
    for (const [triangle, label] of labels.entries()) {
      const across = [0, 1, 2].map((i) => mesh.position[3 * mesh.triangles[3 * triangle + i]]);
      const [from, to] = strips.get(label) ?? [];
      expect(Math.min(...across)).toBeGreaterThanOrEqual(from - bound);
      expect(Math.max(...across)).toBeLessThanOrEqual(to + bound);
    }
    const inFive = (all: Mesh, of: ArrayLike<number>) => triangleTexts(all).filter((_, triangle) => of[triangle] === 5);
    const kept = new Set(inFive(mesh, labels));
    const before = inFive(original, original.regions ?? []);
    if (lockFive) expect(before.filter((triangle) => !kept.has(triangle))).toEqual([]);
    else expect(kept.size).toBeLessThan(before.length / 2);
  }
  await expect(group('Locks and regions').locator('summary')).toContainText('1 region of material');
  await open('Report');
  await expect(group('Report')).toContainText('3 kept');
  const { name, bytes } = await saved(page(), 'map');
  expect((await readSurface(name, bytes)).regions?.get('material')).toEqual(original.regions);
});

test('materials of an OBJ file are regions by their names', async () => {
  const { position, triangles, regions } = original;
  const rows = Array.from({ length: triangles.length / 3 }, (_, triangle) => {
    const corners = [...triangles.subarray(3 * triangle, 3 * triangle + 3)].map((corner) => corner + 1);
    return `usemtl part ${regions?.[triangle]}\nf ${corners.join(' ')}`;
  });
  const text = [...placesOf({ position } as Mesh).map((place) => `v ${place.join(' ')}`), ...rows, ''].join('\n');
  await chooseFile(page(), 'materials.obj', Buffer.from(text));
  await expect(page().getByText('can part the surface into regions')).toBeVisible();
  await page().getByLabel('Regions from').selectOption('material');
  await expect(page().getByText('can part the surface into regions')).toHaveCount(0);
  await page().getByRole('group', { name: 'Locked regions' }).getByLabel('part 5').check();
  await reducedAsAsked();
  const { bytes } = await saved(page(), 'obj');
  const back = await readSurface('a.obj', bytes);
  const inFive = [...(back.regionNames?.get('material') ?? [])].find(([, name]) => name === 'part 5')?.[0];
  const kept = back.regions?.get('material')?.filter((label) => label === inFive).length;
  expect(kept).toBe(regions?.filter((label) => label === 5).length);
  expect(back.mesh.triangles.length).toBeLessThan(triangles.length / 2);
});

test('a variable multiplies the bounds at every point, and the colours count against what it makes of them', async () => {
  await page().getByLabel('Multiply by').selectOption('sharpness');
  await expect(sentence(page())).toContainText('times the multiplier there: proved');
  await reducedAsAsked();
  await expect(group('Finer bounds').locator('summary')).toContainText('× sharpness');
  const bound = await page().evaluate(() => {
    const app = document.querySelector('meshbound-app')?.shadowRoot;
    return app?.querySelector<MeshboundViewer>('meshbound-viewer')?.report?.variables[0].bound ?? 0;
  });
  const sharpness = original.variables[1].values;
  const shares = (await movesOf(page())).map((move, vertex) => move / bound / sharpness[vertex]);
  expect(Math.max(...shares)).toBeLessThanOrEqual(1 + singlePrecision);
  // The errors are larger than the bounds themselves where these may be, or else nothing would be multiplied.
  expect(Math.max(...shares.map((share, vertex) => share * sharpness[vertex]))).toBeGreaterThan(1);
  await look(page(), { colour: 'position', show: 'error / bound' });
  await expect(page().locator('meshbound-legend').first()).toContainText('of the bound as it is multiplied there');
  for (const side of ['original', 'reduced'] as const)
    expect(hasBrokenBound(await pictureOf(page(), side))).toBe(false);
  await look(page(), { colour: 'heat' });
});

test('bounds are finer near a place that is pinned', async () => {
  const first = await movesOf(page());
  const surface = page().locator('#original');
  await surface.focus();
  await surface.press('Enter');
  await expect(page().getByRole('group', { name: 'Probe' })).toContainText('Pinned');
  await tick('Finer near a place').check();
  await type('radius', 0.2);
  await type('times', 0.05);
  await reducedAsAsked();
  await expect(group('Finer bounds').locator('summary')).toContainText('× 0.05 near a place');
  const place = await Promise.all(
    ['x', 'y', 'z'].map(async (axis) => Number(await page().getByLabel(`Place ${axis}`).inputValue())),
  );
  const near = placesOf(original).flatMap((each, vertex) =>
    Math.hypot(...each.map((at, axis) => at - place[axis])) < 0.2 ? [vertex] : [],
  );
  expect(near.length).toBeGreaterThan(30);
  const bound = 0.01 * Math.hypot(1, 1, 0.7);
  const moves = await movesOf(page());
  expect(Math.max(...near.map((vertex) => moves[vertex]))).toBeLessThanOrEqual(0.05 * bound);
  expect(Math.max(...near.map((vertex) => first[vertex]))).toBeGreaterThan(0.05 * bound);
  expect(Math.max(...moves)).toBeGreaterThan(0.5 * bound);

  await page().keyboard.press('Escape');
  await expect(page().getByRole('button', { name: 'At the pinned place' })).toBeDisabled();
});

test('what cannot be a focus is refused with a reason, and Escape brings back what holds', async () => {
  await tick('Finer near a place').check();
  await type('times', 0.2);
  await reducedAsAsked();
  const { after } = await counts(page());
  for (const [label, text, says] of [
    ['times', '2', 'The factor must be above zero and at most 1.'],
    ['times', '0', 'The factor must be above zero and at most 1.'],
    ['radius', '-1', 'The radius must be above zero.'],
    ['Place y', '', 'A number is needed.'],
  ]) {
    const field = page().getByLabel(label, { exact: true });
    const held = await field.inputValue();
    await type(label, text);
    await expect(group('Finer bounds').getByRole('alert')).toHaveText(says);
    await expect(field).toHaveAttribute('aria-invalid', 'true');
    await expect(field).toHaveAccessibleDescription(says);
    await field.press('Escape');
    await expect(group('Finer bounds').getByRole('alert')).toHaveCount(0);
    await expect(field).toHaveAttribute('aria-invalid', 'false');
    await expect(field).toHaveValue(held);
  }
  await expect(group('Finer bounds').locator('summary')).toContainText('× 0.2 near a place');
  expect((await counts(page())).after).toBe(after);
});

test('parts smaller than the bound are dropped when asked for, and counted', async () => {
  await open('Report');
  const report = group('Report');
  await expect(report).toContainText('not dropped');
  const isSmall = ([, , z]: number[]) => z > 0.4;
  expect(placesOf((await savedMesh()).mesh).filter(isSmall)).toHaveLength(4);
  await tick('Drop parts smaller than the bound').check();
  await expect(sentence(page())).toContainText('1 small part left out: nothing guaranteed of it.');
  await expect(report.locator('summary')).toContainText('1 part dropped');
  await expect(report).toContainText('1 dropped (4 triangles)');
  expect(placesOf((await savedMesh()).mesh).filter(isSmall)).toEqual([]);

  // A region of which nothing is left is said to be gone.
  const regions = original.regions?.map((label, triangle) => (triangle < 3200 ? label : 9));
  await chooseFile(page(), 'apart.vtp', await vtp({ ...original, regions }));
  await page().getByLabel('Regions from').selectOption('material');
  await expect(report.locator('summary')).toContainText('1 part dropped, regions vanished');
  await expect(report).toContainText('3 kept; vanished: 9');
});

test('parts that are near each other are kept apart by either way', async () => {
  await openMesh('spike.vtp', humpAndSpike());
  await type('Bound of position in percent', 14);
  await open('Report');
  const top = async () => placesOf((await savedMesh()).mesh).some(([, , z]) => Math.abs(z - 0.1) < singlePrecision);
  expect(await top()).toBe(false);
  await tick('Let no part pierce another').check();
  await expect(group('Method').locator('summary')).toContainText('no piercing');
  await expect.poll(top).toBe(true);
  await tick('Let no part pierce another').uncheck();
  await expect.poll(top).toBe(false);
  await tick('Limit space to feature size').check();
  await expect.poll(top).toBe(true);
  await expect(group('Report').locator('summary')).toContainText('space limited');
  await expect(group('Report')).toContainText(/Feature size\s*0\.0\d+: space is limited to half of it/);
});

test('what was turned round is said', async () => {
  await openMesh('turned.vtp', oneTurned());
  await expect(group('Report').locator('summary')).toContainText('turned round');
  await open('Report');
  await expect(group('Report')).toContainText('1 triangle turned round');
  await expect(group('Report')).toContainText(/Turned over 90°\s*0 triangles \(\d+ before\)/);
  await expect(group('Report')).toContainText(/Folds of the map\s*\d+ of \d+ cells/);
});

test('the address holds what is kept, and leads to the same result', async ({ browser }) => {
  await page().getByLabel('Sample').selectOption('fireballs');
  await settled(page());
  await tick('Lock what meets a box').check();
  await type('Points', '3,17-20');
  await tick('Finer near a place').check();
  await page().getByLabel('Multiply by').selectOption('temperature');
  await tick('Drop parts smaller than the bound').check();
  await settled(page());
  await expect
    .poll(() => page().url())
    .toMatch(/&?drop-small-components=&lock-points=3%2C17-20&lock-box=.*&bound-multiplier=temperature&focus-point=/);
  const result = await sentence(page()).innerText();
  const other = await browser.newPage();
  await other.goto(page().url());
  await expect(sentence(other)).toHaveText(result);
  for (const summary of ['points, a box', '× temperature, × 0.1 near a place', 'small parts dropped']) {
    await expect(other.locator('summary', { hasText: summary })).toBeVisible();
  }
  await other.close();
  await page().getByLabel('Sample').selectOption('impact');
  await settled(page());
  await expect.poll(() => page().url()).not.toMatch(/lock-|focus/);
});

for (const colorScheme of ['light', 'dark'] as const) {
  test(`everything in the groups can be used by everyone, ${colorScheme}`, async ({ page: own }) => {
    await own.emulateMedia({ colorScheme });
    await openPage(own);
    await chooseFile(own, 'patches.vtp', await vtp(original));
    for (const title of ['Locks and regions', 'Finer bounds', 'Report', 'Method']) {
      await own.locator('summary', { hasText: title }).click();
    }
    await own.getByLabel('Lock what meets a box').check();
    await own.getByLabel('Finer near a place').check();
    await own.getByLabel('Regions from').selectOption('material');
    await own.getByLabel('times').fill('2');
    await own.getByLabel('times').press('Enter');
    await settled(own);
    const { violations } = await new AxeBuilder({ page: own }).analyze();
    expect(violations.map(({ id, nodes }) => [id, ...nodes.map(({ target }) => target)])).toEqual([]);
    await own.setViewportSize({ width: 360, height: 740 });
    expect(await own.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
  });
}
