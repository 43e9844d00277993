import bunny from 'bunny';

import type { Mesh } from '../../wasm/types.ts';

type Point = [number, number, number];

const smoothings = 3;
/** The wave's length, as a fraction of the bunny's height, and its direction. */
const waveLength = 0.25;
const waveDirection: Point = [0.6, 0.64, 0.48];

/**
 * The Stanford bunny of the npm package, vertices at one place welded into one, with three variables at its vertices:
 *
 * - curvature: the mean over the neighbours u of 2 n · (p − u) / |p − u|², n the vertex normal (the normals of its
 *   triangles weighted by area), then three times replaced by the mean of itself and its neighbours' mean: 1 / unit length
 * - height: y
 * - wave: sin(2π d · p / λ) with d = (0.6, 0.64, 0.48) and λ a quarter of the bunny's height
 */
export function bunnyMesh(): Mesh {
  const { points, triangles } = welded();
  const neighbours = neighboursOf(points.length, triangles);
  const normals = normalsOf(points, triangles);
  const heights = points.map((point) => point[1]);
  const length = waveLength * (heights.reduce((a, b) => Math.max(a, b)) - heights.reduce((a, b) => Math.min(a, b)));
  let curvature = points.map((_, vertex) => curvatureAt(vertex, points, normals[vertex], neighbours[vertex]));
  for (let round = 0; round < smoothings; round++) curvature = smoothed(curvature, neighbours);
  const wave = points.map((point) => Math.sin((2 * Math.PI * dot(waveDirection, point)) / length));
  return {
    position: Float32Array.from(points.flat()),
    triangles: Uint32Array.from(triangles.flat()),
    variables: Object.entries({ curvature, height: heights, wave }).map(([name, values]) => ({
      name,
      components: 1,
      values: Float32Array.from(values),
    })),
  };
}

function welded(): { points: Point[]; triangles: Point[] } {
  const places = new Map<string, number>();
  const points: Point[] = [];
  const renumbered = bunny.positions.map((point) => {
    const key = point.join(' ');
    const place = places.get(key) ?? points.push(point) - 1;
    places.set(key, place);
    return place;
  });
  const triangles = bunny.cells.map((cell): Point => [renumbered[cell[0]], renumbered[cell[1]], renumbered[cell[2]]]);
  return { points, triangles: triangles.filter(([a, b, c]) => a !== b && b !== c && c !== a) };
}

function neighboursOf(vertices: number, triangles: Point[]): number[][] {
  const sets = Array.from({ length: vertices }, () => new Set<number>());
  for (const [a, b, c] of triangles) {
    sets[a].add(b).add(c);
    sets[b].add(c).add(a);
    sets[c].add(a).add(b);
  }
  return sets.map((set) => [...set]);
}

function normalsOf(points: Point[], triangles: Point[]): Point[] {
  const normals = points.map((): Point => [0, 0, 0]);
  for (const triangle of triangles) {
    const [a, b, c] = triangle.map((vertex) => points[vertex]);
    const normal = cross(minus(b, a), minus(c, a));
    for (const vertex of triangle) normals[vertex] = normals[vertex].map((n, axis) => n + normal[axis]) as Point;
  }
  return normals.map((normal) => normal.map((n) => n / (Math.hypot(...normal) || 1)) as Point);
}

function curvatureAt(vertex: number, points: Point[], normal: Point, neighbours: number[]): number {
  const along = neighbours.map((neighbour) => {
    const edge = minus(points[vertex], points[neighbour]);
    return (2 * dot(normal, edge)) / dot(edge, edge);
  });
  return mean(along);
}

function smoothed(values: number[], neighbours: number[][]): number[] {
  return values.map((value, vertex) => (value + mean(neighbours[vertex].map((neighbour) => values[neighbour]))) / 2);
}

function mean(values: number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / Math.max(1, values.length);
}

function minus(a: Point, b: Point): Point {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function dot(a: Point, b: Point): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Point, b: Point): Point {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
