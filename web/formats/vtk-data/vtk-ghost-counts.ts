import { type Polygons, trianglesIn } from '../faces/polygons.ts';
import { counted } from '../text/wording.ts';

/** What was left out of a piece. */
export interface Ghosts {
  polygons: number;
  strips: number;
  points: number;
}

/** What is to be said of the ghosts of all pieces: a sentence, or none. */
export function ghostNotes(pieces: { ghosts?: Ghosts }[]): string[] {
  const sum = (count: (ghosts: Ghosts) => number) =>
    pieces.reduce((total, { ghosts }) => total + (ghosts ? count(ghosts) : 0), 0);
  const [cells, points] = [sum(({ polygons, strips }) => polygons + strips), sum(({ points }) => points)];
  const parts = [
    ...(cells > 0 ? [counted(cells, 'ghost cell')] : []),
    ...(points > 0 ? [counted(points, 'ghost point')] : []),
  ];
  return parts.length > 0
    ? [`${parts.join(' and ')} left out: other cells or pieces have their places, or they are hidden.`]
    : [];
}

/** How many cells make triangles, and how many have too few corners for that and are no ghosts. */
export function countCells({ ends }: Polygons, ghosts: number): { full: number; short: number } {
  let full = 0;
  ends.forEach((end, cell) => {
    if (trianglesIn(end - (cell > 0 ? ends[cell - 1] : 0)) > 0) full++;
  });
  return { full, short: ends.length - full - ghosts };
}
