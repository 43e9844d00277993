import type { Vector3 } from 'three';
import { ExtendedTriangle } from 'three-mesh-bvh';
import type { Mesh } from '../../wasm/types.ts';
import { Partition } from './partition.ts';
import { properTriangles, usedPoints } from './used-points.ts';

type Shape = Pick<Mesh, 'position' | 'triangles'>;

/** Six numbers a box: the lowest corner, then the highest. */
const boxSize = 6;

/** So many pairs of boxes are compared for each triangle before the search is given up: it must not take longer than a reduction. */
const mostPairs = 32;

/**
 * Whether two parts of a surface, which share no place, come as near to each other as `within`: exactly, from triangle to
 * triangle. Of a part that is folded upon itself it knows nothing. Undefined where so many triangles are near each other that the answer would take too
 * long; else time grows as sorting does.
 */
export function havePartsWithin({ position, triangles }: Shape, within: number): boolean | undefined {
  if (!(within > 0) || !Number.isFinite(within)) return false;
  const mesh = { position, triangles: properTriangles(triangles) };
  const parts = partsOf(mesh);
  if (!parts) return false;
  const boxes = trianglesBoxes(mesh);
  const near = trianglesNearOtherParts(parts, boxes, within);
  return anyPair(mesh, near, parts, boxes, within);
}

/** For each triangle the number of its part; undefined where there is only one. */
function partsOf({ position, triangles }: Shape): Uint32Array | undefined {
  const joined = new Partition(position.length / 3);
  for (let at = 0; at < triangles.length; at += 3) {
    joined.join(triangles[at], triangles[at + 1]);
    joined.join(triangles[at], triangles[at + 2]);
  }
  if (isOne(joined, triangles)) return undefined;
  joinSamePlaces(joined, position, usedPoints(triangles, position.length / 3));
  if (isOne(joined, triangles)) return undefined;
  return Uint32Array.from({ length: triangles.length / 3 }, (_, triangle) => joined.root(triangles[3 * triangle]));
}

function isOne(joined: Partition, triangles: Uint32Array): boolean {
  const first = triangles.length > 0 ? joined.root(triangles[0]) : 0;
  for (let at = 0; at < triangles.length; at += 3) if (joined.root(triangles[at]) !== first) return false;
  return true;
}

const none = 0xffffffff;

/** Joins the used points that lie in one place: open addressing by a hash of their coordinates, at most half full. */
function joinSamePlaces(joined: Partition, position: Mesh['position'], used: Uint8Array): void {
  const points = position.length / 3;
  const slots = 2 ** Math.ceil(Math.log2(2 * points + 2));
  const table = new Uint32Array(slots).fill(none);
  const isSame = (one: number, other: number) =>
    position[3 * one] === position[3 * other] &&
    position[3 * one + 1] === position[3 * other + 1] &&
    position[3 * one + 2] === position[3 * other + 2];
  for (let point = 0; point < points; point++) {
    if (!used[point]) continue;
    let slot = hashOf(position, 3 * point) & (slots - 1);
    while (table[slot] !== none && !isSame(table[slot], point)) slot = (slot + 1) & (slots - 1);
    if (table[slot] === none) table[slot] = point;
    else joined.join(point, table[slot]);
  }
}

const scratch = new Float64Array(3);
const halves = new Uint32Array(scratch.buffer);

function hashOf(position: Mesh['position'], at: number): number {
  // Adding 0 makes 0 of −0.
  for (let axis = 0; axis < 3; axis++) scratch[axis] = position[at + axis] + 0;
  let mixed = 0;
  for (let half = 0; half < halves.length; half++) {
    mixed = Math.imul(mixed ^ halves[half], 0x9e3779b1);
    mixed ^= mixed >>> 15;
  }
  return mixed >>> 0;
}

function trianglesBoxes({ position, triangles }: Shape): Float64Array {
  const boxes = new Float64Array(2 * triangles.length);
  for (let triangle = 0; 3 * triangle < triangles.length; triangle++) {
    const [a, b, c] = [triangles[3 * triangle], triangles[3 * triangle + 1], triangles[3 * triangle + 2]];
    for (let axis = 0; axis < 3; axis++) {
      const [x, y, z] = [position[3 * a + axis], position[3 * b + axis], position[3 * c + axis]];
      boxes[boxSize * triangle + axis] = Math.min(x, y, z);
      boxes[boxSize * triangle + 3 + axis] = Math.max(x, y, z);
    }
  }
  return boxes;
}

/** Triangles whose box comes within the distance of the box of another part: most parts are apart as a whole. */
function trianglesNearOtherParts(parts: Uint32Array, boxes: Float64Array, within: number): Uint32Array {
  const ofParts = new Map<number, Float64Array>();
  parts.forEach((part, triangle) => {
    const whole = ofParts.get(part);
    const box = boxes.subarray(boxSize * triangle, boxSize * (triangle + 1));
    if (!whole) ofParts.set(part, box.slice());
    else
      for (let axis = 0; axis < 3; axis++) {
        whole[axis] = Math.min(whole[axis], box[axis]);
        whole[3 + axis] = Math.max(whole[3 + axis], box[3 + axis]);
      }
  });
  const numbers = [...ofParts.keys()];
  const wholes = joinedBoxes([...ofParts.values()]);
  const partners = new Map<number, Float64Array[]>();
  // Where there are too many pairs of parts, each is looked at.
  const complete = forEachNear(
    wholes,
    Uint32Array.from(numbers.keys()),
    within,
    mostPairs * numbers.length,
    (one, other) => {
      for (const [from, to] of [
        [one, other],
        [other, one],
      ]) {
        const box = wholes.subarray(boxSize * to, boxSize * (to + 1));
        partners.set(numbers[from], [...(partners.get(numbers[from]) ?? []), box]);
      }
      return false;
    },
  );
  const isNear = (triangle: number) =>
    partners.get(parts[triangle])?.some((box) => areNear(boxes, triangle, box, 0, within)) ?? false;
  const all = Uint32Array.from(parts.keys());
  return complete ? all.filter(isNear) : all;
}

function joinedBoxes(boxes: Float64Array[]): Float64Array {
  const all = new Float64Array(boxSize * boxes.length);
  for (const [index, box] of boxes.entries()) all.set(box, boxSize * index);
  return all;
}

function areNear(ones: Float64Array, one: number, others: Float64Array, other: number, within: number): boolean {
  const [a, b] = [boxSize * one, boxSize * other];
  for (let axis = 0; axis < 3; axis++) {
    if (ones[a + axis] > others[b + 3 + axis] + within || others[b + axis] > ones[a + 3 + axis] + within) return false;
  }
  return true;
}

/**
 * Calls with each two of these boxes that come within the distance of each other, in the order along the axis over which they are
 * spread most, until it is told to stop. Gives up, and returns false, after looking at so many pairs.
 */
function forEachNear(
  boxes: Float64Array,
  which: Uint32Array,
  within: number,
  budget: number,
  visit: (one: number, other: number) => boolean,
): boolean {
  const axis = widestAxis(boxes, which);
  const lowest = (box: number) => boxes[boxSize * box + axis];
  const order = which.slice().sort((one, other) => lowest(one) - lowest(other));
  let left = budget;
  for (let i = 0; i < order.length; i++) {
    const end = boxes[boxSize * order[i] + 3 + axis] + within;
    for (let j = i + 1; j < order.length && lowest(order[j]) <= end; j++) {
      if (--left < 0) return false;
      if (areNear(boxes, order[i], boxes, order[j], within) && visit(order[i], order[j])) return true;
    }
  }
  return true;
}

function widestAxis(boxes: Float64Array, which: Uint32Array): number {
  const widths = [0, 1, 2].map((axis) => {
    let [lowest, highest] = [Infinity, -Infinity];
    for (const box of which) {
      lowest = Math.min(lowest, boxes[boxSize * box + axis]);
      highest = Math.max(highest, boxes[boxSize * box + axis]);
    }
    return highest - lowest;
  });
  return widths.indexOf(Math.max(...widths));
}

/** Whether any two of these triangles that are of different parts come so near; undefined where there are too many to tell. */
function anyPair(
  mesh: Shape,
  which: Uint32Array,
  parts: Uint32Array,
  boxes: Float64Array,
  within: number,
): boolean | undefined {
  const [a, b] = [new ExtendedTriangle(), new ExtendedTriangle()];
  let left = mostPairs * parts.length;
  for (const bucket of bucketsOf(boxes, which, within)) {
    const first = parts[bucket[0]];
    if (bucket.every((triangle) => parts[triangle] === first)) continue;
    for (let i = 0; i < bucket.length; i++) {
      for (let j = i + 1; j < bucket.length; j++) {
        if (parts[bucket[i]] === parts[bucket[j]]) continue;
        if (--left < 0) return undefined;
        if (!areNear(boxes, bucket[i], boxes, bucket[j], within)) continue;
        if (placed(a, mesh, bucket[i]).distanceToTriangle(placed(b, mesh, bucket[j])) <= within) return true;
      }
    }
  }
  return false;
}

/** So many cells of a grid a triangle may take on average; where triangles are larger the grid is coarser. */
const mostCells = 8;

/** Triangles that can be so near are together in a bucket at least once: cells of a grid, of which a bucket may hold several. */
function* bucketsOf(boxes: Float64Array, which: Uint32Array, within: number): Generator<Uint32Array> {
  const reach = within / 2;
  let size = 2 * within;
  const first = (triangle: number, axis: number) => Math.floor((boxes[boxSize * triangle + axis] - reach) / size);
  const last = (triangle: number, axis: number) => Math.floor((boxes[boxSize * triangle + 3 + axis] + reach) / size);
  const cellsAlong = (triangle: number, axis: number) => last(triangle, axis) - first(triangle, axis) + 1;
  const countAll = () => {
    let sum = 0;
    for (const triangle of which) sum += cellsAlong(triangle, 0) * cellsAlong(triangle, 1) * cellsAlong(triangle, 2);
    return sum;
  };
  while (countAll() > mostCells * which.length + mostCells ** 2) size *= 2;
  const slots = 2 ** Math.ceil(Math.log2(2 * which.length + 2));
  const starts = new Uint32Array(slots + 1);
  const forEachSlot = (triangle: number, visit: (slot: number) => void) => {
    const [endX, endY, endZ] = [last(triangle, 0), last(triangle, 1), last(triangle, 2)];
    const [startY, startZ] = [first(triangle, 1), first(triangle, 2)];
    for (let x = first(triangle, 0); x <= endX; x++)
      for (let y = startY; y <= endY; y++) for (let z = startZ; z <= endZ; z++) visit(slotOf(x, y, z) & (slots - 1));
  };
  for (const triangle of which) forEachSlot(triangle, (slot) => starts[slot + 1]++);
  for (let slot = 0; slot < slots; slot++) starts[slot + 1] += starts[slot];
  const items = new Uint32Array(starts[slots]);
  const next = starts.slice();
  for (const triangle of which) {
    forEachSlot(triangle, (slot) => {
      items[next[slot]++] = triangle;
    });
  }
  for (let slot = 0; slot < slots; slot++) {
    if (starts[slot + 1] - starts[slot] > 1) yield items.subarray(starts[slot], starts[slot + 1]);
  }
}

function slotOf(x: number, y: number, z: number): number {
  const mixed = Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca77) ^ Math.imul(z, 0xc2b2ae3d);
  return (mixed ^ (mixed >>> 15)) >>> 0;
}

function placed(target: ExtendedTriangle, { position, triangles }: Shape, triangle: number): ExtendedTriangle {
  [target.a, target.b, target.c].forEach((corner: Vector3, i) => {
    corner.fromArray(position, 3 * triangles[3 * triangle + i]);
  });
  target.needsUpdate = true;
  return target;
}
