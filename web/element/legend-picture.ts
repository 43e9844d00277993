import { colourAt, cssColour } from '../colour/colormaps.ts';
import { placeIn, roundTicks } from '../colour/colour-range.ts';
import type { Meaning } from './colouring.ts';
import { valueText } from './number-text.ts';

/** Measures of a legend in a picture, in CSS pixels. */
const [barWidth, barHeight, room] = [232, 10, 10];
const lineHeight = 16;
const tickCount = 4;

/** Draws what the colours of a surface mean, in a context scaled to CSS pixels; `left` and `bottom` are its corner. */
export function drawLegend(
  context: CanvasRenderingContext2D,
  { title, unit, detail, map, range }: Meaning,
  { left, bottom, ink }: { left: number; bottom: number; ink: string },
): void {
  const lines = [unit && unit !== '1' ? `${title} [${unit}]` : title, ...(detail ? [detail] : [])];
  const bar = bottom - room - lineHeight - barHeight;
  context.fillStyle = ink;
  context.font = '12.5px system-ui, sans-serif';
  context.textAlign = 'left';
  lines.forEach((line, index) => {
    context.fillText(line, left + room, bar - 6 - lineHeight * (lines.length - 1 - index));
  });
  for (let x = 0; x < barWidth; x++) {
    context.fillStyle = cssColour(colourAt(map, x / (barWidth - 1)));
    context.fillRect(left + room + x, bar, 1, barHeight);
  }
  context.fillStyle = ink;
  context.textAlign = 'center';
  for (const tick of roundTicks(range, tickCount)) {
    const x = left + room + barWidth * placeIn(range, tick);
    context.fillRect(x, bar + barHeight, 1, 4);
    context.fillText(valueText(tick, 6), x, bottom - room + 4);
  }
}
