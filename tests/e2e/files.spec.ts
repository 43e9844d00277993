import { expect, test } from '@playwright/test';
import type { Mesh } from '../../wasm/types.ts';
import { readSurface } from '../../web/formats/read.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { chooseFile, counts, dropFile, saved, sentence, settled, sharePage, typePercent } from './open-page.ts';
import { coverage, pictureOf } from './picture.ts';
import { brokenFiles, ply, sheet, squareWithNaN } from './surfaces.ts';

const page = sharePage();

/** Of `heat`, some 300, and of errors of it, which are held and saved in single precision. */
const singlePrecision = 1e-4;

/** All numbers of a vertex as one text. */
function vertexText({ position, variables }: Mesh, vertex: number): string {
  const numbers = [...position.subarray(3 * vertex, 3 * vertex + 3)];
  for (const { values, components } of variables) {
    numbers.push(...values.subarray(components * vertex, components * (vertex + 1)));
  }
  return numbers.join(' ');
}

test('says what is wrong with a broken file and keeps the last good state', async () => {
  const before = await sentence(page()).innerText();
  for (const { name, content, says } of brokenFiles) {
    await dropFile(page(), name, content);
    const alert = page().getByRole('alert');
    await expect(alert).toContainText(`${name}: `);
    await expect(alert).toContainText(says);
    await alert.getByRole('button', { name: 'Dismiss' }).click();
    await expect(alert).toHaveCount(0);
    expect(await sentence(page()).innerText()).toBe(before);
  }
  await expect(page().getByLabel('Sample')).toHaveValue('fireballs');
  expect(coverage(await pictureOf(page(), 'reduced'))).toBeGreaterThan(0.1);
  // Usable as before.
  await typePercent(page(), 'Bound of pressure', '9');
  await expect(sentence(page())).toContainText(/9.% in pressure/);
});

for (const format of ['ply', 'vtp']) {
  test(`saves the reduced surface as ${format}, with every variable and the values of the input`, async () => {
    await chooseFile(page(), 'my sheet.ply', sheet(40));
    await expect.poll(async () => (await counts(page())).before).toBe(2 * 39 * 39);
    await settled(page());
    const { after } = await counts(page());
    const { name, bytes } = await saved(page(), format);
    expect(name).toBe(`my-sheet-reduced.${format}`);
    const { mesh } = await readSurface(name, bytes);
    const original = (await readSurface('sheet.ply', new Uint8Array(sheet(40)))).mesh;
    expect(mesh.triangles.length / 3).toBe(after);
    expect(mesh.variables.map((variable) => variable.name)).toEqual(['heat', 'wind']);
    const given = new Set(
      Array.from({ length: original.position.length / 3 }, (_, vertex) => vertexText(original, vertex)),
    );
    for (let vertex = 0; vertex < mesh.position.length / 3; vertex++) {
      expect(given.has(vertexText(mesh, vertex))).toBe(true);
    }
  });
}

test('saves the map: where every vertex of the original lies on the reduced surface that is saved beside it', async () => {
  await chooseFile(page(), 'my sheet.ply', sheet(40));
  await expect.poll(async () => (await counts(page())).before).toBe(2 * 39 * 39);
  await settled(page());
  const reduced = (await readSurface('a.vtp', (await saved(page(), 'vtp')).bytes)).mesh;
  const { name, bytes } = await saved(page(), 'map');
  expect(name).toBe('my-sheet-map.vtp');
  const { mesh } = await readSurface(name, bytes);
  expect(mesh.triangles.length / 3).toBe(2 * 39 * 39);
  const valuesOf = (variable: string) => mesh.variables.find((each) => each.name === variable)?.values as Float64Array;
  const [triangle, shares, heat] = ['reduced_triangle', 'reduced_barycentric', 'heat_error'].map(valuesOf);
  const errors = Array.from(triangle, (host, vertex) => {
    const there = [0, 1, 2].reduce((sum, corner) => {
      const kept = reduced.triangles[3 * host + corner];
      return sum + shares[3 * vertex + corner] * reduced.variables[0].values[kept];
    }, 0);
    return Math.abs(valuesOf('heat')[vertex] - there);
  });
  const misplaced = errors.filter((error, vertex) => Math.abs(error - heat[vertex]) > singlePrecision);
  expect(misplaced).toEqual([]);
  expect(Math.max(...errors)).toBeGreaterThan(0);
});

test('what was saved opens again', async () => {
  const { after } = await counts(page());
  const { name, bytes } = await saved(page(), 'vtp');
  await chooseFile(page(), name, Buffer.from(bytes));
  await expect.poll(async () => (await counts(page())).before).toBe(after);
  await expect(page().getByLabel('Sample')).toHaveValue('');
});

test('opens a file dropped anywhere', async () => {
  await dropFile(page(), 'sheet.ply', sheet(30));
  await expect.poll(async () => (await counts(page())).before).toBe(2 * 29 * 29);
  await expect(page().getByTitle('heat', { exact: true })).toBeVisible();
  await expect.poll(async () => coverage(await pictureOf(page(), 'reduced'))).toBeGreaterThan(0.1);
});

test('opens every format, packed or not', async () => {
  const formats = ['vtp', 'vtk', 'ply', 'glb', 'obj', 'stl'] as const;
  let side = 10;
  for (const format of formats) {
    for (const gzip of [false, true]) {
      // Another number of triangles each time tells the files apart.
      side++;
      const { mesh } = await readSurface('sheet.ply', new Uint8Array(sheet(side)));
      const bytes = await writeSurface(format, mesh, { gzip });
      await dropFile(page(), `sheet.${format}${gzip ? '.gz' : ''}`, Buffer.from(bytes));
      await expect.poll(async () => (await counts(page())).before).toBe(2 * (side - 1) ** 2);
    }
  }
});

test('opens a surface together with variables in CSV', async () => {
  const { mesh } = await readSurface('sheet.ply', new Uint8Array(sheet(12)));
  const bytes = await writeSurface('vtp', { ...mesh, variables: [] });
  const wind = `wind [m/s]\n${Array.from(mesh.position)
    .filter((_, i) => i % 3 === 0)
    .join('\n')}\n`;
  await page()
    .locator('input[type=file]')
    .setInputFiles([
      { name: 'wind.csv', mimeType: 'text/csv', buffer: Buffer.from(wind) },
      { name: 'plain.vtp', mimeType: '', buffer: Buffer.from(bytes) },
    ]);
  await expect(page().getByTitle('wind', { exact: true })).toBeVisible();
  await expect.poll(async () => (await counts(page())).before).toBe(2 * 11 * 11);
});

test('says which variable is no number somewhere, and offers to leave it out', async () => {
  await dropFile(page(), 'square.ply', squareWithNaN());
  const notices = page().locator('meshbound-notices');
  await expect(notices).toContainText('“pressure” holds NaN or infinity (at 1 point, which is 1)');
  await expect(sentence(page())).toContainText('2 of 4 triangles');
  const row = page().locator('meshbound-bound-row', { hasText: 'pressure' });
  await expect(row).toContainText('has NaN');
  await expect(row).toContainText('error not known');
  await page().getByLabel('pressure bounded').check();
  await expect(page().getByRole('alert')).toContainText(/“pressure” is not a number at vertex 1/);
  await page().getByLabel('pressure bounded').uncheck();
  await expect(page().getByRole('alert')).toHaveCount(0);
  await page().getByRole('button', { name: 'Leave out “pressure”' }).click();
  await expect(notices).toContainText('“pressure” was left out');
  await expect(row).toHaveCount(0);
  await expect(sentence(page())).toContainText('2 of 4 triangles');
});

test('says of an identifier that it is one, and gives it no bound', async () => {
  const vertices = [0, 1, 2, 3, 4, 5, 6, 7, 8].map((i) => [i % 3, Math.floor(i / 3), 0, 100 + i]);
  const faces = [0, 1, 3, 4].map((i) => [i, i + 1, i + 4, i + 3]);
  await dropFile(page(), 'ids.ply', ply({ vertices, faces, variables: ['GlobalNodeID'] }));
  const row = page().locator('meshbound-bound-row').nth(1);
  await expect(row).toContainText('identifier');
  await expect(page().getByLabel('GlobalNodeID bounded')).not.toBeChecked();
  await expect(sentence(page())).toContainText('2 of 8 triangles');
});

test('says what is odd about a file that it opens', async () => {
  const vertices = [
    [0, 0, 0],
    [1, 0, 0],
    [1, 1, 0],
    [0, 1, 0],
    [5, 5, 5],
  ];
  await dropFile(
    page(),
    'quad.ply',
    ply({
      vertices,
      faces: [
        [0, 1, 2, 3],
        [0, 0, 1],
      ],
    }),
  );
  const notices = page().locator('meshbound-notices');
  await expect(notices).toContainText('1 vertex belongs to no triangle');
  await expect(notices).toContainText('1 triangle with a repeated vertex');
  await expect(notices).toContainText('more than three corners split into triangles');
});

test('names from a file are shown as text', async () => {
  const name = '<img/src=x/onerror=document.title="broken">';
  const vertices = [
    [0, 0, 0, 1],
    [1, 0, 0, 2],
    [0, 1, 0, 3],
  ];
  await dropFile(page(), '<b>bold</b>.ply', ply({ vertices, faces: [[0, 1, 2]], variables: [name] }));
  await expect(page().locator('meshbound-bound-row').nth(1)).toContainText(name);
  await expect(page()).toHaveTitle('Meshbound');
});
