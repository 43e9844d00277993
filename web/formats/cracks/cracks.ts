import type { Mesh, Variable } from '../../../wasm/types.ts';
import { spanOf } from '../../surface/value-span.ts';
import { FormatError } from '../format-error.ts';
import type { Surface } from '../surface.ts';
import { counted } from '../text/wording.ts';
import { distanceOf, type NearPair, nearEnds } from './near-ends.ts';
import { placesOf, withoutRepeated } from './weld.ts';

/** Ends of sheets nearer than this fraction of the extent were one before some program rounded them, each by a tenth of it. */
const rounding = 1e-6;

/** The surface with a note where sheets end beside each other within rounding. Nothing joins them, so a reduction may part them. */
export function withCrackNotes(surface: Surface): Surface {
  const pairs = nearEnds(surface.mesh, rounding * extentOf(surface.mesh)) ?? [];
  if (pairs.length === 0) return surface;
  const points = new Set(pairs.flatMap(({ one, other }) => [one, other])).size;
  const width = widestOf(pairs);
  const note =
    `A crack: ${counted(points, 'point')} where sheets end lie within ${rounding.toExponential()} of the extent of others, ` +
    `but not in one place; it is ${Number(width.toPrecision(3))} wide. A weld of 1e-6 joins it (command line: --weld 1e-6; element: weld=1e-6).`;
  return { ...surface, notes: [...surface.notes, note], crack: { note, weld: rounding } };
}

/** Of each point the nearest other one counts. */
function widestOf(pairs: NearPair[]): number {
  const nearest = new Map<number, number>();
  for (const { one, other, distance } of pairs) {
    for (const point of [one, other]) nearest.set(point, Math.min(distance, nearest.get(point) ?? Infinity));
  }
  return [...nearest.values()].reduce((widest, distance) => Math.max(widest, distance), 0);
}

/** The length of the diagonal of the box of the points that triangles use. */
function extentOf({ position, triangles }: Mesh): number {
  const lowest = [Infinity, Infinity, Infinity];
  const highest = lowest.map((each) => -each);
  for (const point of triangles) {
    for (let axis = 0; axis < 3; axis++) {
      const value = position[3 * point + axis];
      if (value < lowest[axis]) lowest[axis] = value;
      if (value > highest[axis]) highest[axis] = value;
    }
  }
  const extent = Math.hypot(...highest.map((each, axis) => each - lowest[axis]));
  return Number.isFinite(extent) ? extent : 0;
}

/**
 * Puts points where sheets end, and that lie within `fraction` of the extent of others, where the first of these lies. Where all variables agree
 * within the same fraction of their extents, the two are one point from here on, with the values of the first; else they are on a
 * seam. Throws where so many points are near that this would not close cracks but flatten the surface.
 */
export function withWeldedEnds(surface: Surface, fraction: number): Surface {
  const { mesh } = surface;
  const pairs = nearEnds(mesh, fraction * extentOf(mesh));
  if (!pairs) {
    const message = `A weld of ${fraction} of the extent reaches over whole triangles; cracks are narrower.`;
    throw new FormatError('bad_number', message, 'weld');
  }
  if (pairs.length === 0) return surface;
  const places = placesOf(mesh.position);
  const target = targetsOf(mesh, pairs, fraction * extentOf(mesh));
  const { position, farthest, moved } = movedPoints(mesh, places, target);
  const same = partnersOf({ ...mesh, position }, moved, fraction);
  const joined = withoutRepeated({ ...mesh, position }, same);
  const one = moved.filter((point) => same[point] !== point).length;
  const note =
    `${counted(moved.length, 'point')} where sheets end put where others lie, by ${Number(farthest.toPrecision(3))} at ` +
    `most; ${one === moved.length ? 'all' : one} of them became one with these.`;
  const labels = mesh.regions ? { regions: mesh.regions } : {};
  return { ...surface, mesh: { ...joined, ...labels }, notes: [...surface.notes, note] };
}

/** For each place that moves the one it goes to: nearest pairs first, and never farther than the distance asked for. */
function targetsOf({ position }: Mesh, pairs: NearPair[], within: number): Map<number, number> {
  const target = new Map<number, number>();
  const rootOf = (place: number): number => {
    let root = place;
    for (let next = target.get(root); next !== undefined; next = target.get(root)) root = next;
    return root;
  };
  for (const { one, other } of pairs.toSorted(
    (a, b) => a.distance - b.distance || a.one - b.one || a.other - b.other,
  )) {
    const [a, b] = [rootOf(one), rootOf(other)];
    const [root, mover] = [Math.min(a, b), Math.max(a, b)];
    if (root !== mover && distanceOf(position, root, mover) <= within) target.set(mover, root);
  }
  return new Map([...target.keys()].map((place) => [place, rootOf(place)]));
}

function movedPoints({ position }: Mesh, places: Uint32Array, target: Map<number, number>) {
  const places3 = position.slice();
  const moved: number[] = [];
  let farthest = 0;
  for (const [point, place] of places.entries()) {
    const to = target.get(place);
    if (to === undefined) continue;
    places3.set(position.subarray(3 * to, 3 * to + 3), 3 * point);
    farthest = Math.max(farthest, distanceOf(position, point, to));
    moved.push(point);
  }
  return { position: places3, farthest, moved };
}

/** For each point the one that it is the same as: for those that moved the first of their new place whose values are near. */
function partnersOf(mesh: Mesh, moved: number[], fraction: number): Uint32Array {
  const places = placesOf(mesh.position);
  const same = Uint32Array.from(places.keys());
  const taken = new Set(moved.map((point) => places[point]));
  const inPlace = new Map<number, number[]>();
  for (const [point, place] of places.entries()) {
    if (taken.has(place)) inPlace.set(place, [...(inPlace.get(place) ?? []), point]);
  }
  const limits = mesh.variables.map((variable) => fraction * spanOf(variable, mesh.triangles).extent);
  const agree = (one: number, other: number) =>
    mesh.variables.every((variable, i) => areNear(variable, one, other, limits[i]));
  for (const point of moved) {
    const first = inPlace.get(places[point])?.find((other) => same[other] === other && agree(other, point));
    if (first !== undefined && first < point) same[point] = first;
  }
  return same;
}

function areNear({ values, components }: Variable, one: number, other: number, limit: number): boolean {
  for (let i = 0; i < components; i++) {
    const [a, b] = [values[one * components + i], values[other * components + i]];
    if (!(Math.abs(a - b) <= limit || Object.is(a, b))) return false;
  }
  return true;
}
