import { colourAt, cssColour } from '../../colour/colormaps.ts';
import { placeIn, roundTicks } from '../../colour/colour-range.ts';
import { tickText } from '../number-text.ts';
import type { Meaning } from '../stage/colouring.ts';
import { type LegendEnd, legendEnds } from './legend-ends.ts';

/** Measures of a legend in a picture, in CSS pixels. */
const [barWidth, barHeight, room] = [232, 10, 10];
const lineHeight = 16;
/** How wide a legend is, its room included. */
export const legendWidth = barWidth + 2 * room;
const tickCount = 4;

/** Draws what the colours of a surface mean, in a context scaled to CSS pixels; `left` and `bottom` are its corner. */
export function drawLegend(
  context: CanvasRenderingContext2D,
  meaning: Meaning,
  { left, bottom, ink }: { left: number; bottom: number; ink: string },
): void {
  const { title, unit, detail, map, range } = meaning;
  const ends = legendEnds(meaning);
  const lines = [unit && unit !== '1' ? `${title} [${unit}]` : title, ...(detail ? [detail] : [])];
  const numbers = bottom - room - (ends.length > 0 ? lineHeight : 0);
  const bar = numbers - lineHeight - barHeight;
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
    context.fillText(tickText(tick, range), x, numbers + 4);
  }
  drawEnds(context, ends, { left: left + room, baseline: bottom - room + 4, ink });
}

/** Side of the square of a colour, with the room behind it. */
const [swatchSide, swatchRoom] = [10, 14];

/** Spread over the width of the bar. */
function drawEnds(
  context: CanvasRenderingContext2D,
  ends: LegendEnd[],
  { left, baseline, ink }: { left: number; baseline: number; ink: string },
): void {
  context.textAlign = 'left';
  const widths = ends.map(({ text, colour }) => context.measureText(text).width + (colour ? swatchRoom : 0));
  const spare = barWidth - widths.reduce((sum, width) => sum + width, 0);
  const between = ends.length > 1 ? spare / (ends.length - 1) : 0;
  let x = left;
  ends.forEach(({ text, colour }, index) => {
    if (colour) {
      context.fillStyle = cssColour(colour);
      context.fillRect(Math.round(x), baseline - swatchSide + 1, swatchSide, swatchSide);
    }
    context.fillStyle = ink;
    context.fillText(text, x + (colour ? swatchRoom : 0), baseline);
    x += widths[index] + between;
  });
}
