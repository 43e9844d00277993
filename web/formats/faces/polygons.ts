import earcut from 'earcut';
import { FormatError } from '../format-error.ts';
import { capitalised, counted, grouped } from '../text/wording.ts';

/** Polygons of any number of corners: polygon i has the corners from `ends[i - 1]` up to `ends[i]`. */
export interface Polygons {
  corners: Uint32Array;
  ends: Uint32Array;
}

export const noPolygons: Polygons = { corners: new Uint32Array(), ends: new Uint32Array() };

type Position = Float32Array | Float64Array;
type Vector = [number, number, number];

/** Ear clipping is quadratic on hostile outlines; an honest face of a mesh has not nearly so many corners. */
const mostConcaveCorners = 2_000;
/** So much all of them together may take, as squares of their corners; small ones are quick however many there are. */
const mostConcaveWork = 100_000_000;
const smallPolygon = 64;

/** The fewest corners that make a surface. */
const fewestCorners = 3;

/**
 * Triangles in place of polygons, in their order and orientation; `split` counts the polygons that had more than three
 * corners, `short` those that had fewer, which are no surface and left out. `noun` names a polygon in messages ("face").
 * Throws on points that do not exist.
 */
export function triangulate(polygons: Polygons, position: Position, noun: string) {
  const { corners, ends } = polygons;
  checkCorners(polygons, position.length / 3, noun);
  let [total, split, short] = [0, 0, 0];
  forEachPolygon(ends, (start, end) => {
    if (end - start < fewestCorners) short++;
    else total += end - start - 2;
    if (end - start > fewestCorners) split++;
  });
  if (split + short === 0) return { triangles: corners, split, short };
  const triangles = new Uint32Array(3 * total);
  const budget = { work: mostConcaveWork };
  let at = 0;
  forEachPolygon(ends, (start, end, index) => {
    if (end - start < fewestCorners) return;
    const polygon = corners.subarray(start, end);
    triangles.set(
      polygon.length === fewestCorners ? polygon : splitPolygon(polygon, position, budget, `${noun} ${index}`),
      at,
    );
    at += 3 * (polygon.length - 2);
  });
  return { triangles, split, short };
}

/** What is to be said of polygons that triangulate changed or left out; `noun` is one of them ("face"). */
export function polygonNotes(noun: string, split: number, short: number): string[] {
  const notes: string[] = [];
  if (split > 0) notes.push(`${counted(split, noun)} with more than three corners split into triangles.`);
  if (short > 0) notes.push(`${counted(short, noun)} with fewer than three corners left out.`);
  return notes;
}

/** How many triangles triangulate makes of a polygon. */
export function trianglesIn(corners: number): number {
  return Math.max(0, corners - 2);
}

/** The same polygons, but those that are gone have no corners; so all others keep their numbers. */
export function emptied({ corners, ends }: Polygons, isGone: (index: number) => boolean): Polygons {
  const kept = new Uint32Array(corners.length);
  const newEnds = new Uint32Array(ends.length);
  let length = 0;
  forEachPolygon(ends, (start, end, index) => {
    if (!isGone(index)) {
      kept.set(corners.subarray(start, end), length);
      length += end - start;
    }
    newEnds[index] = length;
  });
  return { corners: kept.slice(0, length), ends: newEnds };
}

/**
 * Triangles in place of triangle strips; every other triangle of a strip is turned, so that all face the same way. A strip of
 * fewer than three corners is none.
 */
export function trianglesOfStrips(strips: Polygons, position: Position, noun: string): Uint32Array {
  const { corners, ends } = strips;
  checkCorners(strips, position.length / 3, noun);
  const triangles = new Uint32Array(3 * corners.length);
  let at = 0;
  forEachPolygon(ends, (start, end) => {
    for (let i = start; i + 2 < end; i++) {
      const turned = (i - start) % 2;
      triangles[at++] = corners[i];
      triangles[at++] = corners[i + 1 + turned];
      triangles[at++] = corners[i + 2 - turned];
    }
  });
  return triangles.slice(0, at);
}

function forEachPolygon(ends: Uint32Array, visit: (start: number, end: number, index: number) => void): void {
  let start = 0;
  for (let index = 0; index < ends.length; index++) {
    visit(start, ends[index], index);
    start = ends[index];
  }
}

/** Throws if a corner of what is a surface names a point that does not exist. */
export function checkCorners({ corners, ends }: Polygons, points: number, noun: string): void {
  if (!corners.some((corner) => corner >= points)) return;
  forEachPolygon(ends, (start, end, index) => {
    const wrong = corners.subarray(start, end).find((corner) => corner >= points);
    if (wrong !== undefined && end - start >= fewestCorners) throw badIndex(wrong, `${noun} ${index}`, points);
  });
}

/** The same for a list of indices that is one thing. */
export function checkIndices(indices: Uint32Array, points: number, where: string): void {
  const wrong = indices.find((index) => index >= points);
  if (wrong !== undefined) throw badIndex(wrong, where, points);
}

/** The error for a face that names a point that does not exist. */
function badIndex(corner: number, where: string, points: number): FormatError {
  const there = `the file has ${counted(points, 'point')}${points > 0 ? ` (0 to ${grouped(points - 1)})` : ''}`;
  return new FormatError('bad_index', `${capitalised(where)} names point ${corner}, but ${there}.`, where);
}

function splitPolygon(polygon: Uint32Array, position: Position, budget: { work: number }, where: string): Uint32Array {
  const normal = newellNormal(polygon, position);
  if (fanIsFaithful(polygon, position, normal)) return fan(polygon);
  if (polygon.length > smallPolygon) budget.work -= polygon.length ** 2;
  if (polygon.length > mostConcaveCorners || budget.work < 0) throw costly(polygon.length, budget.work < 0, where);
  return clipEars(polygon, position, normal) ?? fan(polygon);
}

function costly(corners: number, isOneOfMany: boolean, where: string): FormatError {
  const limit = isOneOfMany
    ? 'which is too much after all those before it'
    : `and no more than ${mostConcaveCorners} can be split`;
  return new FormatError('bad_polygon', `The concave ${where} has ${counted(corners, 'corner')}, ${limit}.`, where);
}

function fan(polygon: Uint32Array): Uint32Array {
  const triangles = new Uint32Array(3 * (polygon.length - 2));
  for (let i = 0; i + 2 < polygon.length; i++) triangles.set([polygon[0], polygon[i + 1], polygon[i + 2]], 3 * i);
  return triangles;
}

/** The normal of a polygon that need be neither convex nor quite plane; its length is twice the area. */
function newellNormal(polygon: Uint32Array, position: Position): Vector {
  const normal: Vector = [0, 0, 0];
  const origin = 3 * polygon[0];
  for (let i = 1; i + 1 < polygon.length; i++) {
    const part = cross(position, origin, 3 * polygon[i], 3 * polygon[i + 1]);
    for (let axis = 0; axis < 3; axis++) normal[axis] += part[axis];
  }
  return normal;
}

/** (b − a) × (c − a), where a, b and c are places in `position`. */
function cross(position: Position, a: number, b: number, c: number): Vector {
  const [ax, ay, az] = [position[a], position[a + 1], position[a + 2]];
  const [ux, uy, uz] = [position[b] - ax, position[b + 1] - ay, position[b + 2] - az];
  const [vx, vy, vz] = [position[c] - ax, position[c + 1] - ay, position[c + 2] - az];
  return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
}

/** Whether every triangle of the fan faces the polygon's way. Without a finite normal no other split is better. */
function fanIsFaithful(polygon: Uint32Array, position: Position, normal: Vector): boolean {
  if (!normal.every(Number.isFinite) || normal.every((part) => part === 0)) return true;
  const origin = 3 * polygon[0];
  for (let i = 1; i + 1 < polygon.length; i++) {
    const part = cross(position, origin, 3 * polygon[i], 3 * polygon[i + 1]);
    if (!(part[0] * normal[0] + part[1] * normal[1] + part[2] * normal[2] > 0)) return false;
  }
  return true;
}

/** Ear clipping in the plane that shows the polygon largest; undefined where the outline is too degenerate for it. */
function clipEars(polygon: Uint32Array, position: Position, normal: Vector): Uint32Array | undefined {
  const sizes = normal.map(Math.abs);
  const dropped = sizes.indexOf(Math.max(...sizes));
  const axes = [(dropped + 1) % 3, (dropped + 2) % 3];
  const flat = Array.from(polygon).flatMap((corner) => axes.map((axis) => position[3 * corner + axis]));
  const ears = earcut(flat);
  if (ears.length !== 3 * (polygon.length - 2)) return undefined;
  const turned = flatArea(flat, ears) > 0 !== normal[dropped] > 0;
  const triangles = Uint32Array.from(ears, (corner) => polygon[corner]);
  if (turned) triangles.reverse();
  return triangles;
}

/** Twice the area of triangles in the plane, negative if they face the other way. */
function flatArea(flat: number[], ears: number[]): number {
  let area = 0;
  for (let i = 0; i < ears.length; i += 3) {
    const [a, b, c] = [2 * ears[i], 2 * ears[i + 1], 2 * ears[i + 2]];
    const [ux, uy] = [flat[b] - flat[a], flat[b + 1] - flat[a + 1]];
    const [vx, vy] = [flat[c] - flat[a], flat[c + 1] - flat[a + 1]];
    area += ux * vy - vx * uy;
  }
  return area;
}
