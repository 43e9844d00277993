/** A place in a drawing, in pixels, y running down. */
export type Point = readonly [number, number];

/**
 * One palette for all drawings. Each has its own background, so that it can be read on any page; in a dark browser the
 * colours turn with it.
 */
const style = `
  svg { --paper: #ffffff; --ink: #1f2328; --soft: #8c959f; --blue: #0969da; --green: #1a7f37; --orange: #bc4c00; --violet: #8250df; }
  @media (prefers-color-scheme: dark) {
    svg { --paper: #161b22; --ink: #e6edf3; --soft: #7d8590; --blue: #58a6ff; --green: #3fb950; --orange: #f0883e; --violet: #bc8cff; }
  }
  text { font: 13px system-ui, sans-serif; fill: var(--ink); }
  .title { font-weight: 600; }
  .small { font-size: 11.5px; }
  .soft-text { fill: var(--soft); }
  .middle { text-anchor: middle; }
  .end { text-anchor: end; }
  .paper { fill: var(--paper); }
  .line { fill: none; stroke: var(--ink); stroke-width: 1.5; }
  .soft { fill: none; stroke: var(--soft); stroke-width: 1.2; }
  .dashed { stroke-dasharray: 5 4; }
  .bold { stroke-width: 2.6; }
  .blue { stroke: var(--blue); } .green { stroke: var(--green); } .orange { stroke: var(--orange); } .violet { stroke: var(--violet); }
  .fill-blue { fill: var(--blue); } .fill-green { fill: var(--green); } .fill-orange { fill: var(--orange); }
  .fill-violet { fill: var(--violet); } .fill-ink { fill: var(--ink); } .fill-soft { fill: var(--soft); }
  .veil { fill-opacity: 0.18; stroke: none; }
  .hollow { fill: var(--paper); stroke: var(--ink); stroke-width: 1.5; }
`;

/** A whole drawing, with the sentence that stands for it where it cannot be seen. */
export function drawing(width: number, height: number, description: string, parts: string[]): string {
  const head = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" role="img">`;
  const paper = `<rect class="paper" width="${width}" height="${height}" rx="8"/>`;
  return [head, `<title>${description}</title>`, `<style>${style}</style>`, paper, ...parts, '</svg>', ''].join('\n');
}

function digits(value: number): string {
  return String(Math.round(10 * value) / 10);
}

function place([x, y]: Point): string {
  return `${digits(x)},${digits(y)}`;
}

export function line(classes: string, ...points: Point[]): string {
  return `<polyline class="${classes}" points="${points.map(place).join(' ')}"/>`;
}

export function polygon(classes: string, points: readonly Point[]): string {
  return `<polygon class="${classes}" points="${points.map(place).join(' ')}"/>`;
}

export function dot(classes: string, [x, y]: Point, radius = 3.5): string {
  return `<circle class="${classes}" cx="${digits(x)}" cy="${digits(y)}" r="${radius}"/>`;
}

export function square(classes: string, [x, y]: Point, side = 7): string {
  return `<rect class="${classes}" x="${digits(x - side / 2)}" y="${digits(y - side / 2)}" width="${side}" height="${side}"/>`;
}

export function box(classes: string, [x, y]: Point, width: number, height: number): string {
  return `<rect class="${classes}" x="${digits(x)}" y="${digits(y)}" width="${digits(width)}" height="${digits(height)}" rx="6"/>`;
}

export function text(classes: string, [x, y]: Point, words: string): string {
  return `<text class="${classes}" x="${digits(x)}" y="${digits(y)}">${words}</text>`;
}

/** A straight line with a head at its end. */
export function arrow(classes: string, from: Point, to: Point): string {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const scale = 8 / Math.hypot(dx, dy);
  const back = (side: number): Point => [
    to[0] - scale * (dx - side * 0.45 * dy),
    to[1] - scale * (dy + side * 0.45 * dx),
  ];
  return line(classes, from, to) + line(classes, back(1), to, back(-1));
}

export function between(p: Point, q: Point, share: number): Point {
  return [p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])];
}

export function centre(points: readonly Point[]): Point {
  const sum = points.reduce(([x, y], [u, v]) => [x + u, y + v] as const, [0, 0] as Point);
  return [sum[0] / points.length, sum[1] / points.length];
}

export function shifted(points: readonly Point[], [dx, dy]: Point): Point[] {
  return points.map(([x, y]) => [x + dx, y + dy]);
}

/** On the circle around a centre, counter-clockwise as one sees it from 3 o'clock on. */
export function around([x, y]: Point, radius: number, degrees: number): Point {
  const angle = (degrees * Math.PI) / 180;
  return [x + radius * Math.cos(angle), y - radius * Math.sin(angle)];
}

/** Twice the signed area of p, q, r. */
function turn(p: Point, q: Point, r: Point): number {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

/** Where two segments meet, as the share of the first; undefined where they do not. */
export function meeting(p: Point, q: Point, a: Point, b: Point): number | undefined {
  const [before, behind] = [turn(a, b, p), turn(a, b, q)];
  const [left, right] = [turn(p, q, a), turn(p, q, b)];
  if (before * behind >= 0 || left * right >= 0) return undefined;
  return before / (before - behind);
}

/** The part of one convex polygon that lies in another one. */
export function clipped(polygonPoints: readonly Point[], by: readonly Point[]): Point[] {
  const side = Math.sign(turn(by[0], by[1], by[2]));
  return by.reduce<Point[]>(
    (rest, a, i) => {
      const b = by[(i + 1) % by.length];
      const inside = (p: Point) => side * turn(a, b, p) >= 0;
      return rest.flatMap((p, j) => {
        const q = rest[(j + 1) % rest.length];
        const cut = turn(a, b, p) / (turn(a, b, p) - turn(a, b, q));
        return [...(inside(p) ? [p] : []), ...(inside(p) !== inside(q) ? [between(p, q, cut)] : [])];
      });
    },
    [...polygonPoints],
  );
}
