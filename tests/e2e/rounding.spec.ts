import { expect, test } from '@playwright/test';
import type { Mesh } from '../../wasm/types.ts';
import { readSurface } from '../../web/formats/read.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { chooseFile, counts, saved, settled, sharePage, typePercent } from './open-page.ts';

// GLB rounds to single precision. What the page guarantees, it guarantees of the file.

const page = sharePage();
const side = 40;

/** A plate whose temperature, in double precision, waves by 0.001 about 300, where single precision has steps of 0.00003. */
function plate(): Mesh {
  const points = Array.from({ length: side * side }, (_, i) => [i % side, Math.floor(i / side)]);
  const squares = points.filter(([x, y]) => x < side - 1 && y < side - 1).map(([x, y]) => x + side * y);
  return {
    position: Float32Array.from(points.flatMap(([x, y]) => [x, y, 0])),
    triangles: Uint32Array.from(squares.flatMap((at) => [at, at + 1, at + side + 1, at, at + side + 1, at + side])),
    variables: [
      {
        name: 'temperature',
        components: 1,
        values: Float64Array.from(points, ([x, y]) => 300 + 1e-3 * Math.sin(x / 3) * Math.cos(y / 4)),
      },
    ],
  };
}

const notice = () => page().locator('.notice', { hasText: 'GLB rounds numbers, so the surface was reduced again' });

test.beforeAll(async () => {
  await chooseFile(page(), 'plate.vtp', Buffer.from(await writeSurface('vtp', plate())));
  await expect.poll(async () => (await counts(page())).before).toBe(2 * (side - 1) ** 2);
  await settled(page());
});

test('a file that rounds holds what was reduced again for it, which is said', async () => {
  const { after } = await counts(page());
  const { name, bytes } = await saved(page(), 'glb');
  const { mesh } = await readSurface(name, bytes);
  const kept = mesh.triangles.length / 3;
  expect(kept).toBeGreaterThan(after);
  await expect(notice()).toContainText(
    `${kept} triangles keep every bound in the file, in place of the ${after} shown.`,
  );
  // What is shown stays.
  expect((await counts(page())).after).toBe(after);
});

test('the report that is saved then is that of the file', async () => {
  const { name } = await saved(page(), 'glb');
  const { bytes } = await saved(page(), 'report');
  const report = JSON.parse(new TextDecoder().decode(bytes));
  expect(report.file).toBe(name);
  const [, temperature] = report.variables;
  expect(temperature.rounding).toBeGreaterThan(1e-5);
  expect(temperature.error).toBeLessThanOrEqual(temperature.bound);
  expect(temperature.ratio).toBeLessThanOrEqual(1);
  await saved(page(), 'vtp');
  const plain = JSON.parse(new TextDecoder().decode((await saved(page(), 'report')).bytes));
  expect(plain.file).toMatch(/\.vtp$/);
  expect(plain.variables[1]).not.toHaveProperty('rounding');
});

test('levels of detail are reduced again as well', async () => {
  await page().getByLabel('Levels of detail').selectOption('2');
  await expect(page().getByLabel('Position among levels')).toBeEnabled();
  const { bytes } = await saved(page(), 'levels');
  await expect(notice()).toContainText(/\d, \d+ triangles keep every bound in the file/);
  expect(new TextDecoder('latin1').decode(bytes)).toContain('"MSFT_lod":{"ids":[1]}');
  await page().getByLabel('Levels of detail').selectOption('0');
});

test('a bound that the format cannot keep is refused by name, and nothing is saved', async () => {
  await typePercent(page(), 'Bound of temperature', '0.5');
  await settled(page());
  await page().getByRole('button', { name: 'Save…' }).click();
  await page().getByRole('button', { name: 'GLB', exact: true }).click();
  await expect(page().getByRole('alert')).toContainText(/GLB cannot keep the bound .* of “temperature”/);
});
