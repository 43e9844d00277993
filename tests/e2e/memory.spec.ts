import { expect, type Page, test } from '@playwright/test';
import { chooseFile, counts, openPage, settled } from './open-page.ts';
import { sheet } from './surfaces.ts';

/** What the page holds at a moment. */
interface Held {
  buffers: number;
  textures: number;
  workers: number;
  /** Of the engine, in bytes. */
  webAssembly: number;
  /** Of the page, in bytes, with the arrays of its surfaces. */
  page: number;
}

/** Counts what WebGL makes and drops, from the page's first moment on. */
async function countOnCard(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const context = WebGL2RenderingContext.prototype;
    const live = { buffers: 0, textures: 0 };
    const { createBuffer, deleteBuffer, createTexture, deleteTexture } = context;
    context.createBuffer = function () {
      live.buffers++;
      return createBuffer.call(this);
    };
    context.deleteBuffer = function (buffer) {
      live.buffers--;
      deleteBuffer.call(this, buffer);
    };
    context.createTexture = function () {
      live.textures++;
      return createTexture.call(this);
    };
    context.deleteTexture = function (texture) {
      live.textures--;
      deleteTexture.call(this, texture);
    };
    Object.assign(window, { liveOnCard: live });
  });
}

/** Lets the engine's worker be asked how much memory its WebAssembly has. */
async function watchWebAssembly(page: Page): Promise<void> {
  const watch = `for (const name of ['instantiate', 'instantiateStreaming']) {
    const instantiate = WebAssembly[name];
    WebAssembly[name] = async (...given) => {
      const made = await instantiate(...given);
      // Its own, or with threads given to it.
      const parts = [(made.instance ?? made).exports, ...Object.values(given[1] ?? {})].flatMap(Object.values);
      globalThis.memory ??= parts.find((each) => each instanceof WebAssembly.Memory);
      return made;
    };
  }\n`;
  await page.route(/\/worker-[^/]*\.js$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: watch + (await response.text()) });
  });
}

function webAssemblyBytes(page: Page): Promise<number> {
  const engine = page.workers().find((worker) => /\/worker-[^/]*\.js$/.test(worker.url()));
  if (!engine) throw new Error('The engine has no worker.');
  return engine.evaluate(() => (globalThis as unknown as { memory: WebAssembly.Memory }).memory.buffer.byteLength);
}

async function held(page: Page): Promise<Held> {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.collectGarbage');
  const usage = (await session.send('Runtime.getHeapUsage')) as { usedSize: number; backingStorageSize?: number };
  await session.detach();
  const onCard = await page.evaluate(() => (window as unknown as { liveOnCard: object }).liveOnCard);
  return {
    ...(onCard as { buffers: number; textures: number }),
    workers: page.workers().length,
    webAssembly: await webAssemblyBytes(page),
    page: usage.usedSize + (usage.backingStorageSize ?? 0),
  };
}

async function open(page: Page, side: number): Promise<void> {
  await chooseFile(page, 'sheet.ply', sheet(side));
  await expect.poll(async () => (await counts(page)).before).toBe(2 * (side - 1) ** 2);
  await settled(page);
}

const side = 120;
/** What the page lets go of each file, at the least: 9 floats for the corners of each of its triangles. */
const ofOneFile = 2 * (side - 1) ** 2 * 9 * 4;

test('twenty files in a row leave no more behind than six', async ({ page }) => {
  test.slow();
  await countOnCard(page);
  await watchWebAssembly(page);
  await openPage(page);
  // Two sizes in turn, so that each file is seen to replace the one before.
  const openSome = async (first: number, last: number) => {
    for (let file = first; file <= last; file++) await open(page, side - (file % 2));
    return held(page);
  };
  const { page: pageAtSix, ...atSix } = await openSome(1, 6);
  const { page: pageAtTwenty, ...atTwenty } = await openSome(7, 20);
  expect(atTwenty).toEqual(atSix);
  // Names of files, compiled code and the like may grow; not one of fourteen files may stay.
  expect(pageAtTwenty - pageAtSix).toBeLessThan(ofOneFile);
});

test('a large file that makes room for a small one leaves its memory to others', async ({ page }) => {
  test.slow();
  await watchWebAssembly(page);
  await openPage(page);
  const small = await webAssemblyBytes(page);
  await open(page, 560);
  expect(await webAssemblyBytes(page)).toBeGreaterThan(150e6);
  await open(page, 20);
  expect(await webAssemblyBytes(page)).toBeLessThanOrEqual(small);
});
