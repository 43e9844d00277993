import { readFileSync } from 'node:fs';
import { expect, test } from '@playwright/test';

test("the README's page shows a surface and its reduction", async ({ page }) => {
  const [, body] = /^```html\n(.*?)^```/ms.exec(readFileSync('README.md', 'utf8')) ?? [];
  const faults: string[] = [];
  page.on('pageerror', ({ message }) => faults.push(message));
  await page.route('**/readme.html', (route) => route.fulfill({ contentType: 'text/html', body }));
  await page.goto('./readme.html');
  await expect(page.locator('meshbound-viewer #original .caption')).toContainText(/[1-9]/);
  await expect(page.locator('meshbound-viewer #reduced .caption')).toContainText(/[1-9]/);
  await expect(page.locator('meshbound-viewer #reduced meshbound-legend')).toContainText('temperature');
  await expect(page.locator('meshbound-viewer')).toHaveAttribute('variable', 'temperature');
  expect(faults).toEqual([]);
});
