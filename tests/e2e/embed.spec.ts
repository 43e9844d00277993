import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { expect, type Page, test } from '@playwright/test';

/** What the page of someone else allows, with the module's host and nothing more. */
function policy(host: string): string {
  return [
    "default-src 'none'",
    `script-src ${host} 'wasm-unsafe-eval'`,
    `connect-src ${host}`,
    `worker-src blob: ${host}`,
    `img-src ${host}`,
    "style-src 'none'",
  ].join('; ');
}

let server: Server;
let address: string;

/** A page of another origin than the element's, as its author would write it. */
function embeddingPage(host: string): string {
  const sample = (name: string) => `${host}/samples/${name}.ply`;
  return `<!doctype html>
<html lang="en">
  <title>Two viewers</title>
  <script type="module" src="${host}/element/meshbound-viewer.js"></script>
  <meshbound-viewer id="first" controls alt="Two fireballs" variable="temperature" bounds="position: 2%; *: 5%"
    src="${sample('fireballs')}"></meshbound-viewer>
  <pre>${'\n'.repeat(80)}</pre>
  <meshbound-viewer id="second" src="${sample('impact')}" show="error" loading="lazy"></meshbound-viewer>
</html>`;
}

test.beforeAll(async ({ baseURL }) => {
  const host = new URL(baseURL as string).origin;
  server = createServer((_, response) => {
    response.setHeader('Content-Type', 'text/html');
    response.setHeader('Content-Security-Policy', policy(host));
    response.end(embeddingPage(host));
  });
  await new Promise<void>((listening) => server.listen(0, '127.0.0.1', listening));
  address = `http://127.0.0.1:${(server.address() as AddressInfo).port}/`;
});

test.afterAll(() => server.close());

/** Keeps what a viewer tells of itself. */
async function record(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const told: object[] = [];
    for (const name of ['load', 'progress', 'reduce', 'probe', 'error']) {
      const keep = (event: Event) => {
        const { id, localName } = event.target as Element;
        if (localName === 'meshbound-viewer') told.push({ id, name, detail: (event as CustomEvent).detail });
      };
      document.addEventListener(name, keep, { capture: true });
    }
    document.addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) =>
      told.push({ name: 'violation', violatedDirective, blockedURI }),
    );
    Object.assign(window, { told });
  });
}

interface Told {
  id: string;
  name: string;
  detail: {
    phase?: string;
    progress?: number;
    triangles?: { before: number; after: number };
    name?: string;
    pinned?: boolean;
  };
}

function told(page: Page): Promise<Told[]> {
  return page.evaluate(() => (window as unknown as { told: Told[] }).told);
}

test('works on a page of another origin, twice, under a strict policy', async ({ page }) => {
  const faults: string[] = [];
  page.on('pageerror', ({ message }) => faults.push(message));
  await page.setViewportSize({ width: 900, height: 500 });
  await record(page);
  await page.goto(address);
  const of = async (id: string, name: string) =>
    (await told(page)).filter((each) => each.id === id && each.name === name);
  await expect.poll(async () => (await of('first', 'reduce')).length).toBe(1);
  await expect.poll(async () => (await of('first', 'progress')).at(-1)?.detail).toEqual({ phase: 'draw', progress: 1 });
  const progress = (await of('first', 'progress')).map(({ detail }) => detail);
  expect(new Set(progress.map(({ phase }) => phase))).toEqual(new Set(['download', 'read', 'check', 'reduce', 'draw']));
  expect(progress.map((each) => each.progress)).toEqual(progress.map((each) => each.progress).sort());
  expect(progress[0].progress).toBeLessThan(0.1);

  const first = page.locator('#first');
  await expect(first.locator('.sentence')).toContainText(/Every point within 2.% in space, 5.% in .*: proved/);
  await expect(first.getByRole('group', { name: 'Two fireballs' })).toBeVisible();
  await expect(first.locator('meshbound-legend .title').first()).toHaveText('temperature [K]');
  expect(await first.evaluate((viewer: HTMLElementTagNameMap['meshbound-viewer']) => viewer.bounds)).toContain(
    'position: 2%; ',
  );

  // The other one is out of sight, and waits.
  expect(await of('second', 'progress')).toEqual([]);
  await page.locator('#second').scrollIntoViewIfNeeded();
  await expect.poll(async () => (await of('second', 'reduce')).length).toBe(1);
  expect((await told(page)).filter(({ name }) => name === 'violation' || name === 'error')).toEqual([]);
  expect(faults).toEqual([]);
});

test('says what is wrong, by event and in words, and goes on with the next', async ({ page }) => {
  await record(page);
  await page.goto(address);
  const viewer = page.locator('#first');
  await expect(viewer.locator('.sentence')).toContainText('proved');
  const set = (name: string, value: string) =>
    viewer.evaluate((element, [key, text]) => element.setAttribute(key, text), [name, value]);
  const codes = async () => (await told(page)).filter(({ name }) => name === 'error').map(({ detail }) => detail);
  await set('bounds', 'position: -1%');
  await set('bounds', 'speed: 1%; position: 1%');
  await set('src', new URL('nothing.ply', address).href);
  await expect.poll(codes).toMatchObject(
    [
      { code: 'bad_bound', message: /above zero/ },
      { code: 'unknown_variable', message: /“speed”/ },
      { code: 'cannot_load', message: /nothing\.ply cannot be loaded/ },
    ].map(({ code }) => ({ code })),
  );
  const report = await viewer.evaluate(async (element: HTMLElementTagNameMap['meshbound-viewer']) => {
    element.bounds = 'position: 5%; *: 9%';
    const { triangles } = await element.reduce();
    const aborted = element.reduce().then(
      () => 'not aborted',
      ({ name }) => name,
    );
    element.abort();
    return { triangles, aborted: await aborted, same: element.report?.triangles.after === triangles.after };
  });
  expect(report.triangles.after).toBeLessThan(report.triangles.before / 10);
  expect(report).toMatchObject({ aborted: 'AbortError', same: true });
});

test('tells what is pointed at, pins it on a click and lets it go, each viewer for itself', async ({ page }) => {
  await record(page);
  await page.goto(address);
  const viewer = page.locator('#first');
  await expect(viewer.locator('.sentence')).toContainText('proved');
  const last = async () => (await told(page)).findLast(({ name }) => name === 'probe');
  await viewer.locator('#reduced').click();
  await expect.poll(last).toMatchObject({ id: 'first', detail: { pinned: true, probe: { from: 'reduced' } } });
  await expect(viewer.getByRole('group', { name: 'Probe' })).toContainText('Pinned');
  const isWorst = await viewer.evaluate(async (element: HTMLElementTagNameMap['meshbound-viewer']) => {
    await element.probeWorst('temperature');
    const { probe, report } = element;
    const index = report?.variables.findIndex((variable) => variable.name === 'temperature') ?? -1;
    return Math.abs((probe?.variables[index].ratio ?? 0) - (report?.variables[index].ratio ?? 1)) < 1e-5;
  });
  expect(isWorst).toBe(true);
  await page.keyboard.press('Escape');
  await expect.poll(last).toMatchObject({ id: 'first', detail: { pinned: false } });
  await expect(viewer.getByText('Pinned')).toHaveCount(0);
  expect(new Set((await told(page)).filter((each) => each.name === 'probe').map(({ id }) => id))).toEqual(
    new Set(['first']),
  );
});
