import type { Page } from '@playwright/test';
import { type Colormap, colourTable } from '../../web/colour/colormaps.ts';

/** Pixels as red, green, blue, alpha bytes, row by row. */
export interface Picture {
  width: number;
  height: number;
  pixels: Uint8Array;
}

/** How far two parts of a colour may stand apart and still be the same: rounding, and little more. */
const sameColour = 6;

type Side = 'original' | 'reduced';

/** What a side of the stage shows between its caption and its legend. */
export async function pictureOf(page: Page, side: Side): Promise<Picture> {
  return decoded(page, await page.screenshot({ clip: await clipOf(page, side) }));
}

/** The same of one of several viewers on a page. */
export async function pictureIn(page: Page, viewer: string, side: Side): Promise<Picture> {
  return decoded(page, await page.screenshot({ clip: await clipOf(page, side, `${viewer} `) }));
}

/** The part of the page between the caption and the legend of a side. */
export async function clipOf(page: Page, side: Side, viewer = '') {
  const pane = await box(page, `${viewer}#${side}`);
  const caption = await box(page, `${viewer}#${side} .caption`);
  const legend = await box(page, `${viewer}#${side} meshbound-legend`);
  const top = caption.y + caption.height + 2;
  // One pixel less at every side: the line between the panes is not part of the picture.
  return { x: pane.x + 2, y: top, width: pane.width - 4, height: legend.y - 2 - top };
}

async function box(page: Page, selector: string) {
  const found = await page.locator(selector).boundingBox();
  if (!found) throw new Error(`${selector} is not shown`);
  return found;
}

/** Larger pictures are thinned out to about this many pixels a side: enough to judge by. */
const largestSide = 800;

/** The browser decodes its own screenshot. */
async function decoded(page: Page, png: Buffer): Promise<Picture> {
  const source = { base64: png.toString('base64'), largest: largestSide };
  const { width, height, pixels } = await page.evaluate(async ({ base64, largest }) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const step = Math.ceil(Math.max(bitmap.width, bitmap.height) / largest);
    const size = [Math.floor(bitmap.width / step), Math.floor(bitmap.height / step)] as const;
    const context = new OffscreenCanvas(...size).getContext('2d') as OffscreenCanvasRenderingContext2D;
    context.imageSmoothingEnabled = false;
    context.drawImage(bitmap, 0, 0, ...size);
    let text = '';
    for (const byte of context.getImageData(0, 0, ...size).data) text += String.fromCharCode(byte);
    return { width: size[0], height: size[1], pixels: btoa(text) };
  }, source);
  return { width, height, pixels: new Uint8Array(Buffer.from(pixels, 'base64')) };
}

type Rgb = [number, number, number];

function colourAtPixel({ pixels }: Picture, pixel: number): Rgb {
  return [pixels[4 * pixel], pixels[4 * pixel + 1], pixels[4 * pixel + 2]];
}

function apart([red, green, blue]: Rgb, [otherRed, otherGreen, otherBlue]: Rgb): number {
  return Math.max(Math.abs(red - otherRed), Math.abs(green - otherGreen), Math.abs(blue - otherBlue));
}

/** Pixels well inside the surface: they and their neighbours differ from the background, which the first pixel shows. */
export function surfacePixels(picture: Picture): number[] {
  const { width, height } = picture;
  const background = colourAtPixel(picture, 0);
  const covered = (pixel: number) => apart(colourAtPixel(picture, pixel), background) > sameColour;
  const inside: number[] = [];
  for (let y = 2; y < height - 2; y++) {
    for (let x = 2; x < width - 2; x++) {
      const pixel = y * width + x;
      const cross = [pixel, pixel - 2, pixel + 2, pixel - 2 * width, pixel + 2 * width];
      if (cross.every(covered)) inside.push(pixel);
    }
  }
  return inside;
}

/** The share of the picture that the surface covers, 0…1. */
export function coverage(picture: Picture): number {
  return surfacePixels(picture).length / (picture.width * picture.height);
}

/** The share of pixels in which two pictures of the same size differ, 0…1. */
export function difference(a: Picture, b: Picture): number {
  if (a.width !== b.width || a.height !== b.height) throw new Error('The pictures have different sizes.');
  let different = 0;
  for (let pixel = 0; pixel < a.width * a.height; pixel++) {
    if (apart(colourAtPixel(a, pixel), colourAtPixel(b, pixel)) > sameColour) different++;
  }
  return different / (a.width * a.height);
}

/** Light scales a colour down to this factor at most. */
const darkest = 0.6;
/** Enough pixels to judge by, spread over the surface. */
const judgedPixels = 1500;

/** The share of the surface's pixels whose colour is one of the map's, lit, 0…1. */
export function shareFromMap(picture: Picture, map: Colormap): number {
  const table = colourTable(map);
  const judged = judgedOf(surfacePixels(picture));
  const found = judged.filter((pixel) => isLitColourOf(table, colourAtPixel(picture, pixel)));
  return found.length / judged.length;
}

/** A place of the surface in the picture, 0…1 from left to right, with the place in the map that its colour stands for. */
export interface ShownPlace {
  x: number;
  place: number;
}

/** What the colours of the surface's pixels stand for in the map, 0…1. Light is allowed for as far as colour tells it. */
export function placesIn(picture: Picture, map: Colormap): ShownPlace[] {
  const table = colourTable(map);
  const entries = entriesOf(table);
  return judgedOf(surfacePixels(picture)).map((pixel) => {
    const seen = colourAtPixel(picture, pixel);
    const distances = entries.map((entry) => distanceToLit(table, entry, seen));
    const nearest = distances.indexOf(Math.min(...distances));
    return { x: (pixel % picture.width) / picture.width, place: nearest / (entries.length - 1) };
  });
}

function judgedOf(pixels: number[]): number[] {
  const step = Math.max(1, Math.floor(pixels.length / judgedPixels));
  return pixels.filter((_, index) => index % step === 0);
}

/** How far a colour is from an entry of the map in the light that fits best. */
function distanceToLit(table: Uint8Array, entry: number, seen: Rgb): number {
  const [red, green, blue] = [table[4 * entry], table[4 * entry + 1], table[4 * entry + 2]];
  const along = seen[0] * red + seen[1] * green + seen[2] * blue;
  const light = along / (red * red + green * green + blue * blue);
  const factor = Math.min(1, Math.max(darkest, light));
  return apart(seen, [factor * red, factor * green, factor * blue]);
}

function isLitColourOf(table: Uint8Array, seen: Rgb): boolean {
  return entriesOf(table).some((entry) => distanceToLit(table, entry, seen) <= sameColour);
}

function entriesOf(table: Uint8Array): number[] {
  return Array.from({ length: table.length / 4 }, (_, entry) => entry);
}

/** Whether any pixel has the colour of a broken bound, lit. */
export function hasBrokenBound(picture: Picture): boolean {
  const count = picture.width * picture.height;
  return Array.from({ length: count }, (_, pixel) => colourAtPixel(picture, pixel)).some(
    ([red, green, blue]) => green < 40 && red > 140 && Math.abs(red - blue) < 20,
  );
}
