import { closedStar } from './hole.ts';
import { between, clipped, dot, drawing, line, meeting, type Point, polygon, square, text } from './svg.ts';

const fills = ['fill-blue', 'fill-green', 'fill-orange', 'fill-violet', 'fill-soft'];

/** Old and new triangles overlap in pieces; errors need measuring at the corners of the pieces alone. */
export function mapping(): string {
  const { candidate, ring, triangles, diagonals } = closedStar([190, 190]);
  const pieces = triangles.flatMap((corners, n) =>
    ring.map((point, i) => {
      const sector = [candidate, point, ring[(i + 1) % ring.length]];
      return {
        fill: fills[n],
        points: clipped(
          corners.map((corner) => ring[corner]),
          sector,
        ),
      };
    }),
  );
  const crossings = diagonals.flatMap(([a, b]) =>
    ring.flatMap((tip) => {
      const share = meeting(candidate, tip, ring[a], ring[b]);
      return share === undefined ? [] : [between(candidate, tip, share)];
    }),
  );
  return drawing(760, 350, 'The pieces in which the old and the new triangles of a hole overlap', [
    text('title middle', [190, 28], 'pieces of the mutual projection'),
    ...pieces.filter(({ points }) => points.length > 2).map(({ fill, points }) => polygon(`${fill} veil`, points)),
    ...ring.map((tip) => line('soft', candidate, tip)),
    line('line', ...ring, ring[0]),
    ...diagonals.map(([a, b]) => line('line green bold', ring[a], ring[b])),
    ...ring.map((point) => dot('fill-ink', point)),
    ...crossings.map((point) => square('hollow green', point)),
    dot('hollow', candidate, 5),
    ...legend(
      [400, 105],
      [
        [line('soft', [0, 0], [26, 0]), 'a spoke: an old edge that goes'],
        [line('line green bold', [0, 0], [26, 0]), 'a diagonal: a new edge'],
        [square('hollow green', [13, 0]), 'where they cross: measured'],
        [dot('hollow', [13, 0], 5), 'the candidate: measured'],
        [dot('fill-ink', [13, 0]), 'a ring vertex: does not move, error 0'],
        [square('fill-blue veil', [13, 0], 16), 'one colour a new triangle; one patch a piece,'],
        ['', 'on which old and new values are both linear'],
      ],
    ),
  ]);
}

function legend([x, y]: Point, lines: [string, string][]): string[] {
  return lines.map(([sign, words], n) => {
    const top = y + 27 * n;
    return `<g transform="translate(${x} ${top})">${sign}</g>${text('', [x + 40, top + 4], words)}`;
  });
}

/** A diagonal seen from the side: the way over the star above, the diagonal below, cut at the same shares of their lengths. */
export function proportions(): string {
  const way: Point[] = [
    [60, 190],
    [190, 90],
    [330, 60],
    [420, 120],
    [530, 190],
  ];
  const steps = way.slice(1).map((point, i) => Math.hypot(point[0] - way[i][0], point[1] - way[i][1]));
  const total = steps.reduce((a, b) => a + b);
  const shares = steps.map((_, i) => steps.slice(0, i + 1).reduce((a, b) => a + b) / total).slice(0, -1);
  const onDiagonal = shares.map((share) => between([60, 250], [530, 250], share));
  return drawing(760, 300, 'A diagonal from the side: segments keep proportional lengths', [
    text('title', [60, 30], 'along a diagonal, seen from the side'),
    ...onDiagonal.map((point, i) => line('soft dashed', way[i + 1], point)),
    line('line', ...way),
    line('line green bold', [60, 250], [530, 250]),
    ...[way[0], way[4], [60, 250] as const, [530, 250] as const].map((point) => dot('fill-ink', point)),
    ...shares.map((_, i) => square('hollow green', way[i + 1])),
    ...onDiagonal.map((point) => square('hollow green', point)),
    text('', [552, 135], 'its way over the star'),
    text('small soft-text', [552, 153], 'corners where it crosses spokes'),
    text('', [552, 248], 'the diagonal'),
    text('small soft-text', [552, 266], 'cut at the same shares'),
    text(
      'small soft-text',
      [60, 285],
      'dashed: which points correspond; the difference there is what the removal introduces',
    ),
  ]);
}
