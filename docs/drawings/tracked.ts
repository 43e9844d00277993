import { closedStar } from './hole.ts';
import {
  around,
  arrow,
  between,
  clipped,
  dot,
  drawing,
  line,
  meeting,
  type Point,
  polygon,
  square,
  text,
} from './svg.ts';

/** A triangulated net, shaken in a way that is the same every time. */
function net(
  columns: number,
  rows: number,
  step: number,
  [left, top]: Point,
): { points: Point[]; edges: [number, number][] } {
  const index = (i: number, j: number) => j * (columns + 1) + i;
  const points: Point[] = [];
  const edges: [number, number][] = [];
  for (let j = 0; j <= rows; j++) {
    for (let i = 0; i <= columns; i++) {
      const shake = around([0, 0], 0.22 * step, 137 * (i * 7 + j * 13));
      points.push([left + i * step + 0.5 * j * step + shake[0], top + j * step * 0.88 + shake[1]]);
      if (i > 0) edges.push([index(i - 1, j), index(i, j)]);
      if (j > 0) edges.push([index(i, j - 1), index(i, j)]);
      if (i < columns && j > 0) edges.push([index(i, j), index(i + 1, j - 1)]);
    }
  }
  return { points, edges };
}

/** Two current triangles with all that is tracked on them. */
export function state(): string {
  const { points, edges } = net(9, 6, 46, [-40, 42]);
  const at = (i: number, j: number) => points[j * 10 + i];
  const kept = [at(1, 5), at(6, 6), at(7, 1), at(3, 0)];
  const sides: [Point, Point][] = kept.map((point, i) => [point, kept[(i + 1) % 4]]);
  const diagonal: [Point, Point] = [kept[0], kept[2]];
  const inside = (p: Point) =>
    sides.every(([a, b]) => (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) < 0) && !kept.includes(p);
  const parts = edges.map(([a, b]) => clipped([points[a], points[b]], kept)).filter((part) => part.length > 1);
  const crossings = edges.flatMap(([a, b]) =>
    [...sides, diagonal].flatMap(([p, q]) => {
      if (kept.includes(points[a]) || kept.includes(points[b])) return [];
      const share = meeting(points[a], points[b], p, q);
      return share === undefined ? [] : [between(points[a], points[b], share)];
    }),
  );
  const fromKept = edges.flatMap(([a, b]) => {
    const share = meeting(points[a], points[b], ...diagonal);
    const leaves = kept.includes(points[a]) || kept.includes(points[b]);
    return leaves && share !== undefined ? [between(points[a], points[b], share)] : [];
  });
  return drawing(
    760,
    350,
    'Two current triangles with the removed vertices and the crossings that are tracked on them',
    [
      polygon('fill-blue veil', [kept[0], kept[1], kept[2]]),
      polygon('fill-green veil', [kept[0], kept[2], kept[3]]),
      ...parts.map((part) => line('soft', part[0], part[1])),
      ...sides.map((side) => line('line bold', ...side)),
      line('line bold', ...diagonal),
      ...points.filter(inside).map((point) => dot('hollow', point, 4)),
      ...[...crossings, ...fromKept].map((point) => square('fill-orange', point, 6)),
      ...kept.map((point) => dot('fill-ink', point, 5)),
      dot('fill-ink', [470, 80], 5),
      text('', [486, 84], 'kept vertex: maps to itself'),
      dot('hollow', [470, 118], 4),
      text('', [486, 122], 'removed vertex: (triangle, barycentric)'),
      square('fill-orange', [470, 156], 6),
      text('', [486, 160], 'crossing: (original edge, s,'),
      text('', [486, 178], 'current edge, t, direction)'),
      line('line bold', [458, 206], [480, 206]),
      text('', [486, 210], 'current edge'),
      line('soft', [458, 238], [480, 238]),
      text('', [486, 242], 'image of an original edge'),
    ],
  );
}

/** One removal: spoke crossings go, ring crossings stay, pieces are laid through the tree of the new triangles. */
export function removal(): string {
  const before = closedStar([185, 195]);
  const after = closedStar([565, 195]);
  const offset: Point = [380, 0];
  const moved = ([x, y]: Point): Point => [x + offset[0], y + offset[1]];
  const rim = (i: number, share: number) => between(before.ring[i], before.ring[(i + 1) % 7], share);
  const entry = rim(4, 0.45);
  const exit = rim(0, 0.5);
  const resident: Point = [128, 168];
  const leave = rim(2, 0.4);
  const spokeCrossings = (from: Point, to: Point) =>
    before.ring.flatMap((tip) => {
      const share = meeting(from, to, before.candidate, tip);
      return share === undefined ? [] : [between(from, to, share)];
    });
  const diagonalCrossings = (from: Point, to: Point) =>
    after.diagonals
      .flatMap(([a, b]) => {
        const share = meeting(from, to, after.ring[a], after.ring[b]);
        return share === undefined ? [] : [share];
      })
      .sort((a, b) => a - b)
      .map((share) => between(from, to, share));
  const chosen: Point = [moved(resident)[0] + 52, moved(resident)[1] - 14];
  const straight = diagonalCrossings(moved(entry), moved(exit));
  return drawing(760, 370, 'One removal with the map tracked, before and after', [
    text('title middle', [185, 28], 'before: the star'),
    text('title middle', [565, 28], 'after: the new triangles'),
    polygon('fill-blue veil', before.ring),
    polygon('fill-green veil', after.ring),
    ...before.ring.map((tip) => line('soft', before.candidate, tip)),
    line('line', ...before.ring, before.ring[0]),
    line('line', ...after.ring, after.ring[0]),
    ...after.diagonals.map(([a, b]) => line('line green bold', after.ring[a], after.ring[b])),
    line('line orange', entry, exit),
    line('line violet', resident, leave),
    line('line violet', resident, before.candidate),
    ...[...spokeCrossings(entry, exit), ...spokeCrossings(resident, leave)].map((point) =>
      square('hollow orange', point),
    ),
    line('line orange', moved(entry), ...straight, moved(exit)),
    line('line violet', chosen, ...diagonalCrossings(chosen, moved(leave)), moved(leave)),
    line('line violet', chosen, after.candidate),
    ...straight.map((point) => square('fill-orange', point)),
    ...diagonalCrossings(chosen, moved(leave)).map((point) => square('fill-orange', point)),
    arrow('soft dashed', moved(resident), chosen),
    ...[entry, exit, leave].flatMap((point) => [square('fill-ink', point), square('fill-ink', moved(point))]),
    ...[...before.ring, ...after.ring].map((point) => dot('fill-ink', point)),
    dot('hollow', before.candidate, 5),
    dot('hollow', after.candidate, 5),
    dot('hollow', resident, 4.5),
    dot('soft', moved(resident), 4.5),
    dot('hollow', chosen, 4.5),
    text(
      'small soft-text middle',
      [380, 342],
      'filled squares: crossings on the ring, which stay · hollow: on spokes, which go · orange: new ones on diagonals',
    ),
    text(
      'small soft-text middle',
      [380, 360],
      'dashed: a removed vertex takes a place with a smaller error than the layout’s',
    ),
  ]);
}
