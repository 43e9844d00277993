import { markdownTable } from './markdown.ts';
import { percents, type WatchedStep } from './watched-steps.ts';

/** The morphs of a surface, with places and crossings of the map chosen and as the holes were laid out. */
export interface WatchedSurface {
  name: string;
  chosen: WatchedStep[];
  laidOut: WatchedStep[];
}

export function levelsDocument(surfaces: WatchedSurface[], frames: number): string {
  return `# Levels of detail, watched

This page is written by \`npm run evaluate:levels\`, after \`npm run build\`. How levels and the morphs between
them are made is said in [algorithm.md](algorithm.md#levels-of-detail-4).

The samples have ${percents.length} levels each, within ${percents.join(', ')} % of the geometry's extent and three times as many percent of that of
every variable. *Chosen* is the default: places and crossings of the map are chosen by their errors. *Laid out*: they are
where the layout of each hole puts them (\`optimizeVertexImages\`, \`optimizeEdgeCrossings\`).

## How large a morph is

A morph consists of the pieces of the mutual segmentation of two neighbouring levels; level 0 is the original. *Factor*:
pieces by triangles of the finer level. The tests hold it below 4 on every surface (\`tests/core/morph.test.cpp\`).

${sizeTable(surfaces)}

## What is seen of folds

Where the map turns a piece over, the morph is folded. The guarantee holds all the same; what matters is what one sees. So
a camera watches each way in ${frames} frames, coloured by pressure. *Changed*: the share of the surface's pixels
that change by more than 3 % of the range of a colour from one frame to the next, in the median and at most: a flip would stand out as
a frame that changes more than others. *Detour*: how far a pixel's colour goes beyond the way from its first to its last, in 1/255, in the
mean. *Folds seen*: on surfaces without a boundary only a fold shows its back; the share of pixels at most that change once backs are
not drawn. *Holes*: pixels at most that then show the background.

${seenTable(surfaces)}

Choosing leaves ${leaves(surfaces)} of the triangles of the coarsest levels and folds ${foldsOf(surfaces, 'chosen')} of the pieces instead of
${foldsOf(surfaces, 'laidOut')}. Yet no more is seen of these folds than of none: what differs once backs are not drawn are pixels at outlines, about as
many either way. No frame changes more than ${percent(mostChanged(surfaces))} of the pixels, and none has a hole. Colours go at most ${longerDetour(surfaces)}/255 farther, in the
mean over a surface. So levels of detail have the same default as a single reduction: both are chosen.

## What a frame asks of the graphics card

One call draws a morph, whichever levels there are (in the page a second one draws the original beside it). Both ends of every corner are
vertex attributes, mixed in the vertex shader: position, normal, place in the colour map, and for shading and edges the normal
of the level's triangle and the weights in it. Nothing is sent while the slider moves but its position.

${drawTable(surfaces)}

*MB*: what lies on the card, and is read once a frame. On the samples of more than 100 000 triangles 60 frames a second are ${rate(surfaces)} million
vertices and ${bandwidth(surfaces)} GB a second, and that only on the way from the original to the first level; the ways behind it are a hundredth
of that.

## Which level is shown

By hand: the slider. By size: the coarsest level whose geometric error spans no more pixels than asked for, where the surface is nearest to the
camera (\`web/viewer/level-choice.ts\`). A coarser level is taken only once its error is 1.25 times below that, so that nothing flickers near the
limit; the way there takes 400 ms a level, and waits where a morph is not yet ready to draw (\`web/element/level-motion.ts\`).
`;
}

const stepNames = percents.map((_, level) => `${level} → ${level + 1}`);

/** A line for each step of each surface. */
function table(head: string[], surfaces: WatchedSurface[], line: (surface: WatchedSurface, step: number) => string[]) {
  const lines = surfaces.flatMap((surface) => stepNames.map((name, i) => [surface.name, name, ...line(surface, i)]));
  return markdownTable(['surface', 'step', ...head], lines, 2);
}

function sizeTable(surfaces: WatchedSurface[]): string {
  const columns = ({ finer, coarser, pieces }: WatchedStep) => [
    `${finer} → ${coarser}`,
    `${pieces}`,
    (pieces / finer).toFixed(2),
  ];
  return table(
    ['chosen: triangles', 'pieces', 'factor', 'laid out: triangles', 'pieces', 'factor'],
    surfaces,
    ({ chosen, laidOut }, i) => [...columns(chosen[i]), ...columns(laidOut[i])],
  );
}

function seenTable(surfaces: WatchedSurface[]): string {
  const columns = ({ folded, pieces, seen: { usual, most, detour, backs } }: WatchedStep) => [
    percent(folded / pieces, 1),
    `${percent(usual)}, ${percent(most)}`,
    detour.toFixed(1),
    backs ? percent(backs.folds) : '',
    backs ? `${backs.holes}` : '',
  ];
  const head = ['folded pieces', 'changed', 'detour', 'folds seen', 'holes'];
  return table(
    [
      ...head.map((title, i) => (i === 0 ? `chosen: ${title}` : title)),
      ...head.map((title, i) => (i === 0 ? `laid out: ${title}` : title)),
    ],
    surfaces,
    ({ chosen, laidOut }, i) => [...columns(chosen[i]), ...columns(laidOut[i])],
  );
}

function drawTable(surfaces: WatchedSurface[]): string {
  return table(['draw calls', 'vertices', 'MB'], surfaces, ({ chosen }, i) => {
    const { calls, vertices, bytes } = chosen[i];
    return [`${calls}`, `${vertices}`, (bytes / 1e6).toFixed(1)];
  });
}

function percent(share: number, digits = 2): string {
  return `${(100 * share).toFixed(digits)} %`;
}

/** From the smallest to the largest. */
function spanText(numbers: number[], text: (number: number) => string): string {
  return `${text(Math.min(...numbers))} to ${text(Math.max(...numbers))}`;
}

function leaves(surfaces: WatchedSurface[]): string {
  const shares = surfaces.map(
    ({ chosen, laidOut }) => chosen[chosen.length - 1].coarser / laidOut[laidOut.length - 1].coarser,
  );
  return spanText(shares, (share) => percent(share, 0));
}

function foldsOf(surfaces: WatchedSurface[], freedom: 'chosen' | 'laidOut'): string {
  const shares = surfaces.flatMap((surface) => surface[freedom].map(({ folded, pieces }) => folded / pieces));
  return spanText(shares, (share) => percent(share, 1));
}

function mostChanged(surfaces: WatchedSurface[]): number {
  return Math.max(...surfaces.flatMap(({ chosen }) => chosen.map(({ seen }) => seen.most)));
}

function longerDetour(surfaces: WatchedSurface[]): string {
  const longer = surfaces.flatMap(({ chosen, laidOut }) =>
    chosen.map(({ seen }, i) => seen.detour - laidOut[i].seen.detour),
  );
  return Math.max(...longer).toFixed(1);
}

function heaviest(surfaces: WatchedSurface[]): WatchedStep {
  const steps = surfaces.flatMap(({ chosen }) => chosen);
  return steps.reduce((most, step) => (step.vertices > most.vertices ? step : most));
}

function rate(surfaces: WatchedSurface[]): string {
  return ((60 * heaviest(surfaces).vertices) / 1e6).toFixed(0);
}

function bandwidth(surfaces: WatchedSurface[]): string {
  return ((60 * heaviest(surfaces).bytes) / 1e9).toFixed(1);
}
