import type { Mesh } from '../../../wasm/types.ts';
import { placesOf } from './weld.ts';

type Shape = Pick<Mesh, 'position' | 'triangles'>;

/** Two points in different places, the lower number first, and how far they are apart. */
export interface NearPair {
  one: number;
  other: number;
  distance: number;
}

/** So many pairs are looked at for each point: where more are near, the distance is no rounding but as large as triangles. */
const mostNeighbours = 64;

/** A pair farther apart than this fraction of the shortest edge at either is no crack, and made one it would fold triangles up. */
const ofShortestEdge = 0.25;

/**
 * Which points at ends of sheets lie no farther than `within` from others, but not in one place, and are far nearer than edges are
 * long there: each place once, by its first point. Undefined where so many are near that the distance says nothing.
 */
export function nearEnds({ position, triangles }: Shape, within: number): NearPair[] | undefined {
  const points = position.length / 3;
  if (!(within > 0) || !openPoints(triangles, points).includes(1)) return [];
  // Sheets that end in one place do not end there together.
  const places = placesOf(position);
  const corners = triangles.map((corner) => places[corner]);
  const open = openPoints(corners, points);
  const ends = places.filter((place, point) => place === point && open[point] === 1);
  const pairs = pairsWithin(position, ends, within);
  return pairs && shorterThanEdges(pairs, position, corners);
}

/**
 * Marks points around which triangles do not close, and all where they face different ways. At a point inside a sheet each
 * neighbour is once the next and once the last corner, so hashes of neighbours, added and taken away, cancel out.
 */
function openPoints(triangles: Uint32Array, points: number): Uint8Array {
  const sums = new Int32Array(points);
  for (let at = 0; at < triangles.length; at += 3) {
    const [a, b, c] = [triangles[at], triangles[at + 1], triangles[at + 2]];
    if (a === b || b === c || c === a) continue;
    const [ha, hb, hc] = [hash(a), hash(b), hash(c)];
    sums[a] += hb - hc;
    sums[b] += hc - ha;
    sums[c] += ha - hb;
  }
  return Uint8Array.from(sums, (sum) => (sum === 0 ? 0 : 1));
}

function hash(point: number): number {
  const mixed = Math.imul(point + 1, 0x9e3779b1);
  return Math.imul(mixed ^ (mixed >>> 15), 0x85ebca77) | 0;
}

/** A direction that no usual surface is square to. */
const across = [0.5401, 0.3217, 0.7777];

/** Sorted along a direction, near points are near in order as well. */
function pairsWithin(position: Mesh['position'], ends: Uint32Array, within: number): NearPair[] | undefined {
  const along = (point: number) =>
    across[0] * position[3 * point] + across[1] * position[3 * point + 1] + across[2] * position[3 * point + 2];
  const order = ends.slice().sort((one, other) => along(one) - along(other));
  const keys = Float64Array.from(order, along);
  const pairs: NearPair[] = [];
  let budget = mostNeighbours * order.length;
  for (let i = 0; i < order.length; i++) {
    for (let j = i + 1; j < order.length && keys[j] - keys[i] <= within; j++) {
      if (--budget < 0) return undefined;
      const distance = distanceOf(position, order[i], order[j]);
      const [one, other] = [Math.min(order[i], order[j]), Math.max(order[i], order[j])];
      if (distance <= within) pairs.push({ one, other, distance });
    }
  }
  return pairs;
}

export function distanceOf(position: Mesh['position'], one: number, other: number): number {
  return Math.hypot(...[0, 1, 2].map((axis) => position[3 * one + axis] - position[3 * other + axis]));
}

function shorterThanEdges(pairs: NearPair[], position: Mesh['position'], corners: Uint32Array): NearPair[] {
  if (pairs.length === 0) return pairs;
  const shortest = new Map(pairs.flatMap(({ one, other }) => [one, other]).map((point) => [point, Infinity]));
  const note = (from: number, to: number) => {
    const known = shortest.get(from);
    if (known === undefined || from === to) return;
    shortest.set(from, Math.min(known, distanceOf(position, from, to)));
  };
  for (let at = 0; at < corners.length; at++) {
    const next = corners[at % 3 === 2 ? at - 2 : at + 1];
    note(corners[at], next);
    note(next, corners[at]);
  }
  const edge = (point: number) => shortest.get(point) ?? 0;
  return pairs.filter(({ one, other, distance }) => distance <= ofShortestEdge * Math.min(edge(one), edge(other)));
}
