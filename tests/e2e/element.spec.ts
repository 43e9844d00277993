import { readFile } from 'node:fs/promises';
import { expect, type Locator, type Page, test } from '@playwright/test';
import { difference, pictureIn, shareFromMap } from './picture.ts';

type Viewer = HTMLElementTagNameMap['meshbound-viewer'];

/** A page that anyone could write: the module, and what stands in `body`. */
async function openOwnPage(page: Page, body: string): Promise<void> {
  const content = `<!doctype html><html lang="en"><title>Own page</title>
    <script type="module" src="element/meshbound-viewer.js"></script>${body}</html>`;
  await page.route('**/own.html', (route) => route.fulfill({ contentType: 'text/html', body: content }));
  await page.goto('./own.html');
}

const usual = '<meshbound-viewer src="samples/fireballs.ply" controls></meshbound-viewer>';

async function reduced(viewer: Locator): Promise<void> {
  await expect(viewer.locator('#reduced .caption')).toContainText(/Reduced [1-9]/);
  await expect(viewer.locator('.numbers')).toContainText('removed');
}

/** An attribute of the element, what else can be said by it, and what the view is to show of that. */
const attributes: [
  name: string,
  value: string,
  property: string | boolean,
  holds: (viewer: Locator) => Promise<void>,
][] = [
  ['bounds', '*: 20%', 'position: 20%; density: 20%', (v) => expect(v.locator('.sentence')).toContainText('20')],
  ['variable', 'vx', 'vx', (v) => expect(v.locator('.title').first()).toHaveText('vx [km/s]')],
  [
    'variable',
    'position',
    'position',
    (v) => expect(v.locator('.title').first()).toHaveText('position, magnitude [m]'),
  ],
  ['component', 'y', 'y', (v) => expect(v.locator('.title').first()).toHaveText('position, y [m]')],
  ['show', 'error', 'error', (v) => expect(v.locator('.title').first()).toHaveText('error / bound: position')],
  ['show', 'value', 'value', (v) => expect(v.locator('.title').first()).toHaveText('position, y [m]')],
  ['colormap', 'magma', 'magma', (v) => expect(v.locator('.bar').first()).toHaveAttribute('style', /rgb\(0, 0, 4\)/)],
  ['range', '-1…1', '-1…1', (v) => expect(v.locator('.swatch')).toHaveCount(4)],
  ['view', 'original', 'original', (v) => expect(v.locator('#reduced')).toBeHidden()],
  ['view', 'wipe', 'wipe', (v) => expect(v.locator('.divider')).toBeVisible()],
  ['view', 'split', 'split', (v) => expect(v.locator('#reduced')).toBeVisible()],
  ['edges', '', true, (v) => expect(v.getByLabel('Edges')).toBeChecked()],
  ['unlinked', '', true, (v) => expect(v.getByLabel('One camera')).not.toBeChecked()],
  ['alt', 'Two balls', 'Two balls', (v) => expect(v.getByRole('group', { name: 'Two balls' })).toBeVisible()],
];

test('what attributes say, properties say too, and the view shows', async ({ page }) => {
  await openOwnPage(page, usual + usual);
  const [byAttribute, byProperty] = [0, 1].map((index) => page.locator('meshbound-viewer').nth(index));
  await reduced(byAttribute);
  await reduced(byProperty);
  for (const [name, value, property, holds] of attributes) {
    await byAttribute.evaluate((viewer, [key, text]) => viewer.setAttribute(key, text), [name, value]);
    await holds(byAttribute);
    const given = typeof property === 'boolean' ? property : value;
    await byProperty.evaluate((viewer, [key, said]) => Object.assign(viewer, { [key as string]: said }), [name, given]);
    await holds(byProperty);
    for (const viewer of [byAttribute, byProperty]) {
      const read = await viewer.evaluate((element, key) => element[key as keyof typeof element], name);
      if (typeof property === 'boolean') expect(read).toBe(true);
      else expect(read).toContain(property);
    }
  }
  await byAttribute.evaluate((viewer) => viewer.removeAttribute('controls'));
  await expect(byAttribute.locator('.sentence')).toHaveCount(0);
  await expect(byProperty.locator('.sentence')).toHaveCount(1);
});

/** Attributes of what is kept, and what they make of the reduction. */
const keptAttributes: [attribute: string, property: string, value: string, says: RegExp][] = [
  ['lock-points', 'lockPoints', '3,100-900', /proved/],
  ['lock-box', 'lockBox', '0,-30,-30,30,30,30', /proved/],
  ['bound-multiplier', 'boundMultiplier', 'temperature', /times the multiplier there: proved/],
  ['focus-point', 'focusPoint', '0,0,0,20,0.2', /times the multiplier there: proved/],
];

test('what is kept is said by attributes or properties, and is in the state', async ({ page }) => {
  await openOwnPage(page, usual + usual);
  const [byAttribute, byProperty] = [0, 1].map((index) => page.locator('meshbound-viewer').nth(index));
  for (const viewer of [byAttribute, byProperty]) await reduced(viewer);
  for (const [attribute, property, value, says] of keptAttributes) {
    const before = await byAttribute.locator('.sentence').innerText();
    await byAttribute.evaluate((viewer, [name, text]) => viewer.setAttribute(name, text), [attribute, value]);
    await byProperty.evaluate((viewer, [name, text]) => Object.assign(viewer, { [name]: text }), [property, value]);
    await expect(byAttribute.locator('.sentence')).not.toHaveText(before);
    await expect(byAttribute.locator('.sentence')).toHaveText(says);
    await expect(byProperty.locator('.sentence')).toHaveText(await byAttribute.locator('.sentence').innerText());
  }
  const state = await byAttribute.evaluate((viewer: Viewer) => viewer.state);
  expect(state).toMatchObject(Object.fromEntries(keptAttributes.map(([attribute, , value]) => [attribute, value])));
  const first = await byProperty.evaluate(async (viewer: Viewer) => {
    viewer.state = {};
    await viewer.updateComplete;
    return viewer.state;
  });
  for (const [attribute] of keptAttributes) expect(first).not.toHaveProperty(attribute);
  await expect(byProperty.locator('.sentence')).not.toContainText('multiplier');
});

test('what cannot be kept is said, and what was shown stays', async ({ page }) => {
  await openOwnPage(page, usual);
  const viewer = page.locator('meshbound-viewer');
  await reduced(viewer);
  const before = await viewer.locator('.sentence').innerText();
  await viewer.evaluate((element: Viewer) => {
    const codes: string[] = [];
    element.addEventListener('error', (event) => codes.push((event as unknown as CustomEvent).detail.code));
    Object.assign(window, { codes });
  });
  for (const [attribute, value, says] of [
    ['lock-points', '3,x', /lock-points cannot be “3,x”: “x” is no point and no range of points/],
    ['lock-points', '0-4294967294', /There is no point 4294967294 to lock: the surface has \d+, counted from 0/],
    ['lock-box', '1,2,3', /lock-box cannot be “1,2,3”: a box has six numbers/],
    ['focus-point', '0,0,0,1,7', /factor of a focus point must be above zero and at most 1/],
    ['lock-regions', 'all', /“all” is not the number of a region/],
    ['regions', 'material', /no cell data “material” to part it into regions; it has none/],
    ['bound-multiplier', 'vx', /“vx”, which multiplies the bounds, is not above zero/],
    ['bound-multiplier', 'wind', /multiplied by “wind”, but there is no such variable/],
  ] as const) {
    await viewer.evaluate((element, [name, text]) => element.setAttribute(name, text), [attribute, value]);
    await expect(viewer.getByRole('alert').filter({ hasText: says })).toBeVisible();
    await viewer.evaluate((element, name) => element.removeAttribute(name), attribute);
    await expect(viewer.locator('.sentence')).toHaveText(before);
  }
  const codes = await page.evaluate(() => (window as unknown as { codes: string[] }).codes);
  expect(codes).toEqual(expect.arrayContaining(['unknown_regions', 'bad_option', 'unknown_variable']));
});

test('tells where a place of the original is pinned', async ({ page }) => {
  await openOwnPage(page, usual);
  const viewer = page.locator('meshbound-viewer');
  await reduced(viewer);
  await viewer.evaluate((element: Viewer) => {
    const told: unknown[] = [];
    element.addEventListener('pin', (event) => told.push((event as CustomEvent).detail.place));
    Object.assign(window, { told });
  });
  const told = () => page.evaluate(() => (window as unknown as { told: (number[] | null)[] }).told);
  await viewer.locator('#original').press('Enter');
  await expect.poll(told).toHaveLength(1);
  expect((await told())[0]).toHaveLength(3);
  await viewer.locator('#original').press('Escape');
  await expect.poll(told).toHaveLength(2);
  expect((await told())[1]).toBe(null);
});

test('as a morph it shows the reduced surface alone, in levels of detail with a slider', async ({ page }) => {
  await openOwnPage(page, usual.replace('controls', 'controls view="morph"'));
  const viewer = page.locator('meshbound-viewer');
  await expect(viewer.locator('#reduced .caption')).toContainText('Level 1');
  await expect(viewer.locator('#original')).toBeHidden();
  expect(await viewer.evaluate((element: Viewer) => element.levelCount)).toBe(4);
  await viewer.getByRole('slider', { name: /level/i }).fill('2.5');
  await expect.poll(() => viewer.evaluate((element: Viewer) => element.level)).toBe(2.5);
  await viewer.evaluate((element: Viewer) => {
    element.view = 'split';
  });
  await expect(viewer.locator('#original')).toBeVisible();
});

test('levels of detail are made, shown, told of and saved', async ({ page }) => {
  await openOwnPage(page, usual.replace('controls', 'controls level="2" level-count="3"'));
  const viewer = page.locator('meshbound-viewer');
  const caption = viewer.locator('#reduced .caption');
  await expect(caption).toContainText('Level 2');
  await viewer.evaluate((element: Viewer) => {
    const told: unknown[] = [];
    for (const name of ['levels', 'level-change']) {
      element.addEventListener(name, (event) => told.push([name, (event as CustomEvent).detail]));
    }
    Object.assign(window, { told });
  });
  const told = () => page.evaluate(() => (window as unknown as { told: [name: string, detail: unknown][] }).told);
  await viewer.evaluate((element: Viewer) => Object.assign(element, { level: 0.5 }));
  await expect(caption).toContainText('On the way to level 1');
  expect(await told()).toEqual([['level-change', { level: 0.5 }]]);
  await viewer.getByLabel('Position among levels').fill('3');
  await expect(caption).toContainText('Level 3');
  expect(
    await viewer.evaluate(({ level, levelCount, levelPixels }: Viewer) => [level, levelCount, levelPixels]),
  ).toEqual([3, 3, null]);
  await viewer.evaluate((element: Viewer) => element.setAttribute('level-pixels', '1000'));
  await viewer.evaluate((element: Viewer) => Object.assign(element, { level: 9 }));
  await expect(caption).toContainText('Level 3');
  expect(await viewer.evaluate(({ levelPixels }: Viewer) => levelPixels)).toBe(null);

  await viewer.evaluate((element: Viewer) => element.setAttribute('level-count', '2'));
  await expect.poll(async () => (await told()).at(-1)?.[0]).toBe('levels');
  expect((await told()).at(-1)?.[1]).toHaveLength(2);
  const started = page.waitForEvent('download');
  await viewer.evaluate((element: Viewer) => element.save('levels'));
  expect((await started).suggestedFilename()).toBe('fireballs-levels.glb');

  await viewer.evaluate((element: Viewer) => element.removeAttribute('level-count'));
  await expect(caption).toContainText('Reduced');
  await expect(viewer.getByLabel('Position among levels')).toHaveCount(0);
});

test('the camera is read, set, told of, and stays what an attribute says until it moves', async ({ page }) => {
  await openOwnPage(page, usual.replace('controls', 'controls camera="0 0 6 / 0 0 0"'));
  const viewer = page.locator('meshbound-viewer');
  await reduced(viewer);
  const camera = () => viewer.evaluate((element: Viewer) => element.camera);
  await expect.poll(camera).toBe('0 0 6 / 0 0 0');
  await viewer.evaluate((element: Viewer) => {
    const told: (string | null)[] = [];
    element.addEventListener('camera-change', (event) => told.push((event as CustomEvent).detail.camera));
    Object.assign(window, { told });
  });
  const told = () => page.evaluate(() => (window as unknown as { told: (string | null)[] }).told);
  await viewer.locator('#original').press('ArrowLeft');
  await expect.poll(async () => (await told()).length).toBeGreaterThan(0);
  expect(await told()).toContain(await camera());
  expect(await camera()).not.toBe('0 0 6 / 0 0 0');
  await viewer.evaluate((element: Viewer) => element.lookFrom('-y'));
  await expect.poll(camera).toMatch(/^0 -[\d.]+ \S+ \/ 0 0 0$/);
  await viewer.evaluate((element: Viewer) => element.fit());
  await expect.poll(camera).toBe(null);
  await expect.poll(async () => (await told()).at(-1)).toBe(null);
});

test('gives its picture, its report and its files to the page around it', async ({ page }) => {
  await openOwnPage(page, usual);
  const viewer = page.locator('meshbound-viewer');
  await reduced(viewer);
  const { type, report } = await viewer.evaluate(async (element: Viewer) => {
    const blob = await element.toBlob({ legends: false });
    return { type: blob.type, report: element.report };
  });
  expect(type).toBe('image/png');
  expect(report?.variables.map(({ name }) => name)).toContain('pressure');
  expect(report?.variables.every(({ ratio }) => ratio <= 1)).toBe(true);
  for (const kind of ['ply', 'vtp', 'vtk', 'glb', 'obj', 'stl', 'report', 'map'] as const) {
    const started = page.waitForEvent('download');
    await viewer.evaluate((element: Viewer, each) => element.save(each), kind);
    const file = await readFile(await (await started).path());
    expect(file.length).toBeGreaterThan(1000);
  }
});

test('shows a poster until the first surface, and what the page puts into its slots', async ({ page }) => {
  const svg = "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/%3E";
  await page.route('**/never.ply', () => undefined);
  await openOwnPage(
    page,
    `<meshbound-viewer src="never.ply" poster="${svg}" controls><button slot="controls">Own</button></meshbound-viewer>
     <meshbound-viewer src="never.ply"><p slot="poster">Please wait</p></meshbound-viewer>
     <meshbound-viewer src="samples/fireballs.ply" poster="${svg}"></meshbound-viewer>`,
  );
  const [image, slotted, drawn] = [0, 1, 2].map((index) => page.locator('meshbound-viewer').nth(index));
  await expect(image.locator('img')).toBeVisible();
  await expect(image.getByRole('button', { name: 'Own' })).toBeVisible();
  await expect(slotted.getByText('Please wait')).toBeVisible();
  await expect(drawn.locator('#reduced .caption')).toContainText(/Reduced [1-9]/);
  await expect(drawn.locator('img')).toHaveCount(0);
});

test('looks as the page around it says, by custom properties and the colour scheme', async ({ page }) => {
  await openOwnPage(
    page,
    `<style>
      meshbound-viewer { --meshbound-stage: rgb(255, 240, 220); --meshbound-ink: rgb(90, 0, 0); --meshbound-radius: 9px; }
      meshbound-viewer::part(caption) { text-transform: uppercase; }
    </style>${usual}`,
  );
  const viewer = page.locator('meshbound-viewer');
  await reduced(viewer);
  await expect(viewer.locator('meshbound-stage')).toHaveCSS('background-color', 'rgb(255, 240, 220)');
  await expect(viewer.locator('.sentence')).toHaveCSS('color', 'rgb(90, 0, 0)');
  await expect(viewer.getByRole('button', { name: 'Fit' })).toHaveCSS('border-radius', '9px');
  await expect(viewer.locator('#original .caption')).toHaveCSS('text-transform', 'uppercase');
  // Every custom property that the manifest names is in use.
  const manifest = await (await page.request.get('element/custom-elements.json')).json();
  const names: string[] = manifest.modules[0].declarations[0].cssProperties.map(({ name }: { name: string }) => name);
  const script = await (await page.request.get('element/meshbound-viewer.js')).text();
  expect(names.filter((name) => !script.includes(`var(${name}`))).toEqual([]);
});

test('finds workers and WebAssembly elsewhere where the page says so', async ({ page }) => {
  const elsewhere: string[] = [];
  await page.route('**/assets-of-mine/**', async (route) => {
    elsewhere.push(new URL(route.request().url()).pathname);
    const response = await route.fetch({ url: route.request().url().replace('assets-of-mine', 'element') });
    await route.fulfill({ response });
  });
  const beside: string[] = [];
  page.on('request', (request) => {
    if (/\/element\/.*(worker|\.wasm)/.test(request.url())) beside.push(request.url());
  });
  await openOwnPage(
    page,
    `<script type="module">
      import { loadWorkersFrom } from './element/meshbound-viewer.js';
      loadWorkersFrom('./assets-of-mine/');
      document.body.innerHTML = '${usual}';
    </script><body></body>`,
  );
  await reduced(page.locator('meshbound-viewer'));
  expect(elsewhere.some((path) => path.endsWith('.wasm'))).toBe(true);
  expect(elsewhere.filter((path) => path.includes('worker')).length).toBeGreaterThanOrEqual(3);
  expect(beside).toEqual([]);
});

test('on a phone the surfaces are stacked, and most of each is seen between its caption and its legend', async ({
  page,
}) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await openOwnPage(page, '<meshbound-viewer src="samples/fireballs.ply"></meshbound-viewer>');
  await expect(page.locator('#reduced .caption')).toContainText(/Reduced [1-9]/);
  for (const pane of ['#original', '#reduced']) {
    const boxes = ['', ' .caption', ' meshbound-legend'].map((part) => page.locator(pane + part).boundingBox());
    const [whole, caption, legend] = (await Promise.all(boxes)).map((box) => box?.height ?? 0);
    expect(caption + legend).toBeLessThan(whole / 2);
    expect(caption + legend).toBeGreaterThan(0);
  }
});

test('several on a page are each for themselves', async ({ page }) => {
  await openOwnPage(
    page,
    `<style>meshbound-viewer { height: 300px; aspect-ratio: auto; }</style>
     <meshbound-viewer id="a" src="samples/fireballs.ply" colormap="cividis"></meshbound-viewer>
     <meshbound-viewer id="b" src="samples/impact.ply" colormap="magma"></meshbound-viewer>`,
  );
  const picture = (id: string) => pictureIn(page, `#${id}`, 'original');
  for (const [id, map] of [
    ['a', 'cividis'],
    ['b', 'magma'],
  ] as const) {
    await expect(page.locator(`#${id} #reduced .caption`)).toContainText(/Reduced [1-9]/);
    await expect.poll(async () => shareFromMap(await picture(id), map)).toBeGreaterThan(0.8);
  }
  const before = await picture('b');
  await page.locator('#a #original').press('ArrowLeft');
  await page.locator('#a').evaluate((viewer) => viewer.setAttribute('show', 'error'));
  await expect(page.locator('#a .title').first()).toContainText('error');
  expect(difference(before, await picture('b'))).toBe(0);
  await page.locator('#a').evaluate((viewer) => viewer.remove());
  expect(difference(before, await picture('b'))).toBe(0);
  // And one that is put back draws again.
  await page.locator('#b').evaluate((viewer) => {
    const { parentElement } = viewer;
    viewer.remove();
    parentElement?.append(viewer);
  });
  await expect.poll(async () => difference(before, await picture('b'))).toBeLessThan(0.01);
});

for (const style of [
  'display: block; height: 360px',
  'display: flex; height: 360px',
  'display: grid; height: 360px',
  'display: inline-block; width: 600px; height: 360px',
  'display: table-cell; width: 600px; height: 360px',
]) {
  test(`is laid out whatever the host page makes of its display: ${style}`, async ({ page }) => {
    await openOwnPage(page, `<style>meshbound-viewer { ${style} }</style>${usual}`);
    const viewer = page.locator('meshbound-viewer');
    await reduced(viewer);
    const [whole, stage] = [await viewer.boundingBox(), await viewer.locator('meshbound-stage').boundingBox()];
    expect(whole?.height).toBeCloseTo(360, 0);
    expect(stage?.height).toBeGreaterThan(120); // beside the bars that it has here
    expect(stage?.width).toBeGreaterThan(500);
  });
}

test('is laid out when it was hidden at first', async ({ page }) => {
  await openOwnPage(page, `<div id="hidden" style="display: none">${usual}</div>`);
  await page.locator('#hidden').evaluate((box) => box.removeAttribute('style'));
  const viewer = page.locator('meshbound-viewer');
  await reduced(viewer);
  expect((await viewer.locator('meshbound-stage').boundingBox())?.height).toBeGreaterThan(150);
});

for (const faulty of ['bounds="posit: 1%"', 'bounds="position: much"', 'lock-points="3,x"', 'focus-point="1"']) {
  test(`refuses ${faulty} and shows the original`, async ({ page }) => {
    await openOwnPage(page, usual.replace('controls', `controls ${faulty}`));
    const viewer = page.locator('meshbound-viewer');
    await expect(viewer.locator('.sentence')).toContainText('Not reduced.');
    await expect(viewer.getByRole('alert')).toHaveCount(1);
    await expect(viewer.locator('#reduced .caption')).toHaveText('Not reduced');
    expect(await viewer.evaluate((element: Viewer) => element.report)).toBeNull();
  });
}
