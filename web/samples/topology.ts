/** What a triangle mesh is like as a surface. */
export interface Topology {
  /** Edges with three or more triangles, or with two that disagree about the orientation. */
  badEdges: number;
  /** Vertices whose triangles do not form one fan. */
  badVertices: number;
  boundaryLoops: number;
  components: number;
}

/** Examines a triangle mesh: three vertex numbers a triangle, below `vertices`. */
export function topology(triangles: Uint32Array, vertices: number): Topology {
  const edges = orientedEdges(triangles, vertices);
  const unpaired = [...edges.keys()].filter(
    (key) => !edges.has((key % vertices) * vertices + Math.floor(key / vertices)),
  );
  const repeated = [...edges.values()].filter((uses) => uses > 1).length;
  const loops = new Partition(vertices);
  for (const key of unpaired) {
    loops.join(Math.floor(key / vertices), key % vertices);
  }
  const whole = new Partition(vertices);
  triangles.forEach((vertex, corner) => {
    whole.join(vertex, triangles[corner - (corner % 3)]);
  });
  return {
    badEdges: repeated,
    badVertices: splitVertices(triangles, vertices),
    boundaryLoops: new Set(unpaired.map((key) => loops.root(key % vertices))).size,
    components: new Set(Array.from(triangles, (vertex) => whole.root(vertex))).size,
  };
}

/** How many triangles have an edge from vertex a to vertex b, by a * vertices + b. */
function orientedEdges(triangles: Uint32Array, vertices: number): Map<number, number> {
  const edges = new Map<number, number>();
  triangles.forEach((from, corner) => {
    const to = triangles[corner % 3 === 2 ? corner - 2 : corner + 1];
    const key = from * vertices + to;
    edges.set(key, (edges.get(key) ?? 0) + 1);
  });
  return edges;
}

/** Counts the vertices whose triangles fall apart into several fans when one goes from each to the next over edges. */
function splitVertices(triangles: Uint32Array, vertices: number): number {
  const fans = new Partition(triangles.length); // of corners
  const seen = new Map<number, number>();
  triangles.forEach((from, corner) => {
    const next = corner % 3 === 2 ? corner - 2 : corner + 1;
    const to = triangles[next];
    const key = Math.min(from, to) * vertices + Math.max(from, to);
    const other = seen.get(key);
    if (other === undefined) {
      seen.set(key, corner);
      return;
    }
    const otherNext = other % 3 === 2 ? other - 2 : other + 1;
    fans.join(corner, triangles[other] === from ? other : otherNext);
    fans.join(next, triangles[other] === from ? otherNext : other);
  });
  const fan = new Map<number, number>();
  const split = new Set<number>();
  triangles.forEach((vertex, corner) => {
    if ((fan.get(vertex) ?? fans.root(corner)) !== fans.root(corner)) {
      split.add(vertex);
    }
    fan.set(vertex, fans.root(corner));
  });
  return split.size;
}

/** Union-find. */
class Partition {
  private readonly parents: Uint32Array;

  constructor(size: number) {
    this.parents = Uint32Array.from({ length: size }, (_, i) => i);
  }

  root(element: number): number {
    let here = element;
    while (this.parents[here] !== here) {
      this.parents[here] = this.parents[this.parents[here]];
      here = this.parents[here];
    }
    return here;
  }

  join(a: number, b: number): void {
    this.parents[this.root(a)] = this.root(b);
  }
}
