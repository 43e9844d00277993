import { drawLegend } from '../legend/legend-picture.ts';
import type { Meaning } from './colouring.ts';

/** A legend with its left lower corner, in CSS pixels from the stage's left and upper edge. */
export interface PlacedLegend {
  meaning: Meaning;
  left: number;
  bottom: number;
}

/** How a stage looks, but for what is drawn on its canvas. */
export interface StageLook {
  /** In CSS pixels. */
  width: number;
  background: string;
  /** Of text. */
  ink: string;
  legends: readonly PlacedLegend[];
}

/** A picture of a stage as a PNG: the surfaces as they are drawn, before its background and with legends over them. */
export async function stagePicture(drawn: Blob, { width, background, ink, legends }: StageLook): Promise<Blob | null> {
  const surfaces = await createImageBitmap(drawn);
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [surfaces.width, surfaces.height];
  const context = canvas.getContext('2d') as CanvasRenderingContext2D;
  context.fillStyle = background;
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(surfaces, 0, 0);
  const scale = surfaces.width / width;
  context.scale(scale, scale);
  for (const { meaning, left, bottom } of legends) drawLegend(context, meaning, { left, bottom, ink });
  return new Promise((resolve) => canvas.toBlob(resolve));
}
