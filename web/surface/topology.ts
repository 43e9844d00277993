import { Partition } from './partition.ts';

/** How a triangle mesh hangs together. Triangles with a vertex twice are no surface and do not count. */
export interface Topology {
  /** Parts that share no vertex. */
  components: number;
  /** Closed runs of edges that have one triangle; loops that touch in a vertex are told apart where its triangles are. */
  boundaryLoops: number;
  /** Edges of three or more triangles, or of two that disagree about the orientation. */
  nonManifoldEdges: number;
  /** Of these, edges of two triangles that disagree about the orientation. */
  discordantEdges: number;
  /** Vertices whose triangles do not form one fan: they are on an edge of three or more triangles, or in several fans. */
  nonManifoldVertices: number;
}

/** Examines a triangle mesh: three vertex numbers a triangle, all below `vertices`. Time and memory grow linearly. */
export function topologyOf(triangles: Uint32Array, vertices: number): Topology {
  const surface = withoutRepeatedVertices(triangles);
  const edges = new Edges(surface, vertices);
  const fans = fansOf(surface, edges);
  return {
    components: componentCount(surface, vertices),
    boundaryLoops: boundaryLoopCount(edges, fans),
    nonManifoldEdges: edges.count((corners) => !isManifold(surface, corners)),
    discordantEdges: edges.count((corners) => corners.length === 2 && !isManifold(surface, corners)),
    nonManifoldVertices: splitVertexCount(surface, vertices, edges, fans),
  };
}

/** The edges at which sheets end: of one triangle, of three or more, or of two that disagree. Two vertices each. */
export function sheetEnds(triangles: Uint32Array, vertices: number): Uint32Array {
  const surface = withoutRepeatedVertices(triangles);
  const ends = new Uint32Array(2 * surface.length);
  let length = 0;
  new Edges(surface, vertices).forEach((corners) => {
    if (corners.length === 2 && isManifold(surface, corners)) return;
    ends[length++] = surface[corners[0]];
    ends[length++] = surface[next(corners[0])];
  });
  return ends.slice(0, length);
}

function withoutRepeatedVertices(triangles: Uint32Array): Uint32Array {
  const repeated = (corner: number) => {
    const [a, b, c] = [triangles[corner], triangles[corner + 1], triangles[corner + 2]];
    return a === b || b === c || c === a;
  };
  return triangles.filter((_, corner) => !repeated(corner - (corner % 3)));
}

/** The next corner of the same triangle. The edge of a corner runs from it to the next one. */
function next(corner: number): number {
  return corner % 3 === 2 ? corner - 2 : corner + 1;
}

/** The corners of a mesh, those of one undirected edge side by side. */
class Edges {
  private readonly lower: Uint32Array;
  private readonly upper: Uint32Array;
  private readonly order: Uint32Array;

  constructor(triangles: Uint32Array, vertices: number) {
    this.lower = triangles.map((from, corner) => Math.min(from, triangles[next(corner)]));
    this.upper = triangles.map((from, corner) => Math.max(from, triangles[next(corner)]));
    const unordered = Uint32Array.from(triangles.keys());
    this.order = orderedBy(this.lower, orderedBy(this.upper, unordered, vertices), vertices);
  }

  /** Calls with the corners of each edge. */
  forEach(visit: (corners: Uint32Array) => void): void {
    for (let begin = 0, end = 0; begin < this.order.length; begin = end) {
      while (end < this.order.length && this.sameEdge(this.order[begin], this.order[end])) end++;
      visit(this.order.subarray(begin, end));
    }
  }

  count(matches: (corners: Uint32Array) => boolean): number {
    let matching = 0;
    this.forEach((corners) => {
      if (matches(corners)) matching++;
    });
    return matching;
  }

  private sameEdge(one: number, other: number): boolean {
    return this.lower[one] === this.lower[other] && this.upper[one] === this.upper[other];
  }
}

/** The elements in rising order of their keys, which are below `keyCount`; elements of one key stay in their order. */
function orderedBy(keys: Uint32Array, elements: Uint32Array, keyCount: number): Uint32Array {
  const places = new Uint32Array(keyCount + 1);
  for (const key of keys) places[key + 1]++;
  for (let key = 0; key < keyCount; key++) places[key + 1] += places[key];
  const ordered = new Uint32Array(elements.length);
  for (const element of elements) ordered[places[keys[element]]++] = element;
  return ordered;
}

/** One triangle, or two that run along the edge in opposite directions. */
function isManifold(triangles: Uint32Array, corners: Uint32Array): boolean {
  return corners.length === 1 || (corners.length === 2 && triangles[corners[0]] !== triangles[corners[1]]);
}

/** The corners at each vertex, joined where their triangles share an edge. */
function fansOf(triangles: Uint32Array, edges: Edges): Partition {
  const fans = new Partition(triangles.length);
  edges.forEach((corners) => {
    const first = corners[0];
    for (let i = 1; i < corners.length; i++) {
      const other = corners[i];
      const same = triangles[other] === triangles[first];
      fans.join(first, same ? other : next(other));
      fans.join(next(first), same ? next(other) : other);
    }
  });
  return fans;
}

function componentCount(triangles: Uint32Array, vertices: number): number {
  const parts = new Partition(vertices);
  triangles.forEach((vertex, corner) => {
    parts.join(vertex, triangles[next(corner)]);
  });
  return parts.count(triangles);
}

function boundaryLoopCount(edges: Edges, fans: Partition): number {
  const loops = new Partition(fans.size);
  const ends: number[] = [];
  edges.forEach((corners) => {
    if (corners.length > 1) return;
    loops.join(fans.root(corners[0]), fans.root(next(corners[0])));
    ends.push(fans.root(corners[0]));
  });
  return loops.count(ends);
}

function splitVertexCount(triangles: Uint32Array, vertices: number, edges: Edges, fans: Partition): number {
  const noFan = 0xffffffff;
  const fanAt = new Uint32Array(vertices).fill(noFan);
  const split = new Uint8Array(vertices);
  edges.forEach((corners) => {
    if (corners.length > 2) split[triangles[corners[0]]] = split[triangles[next(corners[0])]] = 1;
  });
  triangles.forEach((vertex, corner) => {
    const fan = fans.root(corner);
    if (fanAt[vertex] === noFan) fanAt[vertex] = fan;
    if (fanAt[vertex] !== fan) split[vertex] = 1;
  });
  return split.reduce((sum, each) => sum + each, 0);
}
