import type { MappedReduction, Mesh, Segmentation } from '../../wasm/types.ts';
import type { Place, Shares } from './place.ts';

/** Below this share of its triangle's area a piece is flat: rounding decides what lies in it. As in the core. */
const flatShare = 1e-12;

/** By so much a point may miss a piece that it lies on the border of: the rounding of its own coordinates. */
const onBorder = 1e-9;

/** A piece around a point, and the shares of the piece's corners in it. */
interface Found {
  piece: number;
  shares: Shares;
}

/**
 * Which points of a surface and of its reduction belong to each other, by the map of the reduction: exactly, since on every
 * piece of their mutual segmentation the map is linear.
 */
export class Correspondence {
  #original: Uint32Array;
  #reduction: MappedReduction;
  #segmentation: Segmentation;
  /** The pieces in each reduced triangle: `#pieces[#first[t]] … #pieces[#first[t + 1] - 1]`. */
  #first: Uint32Array;
  #pieces: Uint32Array;

  constructor(original: Mesh, reduction: MappedReduction, segmentation: Segmentation) {
    this.#original = original.triangles;
    this.#reduction = reduction;
    this.#segmentation = segmentation;
    [this.#first, this.#pieces] = grouped(segmentation.reduced, reduction.mesh.triangles.length / 3);
  }

  /**
   * Where the map takes a point of the original. Where it opens a point of an edge into more than a point, one of those. Null
   * in a triangle that names a vertex twice: it is no surface.
   */
  image({ triangle, barycentric }: Place): Place | null {
    const { original } = this.#segmentation;
    const corner = barycentric.indexOf(1);
    if (corner >= 0) return this.#imageOfVertex(this.#original[3 * triangle + corner]);
    const [begin, end] = [lowerBound(original, triangle), lowerBound(original, triangle + 1)];
    const best = innermost(this.#around(barycentric, range(begin, end), this.#onOriginal));
    return best && this.#mixed(best, this.#segmentation.reduced, this.#onReduced);
  }

  /**
   * The points of the original that the map takes to a point of the reduced surface: one, or more where the map folds.
   * What it squeezes into a line or a point is left out.
   */
  preimages({ triangle, barycentric }: Place): Place[] {
    const pieces = this.#pieces.subarray(this.#first[triangle], this.#first[triangle + 1]);
    const all = this.#around(barycentric, pieces, this.#onReduced);
    const inside = all.filter(({ shares }) => Math.min(...shares) >= -onBorder);
    const best = innermost(all);
    const found = inside.length > 0 ? inside : best ? [best] : [];
    // On the border between pieces it lies in both of them.
    const distinct = new Map(found.map((each) => [this.#bearers(each), each]));
    return [...distinct.values()].map((each) => this.#mixed(each, this.#segmentation.original, this.#onOriginal));
  }

  #imageOfVertex(vertex: number): Place {
    const { triangle, barycentric } = this.#reduction.map;
    return { triangle: triangle[vertex], barycentric: sharesAt(barycentric, vertex) };
  }

  /** Where a point of a triangle lies in pieces of it. */
  #around(point: Shares, pieces: Iterable<number>, placeOf: (corner: number, piece: number) => Shares): Found[] {
    const found: Found[] = [];
    for (const piece of pieces) {
      const [a, b, c] = [0, 1, 2].map((corner) => placeOf(this.#segmentation.pieces[3 * piece + corner], piece));
      const whole = doubleArea(a, b, c);
      if (Math.abs(whole) < flatShare) continue;
      const shares = [doubleArea(point, b, c), doubleArea(a, point, c), doubleArea(a, b, point)];
      found.push({ piece, shares: [shares[0] / whole, shares[1] / whole, shares[2] / whole] });
    }
    return found;
  }

  /** The corners of a piece that a point in it has a share of. */
  #bearers({ piece, shares }: Found): string {
    const corners = this.#segmentation.pieces.subarray(3 * piece, 3 * piece + 3);
    return [...corners.filter((_, corner) => shares[corner] > onBorder)].sort().join();
  }

  /** The point on the other surface. */
  #mixed({ piece, shares }: Found, triangles: Uint32Array, placeOf: (corner: number, piece: number) => Shares): Place {
    const kept = withinSum(shares);
    const sum = [0, 0, 0];
    for (let corner = 0; corner < 3; corner++) {
      const place = placeOf(this.#segmentation.pieces[3 * piece + corner], piece);
      for (let i = 0; i < 3; i++) sum[i] += kept[corner] * place[i];
    }
    return { triangle: triangles[piece], barycentric: withinSum([sum[0], sum[1], sum[2]]) };
  }

  /** Where a corner of a piece lies in the piece's original triangle. */
  #onOriginal = (corner: number, piece: number): Shares => {
    const { crossingEdges, crossingShares, triangle } = this.#reduction.map;
    const host = this.#segmentation.original[piece];
    if (corner < triangle.length) return onEdge(this.#original, host, corner, corner, 0);
    const crossing = corner - triangle.length;
    const [from, to] = [crossingEdges[4 * crossing], crossingEdges[4 * crossing + 1]];
    return onEdge(this.#original, host, from, to, crossingShares[2 * crossing]);
  };

  /** Where it lies in the piece's reduced triangle. */
  #onReduced = (corner: number, piece: number): Shares => {
    const { mesh, map } = this.#reduction;
    const host = this.#segmentation.reduced[piece];
    if (corner >= map.triangle.length) {
      const crossing = corner - map.triangle.length;
      const [from, to] = [map.crossingEdges[4 * crossing + 2], map.crossingEdges[4 * crossing + 3]];
      return onEdge(mesh.triangles, host, from, to, map.crossingShares[2 * crossing + 1]);
    }
    if (map.triangle[corner] === host) return sharesAt(map.barycentric, corner);
    // A kept vertex lies in every triangle around it, and one on a border in a triangle on each side; the map names one.
    const [named, shares] = [map.triangle[corner], sharesAt(map.barycentric, corner)];
    const shareOf = (vertex: number) =>
      shares.reduce((sum, share, each) => (mesh.triangles[3 * named + each] === vertex ? sum + share : sum), 0);
    const [a, b, c] = [0, 1, 2].map((each) => shareOf(mesh.triangles[3 * host + each]));
    return [a, b, c];
  };
}

/** Barycentric coordinates of the point at `share` along an edge of a triangle. */
function onEdge(triangles: Uint32Array, triangle: number, from: number, to: number, share: number): Shares {
  const at = (corner: number) => {
    const vertex = triangles[3 * triangle + corner];
    return vertex === from ? 1 - share : vertex === to ? share : 0;
  };
  return [at(0), at(1), at(2)];
}

function sharesAt(barycentric: Float64Array, index: number): Shares {
  return [barycentric[3 * index], barycentric[3 * index + 1], barycentric[3 * index + 2]];
}

/** Twice the signed area of a triangle whose corners are given in the coordinates of another one; 1 for that one itself. */
function doubleArea(a: Shares, b: Shares, c: Shares): number {
  return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
}

/** Shares that rounding pushed outside, within. */
function withinSum(shares: Shares): Shares {
  const kept = shares.map((share) => Math.max(0, share));
  const sum = kept[0] + kept[1] + kept[2];
  return [kept[0] / sum, kept[1] / sum, kept[2] / sum];
}

/** The piece that a point lies deepest in, or misses least. */
function innermost(found: Found[]): Found | null {
  const depth = ({ shares }: Found) => Math.min(...shares);
  return found.reduce<Found | null>((best, each) => (!best || depth(each) > depth(best) ? each : best), null);
}

function range(begin: number, end: number): number[] {
  return Array.from({ length: end - begin }, (_, index) => begin + index);
}

/** The first index at which rising numbers are no less than `number`. */
function lowerBound(rising: Uint32Array, number: number): number {
  let [low, high] = [0, rising.length];
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (rising[middle] < number) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** The indices of all that belong to each group: `members[first[group]] … members[first[group + 1] - 1]`. */
function grouped(groups: Uint32Array, count: number): [first: Uint32Array, members: Uint32Array] {
  const first = new Uint32Array(count + 1);
  for (const group of groups) first[group + 1]++;
  for (let group = 0; group < count; group++) first[group + 1] += first[group];
  const next = first.slice();
  const members = new Uint32Array(groups.length);
  groups.forEach((group, index) => {
    members[next[group]++] = index;
  });
  return [first, members];
}
