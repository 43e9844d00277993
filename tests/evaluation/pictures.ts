import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';

import { look, openPage, settled } from '../e2e/open-page.ts';
import { clipOf } from '../e2e/picture.ts';
import { stillPicture, withPage } from './browser.ts';
import type { PaperCase } from './paper.ts';

/** Each surface has some 500 × 300 pixels. */
const viewport = { width: 1400, height: 700 };
const quality = 85;

/** The file of one picture, beside the others; `level` is `original` or the bounds in percent. */
export function pictureFile(sample: string, variable: string, level: string): string {
  return `${sample}-${variable}-${level}.jpg`;
}

/** The page as it greets its user, for the README. */
export async function takePagePicture(file: string): Promise<void> {
  await withPage({ viewport: { width: 1280, height: 760 }, colorScheme: 'light' }, async (page) => {
    await openPage(page);
    await look(page, { edges: true });
    writeFileSync(file, await stillPicture(page, { type: 'jpeg', quality }));
  });
}

/**
 * Figures 7 and 8, drawn by the page: three variables of a surface, the original and two reductions each; the first variable
 * is flat shaded with its edges, as in the paper.
 */
export async function takePictures(cases: PaperCase[], folder: string): Promise<void> {
  mkdirSync(folder, { recursive: true });
  await withPage({ viewport, colorScheme: 'light' }, async (page) => {
    await openPage(page);
    for (const one of cases) await takeFigure(page, one, folder);
  });
}

async function takeFigure(page: Page, { sample, percents, drawn }: PaperCase, folder: string): Promise<void> {
  await page.getByLabel('Sample').selectOption(sample);
  await settled(page);
  const take = async (side: 'original' | 'reduced', variable: string, level: string) => {
    const picture = await stillPicture(page, { type: 'jpeg', quality, clip: await clipOf(page, side) });
    writeFileSync(join(folder, pictureFile(sample, variable, level)), picture);
  };
  for (const percent of percents) {
    await boundAll(page, percent);
    for (const variable of drawn) {
      const asInThePaper = variable === drawn[0];
      await look(page, { colour: variable, edges: asInThePaper });
      await shadeFlat(page, asInThePaper);
      // A little away, so that nothing lies under caption and legend.
      for (let press = 0; press < 2; press++) await page.locator('#original').press('-');
      if (percent === percents[0]) await take('original', variable, 'original');
      await take('reduced', variable, `${percent}`);
    }
  }
}

async function shadeFlat(page: Page, flat: boolean): Promise<void> {
  await page.locator('meshbound-viewer').evaluate((viewer, wanted) => viewer.toggleAttribute('flat', wanted), flat);
}

/** The same bound for the geometry and all variables. */
async function boundAll(page: Page, percent: number): Promise<void> {
  for (const field of await page.getByLabel(/^Bound of .* in percent$/).all()) {
    await field.fill(`${percent}`);
    await field.press('Enter');
  }
  await settled(page);
}
