import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import type { Manifest } from '../../web/guide/reference.ts';

test('the page about the element shows it at work, and names everything that it has', async ({ page }) => {
  const faults: string[] = [];
  page.on('pageerror', ({ message }) => faults.push(message));
  page.on('console', (message) => message.type() === 'error' && faults.push(message.text()));
  await page.goto('./element.html');
  const viewer = page.locator('meshbound-viewer').first();
  await expect(viewer.locator('.sentence')).toContainText('proved');
  await expect(page.locator('figure pre').first()).toContainText('bounds="position: 1%; *: 3%; pressure: 0.005"');
  const before = await viewer.locator('.sentence').innerText();
  await page.getByRole('button', { name: 'Loosen' }).click();
  await expect(page.locator('output')).toContainText('triangles');
  await expect(viewer.locator('.sentence')).not.toHaveText(before);

  const manifest: Manifest = await (await page.request.get('element/custom-elements.json')).json();
  const { members, cssParts, cssProperties } = manifest.modules[0].declarations[0];
  const observed = await page.evaluate(
    () => (customElements.get('meshbound-viewer') as unknown as { observedAttributes: string[] }).observedAttributes,
  );
  expect(members.flatMap(({ attribute }) => attribute ?? []).sort()).toEqual(
    observed.filter((name) => name !== 'drawnonce').sort(),
  );
  expect(members.filter(({ description }) => !description)).toEqual([]);
  const attributes = members.flatMap(({ attribute }) => (attribute ? [{ name: attribute }] : []));
  for (const { name } of [...attributes, ...members, ...cssParts, ...cssProperties]) {
    await expect(page.locator('td:first-child code').getByText(name, { exact: true }).first()).toBeAttached();
  }
  await viewer.locator('#original').press('Enter');
  // Each part that is named is there: red reaches it.
  for (const { name } of cssParts.filter((part) => !['poster', 'notice', 'progress', 'divider'].includes(part.name))) {
    const part = page.locator(`[part~=${name.replace('legend-', '')}]`).first();
    await page.evaluate((each) => {
      const sheet = new CSSStyleSheet();
      sheet.replaceSync(`meshbound-viewer::part(${each}) { outline: 3px solid rgb(255, 0, 0); }`);
      document.adoptedStyleSheets = [sheet];
    }, name);
    await expect(part).toHaveCSS('outline-color', 'rgb(255, 0, 0)');
  }

  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    const { violations } = await new AxeBuilder({ page }).analyze();
    expect(violations.map(({ id, nodes }) => [id, ...nodes.map(({ target }) => target)])).toEqual([]);
  }
  expect(faults).toEqual([]);
});

/** Packed by gzip, all that a viewer asks for to show a PLY, but for the surface itself. */
const budget = 450_000;

const isolation = { 'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp' };

for (const [isolated, headers] of [
  ['isolated from other origins, with threads,', isolation],
  ['not isolated', {}],
] as const) {
  test(`what a viewer transfers keeps to its budget, on a page ${isolated}`, async ({ page }) => {
    const requested = new Set<string>();
    page.context().on('request', (request) => requested.add(new URL(request.url()).pathname));
    const body = `<!doctype html><title>A viewer</title><script type="module" src="element/meshbound-viewer.js"></script>
      <meshbound-viewer src="samples/fireballs.ply"></meshbound-viewer>`;
    await page.route('**/own.html', (route) => route.fulfill({ contentType: 'text/html', headers, body }));
    await page.goto('./own.html');
    await expect(page.locator('#reduced .caption')).toContainText(/Reduced [1-9]/);
    const folder = new URL('../../dist', import.meta.url).pathname;
    const needed = [...requested].filter((path) => path.startsWith('/element/'));
    expect(needed.filter((path) => path.endsWith('.wasm'))).toHaveLength(1);
    expect(needed.some((path) => path.endsWith('.mjs'))).toBe(headers === isolation);
    const sizes = needed.map((path) => gzipSync(readFileSync(join(folder, path))).length);
    expect(sizes.reduce((total, size) => total + size, 0)).toBeLessThan(budget);
  });
}
