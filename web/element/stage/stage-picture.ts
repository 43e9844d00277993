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
  /** What must be known of what is shown, along the upper edge; empty where that is nothing. */
  note: string;
}

/** A picture of a stage as a PNG: the surfaces as they are drawn, before its background and with legends over them. */
export async function stagePicture(
  drawn: Blob,
  { width, background, ink, legends, note }: StageLook,
): Promise<Blob | null> {
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
  if (note) drawNote(context, note, { width, background, ink });
  return new Promise((resolve) => canvas.toBlob(resolve));
}

const [noteSize, noteRoom] = [13, 8];

/** In lines that the width holds, before the background, so that it can be read over any surface. */
function drawNote(
  context: CanvasRenderingContext2D,
  note: string,
  { width, background, ink }: Pick<StageLook, 'width' | 'background' | 'ink'>,
): void {
  context.font = `${noteSize}px system-ui, sans-serif`;
  context.textAlign = 'left';
  const lines = linesOf(note, (text) => context.measureText(text).width <= width - 2 * noteRoom);
  context.fillStyle = background;
  context.fillRect(0, 0, width, lines.length * (noteSize + 5) + noteRoom);
  context.fillStyle = ink;
  for (const [i, line] of lines.entries()) context.fillText(line, noteRoom, noteRoom + noteSize + i * (noteSize + 5));
}

/** A text in lines that each fit, broken between words. */
function linesOf(text: string, fits: (line: string) => boolean): string[] {
  const lines: string[] = [];
  for (const word of text.split(' ')) {
    const longer = `${lines.at(-1)} ${word}`;
    if (lines.length > 0 && fits(longer)) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
