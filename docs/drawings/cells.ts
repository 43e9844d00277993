import { arrow, between, centre, dot, drawing, line, type Point, polygon, square, text } from './svg.ts';

/** A crossing on a side of the original triangle and where it lands. */
interface Corner {
  original: Point;
  reduced: Point;
}

/**
 * The proof in one picture: an original triangle, cut along chords between crossings of the same reduced edge; each cell
 * lands in one reduced triangle.
 */
export function cells(): string {
  const [a, b, c]: Point[] = [
    [60, 290],
    [310, 310],
    [170, 60],
  ];
  // The reduced triangles: a strip, whose first corner is the kept A.
  const [p, q, r, s, t]: Point[] = [
    [440, 300],
    [470, 80],
    [590, 325],
    [620, 60],
    [730, 280],
  ];
  const [imageB, imageC]: Point[] = [
    [668, 235],
    [575, 105],
  ];
  const corner = (from: Point, to: Point, along: number, low: Point, high: Point, across: number): Corner => ({
    original: between(from, to, along),
    reduced: between(low, high, across),
  });
  const one = corner(a, b, 0.42, q, r, 0.78);
  const two = corner(a, b, 0.74, r, s, 0.27);
  const three = corner(b, c, 0.4, r, s, 0.62);
  const four = corner(c, a, 0.42, q, r, 0.25);
  const parts: { fill: string; corners: Corner[] }[] = [
    { fill: 'fill-blue', corners: [{ original: a, reduced: p }, one, four] },
    { fill: 'fill-green', corners: [one, two, three, { original: c, reduced: imageC }, four] },
    { fill: 'fill-orange', corners: [two, { original: b, reduced: imageB }, three] },
  ];
  const numbered = [one, two, three, four].map(({ original }, i) => {
    const away = [
      [0, 22],
      [4, 22],
      [18, 0],
      [-14, -4],
    ][i];
    return text('middle', [original[0] + away[0], original[1] + away[1] + 3], String(i + 1));
  });
  return drawing(760, 360, 'An original triangle cut into cells, each of which lands in one reduced triangle', [
    text('title middle', [180, 30], 'an original triangle'),
    text('title middle', [590, 30], 'its image on the reduced surface'),
    ...parts.flatMap(({ fill, corners }) => [
      polygon(
        `${fill} veil`,
        corners.map(({ original }) => original),
      ),
      polygon(
        `${fill} veil`,
        corners.map(({ reduced }) => reduced),
      ),
    ]),
    line('line', a, b, c, a),
    line('line dashed', one.original, four.original),
    line('line dashed', two.original, three.original),
    line('soft bold', p, q, s, t, r, p),
    line('soft bold', q, r),
    line('soft bold', r, s),
    line('line', p, one.reduced, two.reduced, imageB, three.reduced, imageC, four.reduced, p),
    ...[one, two, three, four].flatMap(({ original, reduced }) => [
      square('fill-orange', original),
      square('fill-orange', reduced),
    ]),
    ...[p, q, r, s, t, a].map((point) => dot('fill-ink', point)),
    ...[b, c, imageB, imageC].map((point) => dot('hollow', point, 4.5)),
    ...numbered,
    text('middle', [a[0] - 14, a[1] + 14], 'A'),
    text('middle', [b[0] + 14, b[1] + 12], 'B'),
    text('middle', [c[0], c[1] - 10], 'C'),
    text('middle', [p[0], p[1] + 20], 'Φ(A) = A'),
    text('', [imageB[0] + 8, imageB[1] - 8], 'Φ(B)'),
    text('middle', [imageC[0] - 4, imageC[1] - 12], 'Φ(C)'),
    arrow('soft', [335, 190], [405, 190]),
    text('middle', [370, 180], 'Φ'),
    ...parts.map(({ corners }, i) =>
      text('small middle', centre(corners.map(({ original }) => original)), `K${i + 1}`),
    ),
    text(
      'small soft-text',
      [60, 346],
      'dashed: chords 1–4 and 2–3, the preimage of the two reduced edges that the outline crosses',
    ),
  ]);
}
