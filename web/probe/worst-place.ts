import type { MappedReduction, Mesh, Reduction, Variable, VertexErrors } from '../../wasm/types.ts';
import { isTriangle } from '../surface/used-points.ts';
import { type Place, variablesOf } from './place.ts';

/** A point of the original and the point of the reduced surface that it is mapped to. */
export interface PlacePair {
  original: Place;
  reduced: Place;
}

/** The triangle that the map names for a vertex that none uses. */
const nowhere = 0xffffffff;

/** Where an error is not known, because the variable is no number there, it is less than any that is. */
function known(error: number): number {
  return Number.isFinite(error) ? error : -1;
}

/** A reduction with a map and measured errors: those were tracked. */
export type TrackedReduction = Reduction & MappedReduction & { vertexErrors: VertexErrors[] };

export function isMapped(reduction: Reduction): reduction is TrackedReduction {
  return reduction.map !== undefined && reduction.vertexErrors !== undefined;
}

/** The middle of the reduced triangle where the error of a variable may be largest: all that is known without a map. */
export function worstOnReduced({ triangleErrors }: Reduction, index: number): Place {
  const { largest } = triangleErrors[index];
  return { triangle: largestOf(largest.length, (each) => known(largest[each])), barycentric: [1 / 3, 1 / 3, 1 / 3] };
}

/**
 * The place where the error of a variable is largest. The map is linear between its corners (the vertices of the original and
 * the crossings of edges), and the length of a linear difference is largest at a corner: so none has to be looked for elsewhere.
 *
 * @param index 0 for position, then the variables in their order
 */
export function worstPlace(
  mesh: Mesh,
  reduction: Pick<TrackedReduction, keyof MappedReduction | 'vertexErrors'>,
  index: number,
): PlacePair {
  const { error } = reduction.vertexErrors[index];
  const { triangle } = reduction.map;
  const errorAt = (vertex: number) => (triangle[vertex] === nowhere ? Number.NEGATIVE_INFINITY : known(error[vertex]));
  const vertex = largestOf(error.length, errorAt);
  const crossings = new Crossings(mesh, reduction, index);
  const crossing = largestOf(crossings.count, (each) => crossings.error(each));
  const atCrossing = crossings.count > 0 && crossings.error(crossing) > errorAt(vertex);
  return atCrossing ? crossingShares(mesh, reduction, crossing) : vertexPlaces(mesh, reduction, vertex);
}

/** The errors of one variable where original edges cross reduced ones. */
class Crossings {
  #original: Variable;
  #reduced: Variable;
  #reduction: MappedReduction;

  constructor(mesh: Mesh, reduction: MappedReduction, index: number) {
    this.#original = variablesOf(mesh)[index];
    this.#reduced = variablesOf(reduction.mesh)[index];
    this.#reduction = reduction;
  }

  get count(): number {
    return this.#reduction.map.crossingRightward.length;
  }

  error(crossing: number): number {
    const { crossingEdges: ends, crossingShares: shares } = this.#reduction.map;
    let squares = 0;
    for (let component = 0; component < this.#original.components; component++) {
      const [first, place] = [4 * crossing, 2 * crossing];
      const here = between(this.#original, ends[first], ends[first + 1], shares[place], component);
      const there = between(this.#reduced, ends[first + 2], ends[first + 3], shares[place + 1], component);
      squares += (here - there) ** 2;
    }
    return known(Math.sqrt(squares));
  }
}

function between({ components, values }: Variable, from: number, to: number, share: number, component: number): number {
  return (1 - share) * values[components * from + component] + share * values[components * to + component];
}

function crossingShares(mesh: Mesh, { mesh: reduced, map }: MappedReduction, crossing: number): PlacePair {
  const ends = map.crossingEdges.subarray(4 * crossing, 4 * crossing + 4);
  const [s, t] = map.crossingShares.subarray(2 * crossing, 2 * crossing + 2);
  return {
    original: placeOnEdge(mesh.triangles, ends[0], ends[1], s),
    reduced: placeOnEdge(reduced.triangles, ends[2], ends[3], t),
  };
}

function vertexPlaces(mesh: Mesh, { map }: MappedReduction, vertex: number): PlacePair {
  const [a, b, c] = map.barycentric.subarray(3 * vertex, 3 * vertex + 3);
  return {
    original: placeOnEdge(mesh.triangles, vertex, vertex, 0),
    reduced: { triangle: map.triangle[vertex], barycentric: [a, b, c] },
  };
}

/** A point of an edge as a place in the first triangle that has it. */
function placeOnEdge(triangles: Uint32Array, from: number, to: number, share: number): Place {
  const has = (first: number, vertex: number) =>
    triangles[first] === vertex || triangles[first + 1] === vertex || triangles[first + 2] === vertex;
  for (let first = 0; first < triangles.length; first += 3) {
    if (!isTriangle(triangles, first) || !has(first, from) || !has(first, to)) continue;
    const corners = triangles.subarray(first, first + 3);
    const [a, b, c] = Array.from(corners, (each) => (each === from ? 1 - share : each === to ? share : 0));
    return { triangle: first / 3, barycentric: [a, b, c] };
  }
  throw new Error(`No triangle has the edge from vertex ${from} to vertex ${to}.`);
}

/** The index with the largest number, the first of several. */
function largestOf(count: number, numberOf: (index: number) => number): number {
  let best = 0;
  let largest = -Infinity;
  for (let index = 0; index < count; index++) {
    const number = numberOf(index);
    if (number <= largest) continue;
    largest = number;
    best = index;
  }
  return best;
}
