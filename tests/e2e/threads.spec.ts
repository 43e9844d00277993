import { createHash } from 'node:crypto';
import { expect, type Page, test } from '@playwright/test';
import { chooseFile, counts, openPage, settled } from './open-page.ts';
import { sheet } from './surfaces.ts';

/** Serves the page without what isolates it from other origins, as most hosts do. */
async function withoutIsolation(page: Page): Promise<void> {
  await page.route('**/*', async (route) => {
    const response = await route.fetch();
    const headers = { ...response.headers() };
    delete headers['cross-origin-opener-policy'];
    delete headers['cross-origin-embedder-policy'];
    await route.fulfill({ response, headers });
  });
}

interface Outcome {
  isolated: boolean;
  threaded: boolean;
  counts: { before: number; after: number };
  mesh: string;
}

/** Reduces a surface that is large enough to be shared out; which module did it, and a hash of what is saved. */
async function reduceLarge(page: Page): Promise<Outcome> {
  const loaded: string[] = [];
  page.context().on('request', (request) => loaded.push(request.url()));
  await openPage(page);
  await chooseFile(page, 'sheet.ply', sheet(200));
  await expect.poll(async () => (await counts(page)).before).toBe(2 * 199 * 199);
  await settled(page);
  const download = page.waitForEvent('download');
  await page
    .locator('meshbound-viewer')
    .evaluate((element) => (element as HTMLElement & { save(format: string): Promise<void> }).save('ply'));
  const chunks: Buffer[] = [];
  for await (const chunk of await (await download).createReadStream()) chunks.push(chunk);
  return {
    isolated: await page.evaluate(() => crossOriginIsolated),
    threaded: loaded.some((url) => /meshbound\.worker[^/]*\.js$/.test(url)),
    counts: await counts(page),
    mesh: createHash('sha256').update(Buffer.concat(chunks)).digest('hex'),
  };
}

test('an isolated page reduces with threads, another without, to the same bytes', async ({ browser }) => {
  const isolated = await reduceLarge(await browser.newPage());
  const page = await browser.newPage();
  await withoutIsolation(page);
  const plain = await reduceLarge(page);
  expect(isolated).toMatchObject({ isolated: true, threaded: true });
  expect(plain).toEqual({ ...isolated, isolated: false, threaded: false });
});
