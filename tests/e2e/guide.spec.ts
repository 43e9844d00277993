import { readdirSync, readFileSync } from 'node:fs';
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
  await expect(viewer.locator('.sentence')).toContainText('proved', { timeout: 30_000 });
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
  for (const { name } of [...members, ...cssParts, ...cssProperties]) {
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

/** Compressed: all that a viewer needs to show a PLY; what reads and writes the other formats is loaded when it is needed. */
const budget = 450_000;

test('what a viewer transfers keeps to its budget', () => {
  const folder = new URL('../../dist/element/', import.meta.url).pathname;
  const needed = readdirSync(folder).filter((name) => /\.(js|wasm)$/.test(name) && !/^(write|read-(?!ply))/.test(name));
  expect(needed).toContain('meshbound-viewer.js');
  const sizes = (ending: string) =>
    needed.filter((name) => name.endsWith(ending)).map((name) => gzipSync(readFileSync(join(folder, name))).length);
  // Of the WebAssembly modules, with threads and without, a page loads one.
  const sum = sizes('.js').reduce((total, size) => total + size, Math.max(...sizes('.wasm')));
  expect(sum).toBeGreaterThan(200_000);
  expect(sum).toBeLessThan(budget);
});
