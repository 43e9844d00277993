import { closedStar, openStar, type Star } from './hole.ts';
import { between, centre, dot, drawing, line, type Point, polygon, text } from './svg.ts';

function labels({ candidate, ring }: Star): string[] {
  return ring.map((point, i) => {
    const [x, y] = between(candidate, point, 1.13);
    return text('middle', [x, y + 4], `r${i}`);
  });
}

function rims({ ring, open }: Star): string {
  return line('line', ...ring, ...(open ? [] : [ring[0]]));
}

/** The boundary of the surface at an open star, and the surface's end below it. */
function boundary({ candidate, ring }: Star): string {
  return line('line bold', ring[0], candidate, ring[ring.length - 1]);
}

/** The star of an interior and of a boundary candidate. */
export function star(): string {
  const [closed, open] = [closedStar([190, 190]), openStar([560, 250])];
  const sectors = (of: Star) =>
    of.ring.slice(0, of.open ? -1 : undefined).map((point, i) => {
      const [x, y] = centre([of.candidate, point, of.ring[(i + 1) % of.ring.length]]);
      return text('small soft-text middle', [x, y + 4], `s${i}`);
    });
  return drawing(760, 350, 'The star of an interior candidate, closed, and of a boundary candidate, open', [
    text('title middle', [190, 28], 'interior candidate: closed star'),
    text('title middle', [560, 28], 'boundary candidate: open star'),
    polygon('fill-blue veil', closed.ring),
    polygon('fill-blue veil', [open.candidate, ...open.ring]),
    ...[closed, open].flatMap((of) => [
      ...of.ring.map((point) => line('soft', of.candidate, point)),
      rims(of),
      ...(of.open ? [boundary(of)] : []),
      ...of.ring.map((point) => dot('fill-ink', point)),
      dot('hollow', of.candidate, 5),
      ...labels(of),
      ...sectors(of),
    ]),
    text('middle', [open.candidate[0], open.candidate[1] + 22], 'c'),
    text('', [closed.candidate[0] + 9, closed.candidate[1] + 17], 'c'),
    text('small soft-text middle', [560, 300], 'the boundary of the surface runs r4 → c → r0'),
    text(
      'small soft-text middle',
      [380, 338],
      'c candidate · r ring vertices · grey: spokes · s sectors (triangles of the star)',
    ),
  ]);
}

/** The new triangles of the hole, and the tree that they form across its diagonals. */
export function retriangulation(): string {
  const [closed, open] = [closedStar([190, 190]), openStar([560, 250])];
  const middles = (of: Star): Point[] => of.triangles.map((corners) => centre(corners.map((i) => of.ring[i])));
  const tree = (of: Star): string[] => {
    const places = middles(of);
    const links = of.diagonals.map(([a, b]) => {
      const sides = of.triangles.flatMap((corners, n) => (corners.includes(a) && corners.includes(b) ? [n] : []));
      return line('soft orange', places[sides[0]], between(of.ring[a], of.ring[b], 0.5), places[sides[1]]);
    });
    return [...links, ...places.map((at, n) => dot(n === 0 ? 'fill-orange' : 'hollow orange', at, 5))];
  };
  return drawing(760, 350, 'A retriangulation of both holes, with the tree of its triangles', [
    text('title middle', [190, 28], 'closed hole: k − 2 triangles for k corners'),
    text('title middle', [560, 28], 'open hole: the closing edge is new'),
    polygon('fill-green veil', closed.ring),
    polygon('fill-green veil', open.ring),
    ...[closed, open].flatMap((of) => [
      rims(of),
      ...of.diagonals.map(([a, b]) => line('line green bold', of.ring[a], of.ring[b])),
      ...(of.open ? [line('line green bold', of.ring[0], of.ring[4])] : []),
      ...tree(of),
      ...of.ring.map((point) => dot('fill-ink', point)),
      dot('hollow', of.candidate, 3.5),
      ...labels(of),
    ]),
    line('soft dashed', open.ring[0], open.candidate, open.ring[4]),
    text('small soft-text middle', [560, 285], 'c goes onto the closing edge r0 r4'),
    text(
      'small soft-text middle',
      [380, 338],
      'green: diagonals and closing edge · orange: the tree of the new triangles, its root filled',
    ),
  ]);
}
