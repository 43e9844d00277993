import { expect, test } from '@playwright/test';
import { readSurface } from '../../web/formats/read.ts';
import { chooseFile, counts, saved, sentence, settled, sharePage } from './open-page.ts';
import { coverage, difference, pictureOf } from './picture.ts';
import { ply } from './surfaces.ts';

// Triangles on one another, and ends of sheets beside one another.

const page = sharePage();
const side = 16;

/** A wavy sheet of points that both sides share; a triangle for each way that it is to face. */
function sheetOf(...ways: (1 | -1)[]): Buffer {
  const vertices = Array.from({ length: side * side }, (_, i) => {
    const [x, y] = [(i % side) / (side - 1), Math.floor(i / side) / (side - 1)];
    return [x, y, 0.02 * Math.sin(3 * x), 300 + 10 * x];
  });
  const squares = Array.from(
    { length: (side - 1) ** 2 },
    (_, i) => (i % (side - 1)) + side * Math.floor(i / (side - 1)),
  );
  const faces = squares.flatMap((at) =>
    [
      [at, at + 1, at + side + 1],
      [at, at + side + 1, at + side],
    ].flatMap(([a, b, c]) => ways.map((way) => (way > 0 ? [a, b, c] : [a, c, b]))),
  );
  return ply({ vertices, faces, variables: ['heat'] });
}

async function open(name: string, content: Buffer, triangles: number): Promise<void> {
  await chooseFile(page(), name, content);
  await expect.poll(async () => (await counts(page())).before).toBe(triangles);
  await settled(page());
}

const oneSide = 2 * (side - 1) ** 2;

test('both sides of a sheet are reduced together, twice as many triangles as of one', async () => {
  await open('one.ply', sheetOf(1), oneSide);
  const one = (await counts(page())).after;
  await open('two.ply', sheetOf(1, -1), 2 * oneSide);
  expect((await counts(page())).after).toBe(2 * one);
  await expect(sentence(page())).toContainText('proved');
  const { mesh } = await readSurface('two.ply', (await saved(page(), 'ply')).bytes);
  const names = new Set(
    Array.from({ length: mesh.triangles.length / 3 }, (_, t) =>
      [...mesh.triangles.subarray(3 * t, 3 * t + 3)].sort().join(),
    ),
  );
  expect(names.size).toBe(mesh.triangles.length / 6);
});

test('of both sides each place is told, and its error', async () => {
  await open('two.ply', sheetOf(1, -1), 2 * oneSide);
  for (const pane of ['original', 'reduced']) {
    const box = await page().locator(`#${pane}`).boundingBox();
    await page().mouse.move((box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2);
    await expect(page().locator('meshbound-probe-card')).toContainText('heat');
  }
  await page().mouse.move(0, 0);
});

test('levels of both sides morph without a hole', async () => {
  await open('two.ply', sheetOf(1, -1), 2 * oneSide);
  await page().getByLabel('Levels of detail').selectOption('2');
  const slider = page().getByLabel('Position among levels');
  await expect(slider).toBeEnabled();
  const original = await pictureOf(page(), 'original');
  for (const position of ['0', '0.5', '1', '1.5', '2']) {
    await slider.fill(position);
    await expect.poll(async () => difference(original, await pictureOf(page(), 'reduced'))).toBeLessThan(0.2);
    expect(coverage(await pictureOf(page(), 'reduced'))).toBeGreaterThan(0.5 * coverage(original));
  }
  await page().getByLabel('Levels of detail').selectOption('0');
});

test('copies of triangles are left out, which is said', async () => {
  await open('copies.ply', sheetOf(1, 1, 1), 3 * oneSide);
  const { after } = await counts(page());
  await open('one.ply', sheetOf(1), oneSide);
  expect(after).toBe((await counts(page())).after);
  await open('copies.ply', sheetOf(1, 1, 1), 3 * oneSide);
  await expect(page().locator('.notice')).toContainText(/900 triangles .*left out/);
});

test('a crack within rounding is said with a way to close it, and is closed by it', async () => {
  const half = (x: number, shift: number) =>
    Array.from({ length: 12 }, (_, i) => [x + (i % 2), Math.floor(i / 2), 0, i + shift]);
  const strip = (first: number) =>
    [0, 1, 2, 3, 4].flatMap((row) => [
      [first + 2 * row, first + 2 * row + 1, first + 2 * row + 3],
      [first + 2 * row, first + 2 * row + 3, first + 2 * row + 2],
    ]);
  const content = ply({
    vertices: [...half(0, 0), ...half(1.000001, 1)],
    faces: [...strip(0), ...strip(12)],
    variables: ['heat'],
  });
  await open('cracked.ply', content, 20);
  const notice = page().locator('.notice', { hasText: 'A crack: 12 points' });
  await notice.getByRole('button', { name: 'Join them' }).click();
  await expect(page().locator('.notice', { hasText: '6 points where sheets end put where others lie' })).toBeVisible();
  await expect(notice).toHaveCount(0);
});
