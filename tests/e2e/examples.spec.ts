// The examples that are pages do what they say, served as their list says: all files of the checkout, as they lie there.
import { execFileSync } from 'node:child_process';
import { createReadStream, existsSync, statSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, type Page, test } from '@playwright/test';

const root = fileURLToPath(new URL('../..', import.meta.url));
const types: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.mjs': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
};

let server: Server;
let address: string;

test.beforeAll(async () => {
  server = createServer(({ url = '/' }, response) => {
    const path = normalize(new URL(url, 'http://localhost').pathname);
    const file = join(root, path.endsWith('/') ? `${path}index.html` : path);
    if (!existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.setHeader('Content-Type', types[extname(file)] ?? 'application/octet-stream');
    createReadStream(file).pipe(response);
  });
  await new Promise<void>((listening) => server.listen(0, '127.0.0.1', listening));
  address = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
});

test.afterAll(() => server.close());

/** Keeps what goes wrong on a page. */
function faultsOf(page: Page): string[] {
  const faults: string[] = [];
  page.on('pageerror', ({ message }) => faults.push(message));
  return faults;
}

function numbersIn(text: string): number[] {
  return Array.from(text.matchAll(/\d+/g), ([number]) => Number(number));
}

test('the plain page shows a surface and reduces it further where the slider is moved', async ({ page }) => {
  const faults = faultsOf(page);
  await page.goto(`${address}/examples/html/`);
  const result = page.getByRole('status').filter({ hasText: 'triangles became' });
  await expect(result).toHaveText(/^7296 triangles became 840\.$/);
  await page.getByLabel('Bound of all variables').fill('10');
  await expect(page.getByText('10 %')).toBeVisible();
  await expect(async () => expect(numbersIn(await result.innerText())[1]).toBeLessThan(840)).toPass();
  expect(faults).toEqual([]);
});

test('the app built by Vite reduces a mesh of its own, and shows a file that is chosen', async ({ page }) => {
  execFileSync('npx', ['vite', 'build', 'examples/vite', '--logLevel', 'warn'], { cwd: root, stdio: 'inherit' });
  const faults = faultsOf(page);
  await page.goto(`${address}/build/examples-vite/`);
  await expect(page.locator('#result')).toHaveText(/^A hill of 8192 triangles became one of \d+\.$/);
  const [before, after] = numbersIn(await page.locator('#result').innerText());
  expect(after).toBeLessThan(before / 4);
  await page.getByLabel('Show a surface').setInputFiles(join(root, 'build/samples/fireballs.ply'));
  await expect(page.locator('meshbound-viewer #reduced .caption')).toContainText('840');
  expect(faults).toEqual([]);
});
