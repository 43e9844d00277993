/**
 * What the numbers of a variable are: a quantity varies over the surface; an identifier names things (numbers of points,
 * masks), and no bound for all variables (`*`) is about it.
 */
export type VariableKind = 'quantity' | 'identifier';

/** A named array at the vertices, interleaved: component j of vertex i stands at `values[i * components + j]`. */
export interface Variable {
  name: string;
  components: number;
  values: Float32Array | Float64Array;
  /** Default: a quantity. */
  kind?: VariableKind;
}

/** An oriented triangle mesh that carries data. */
export interface Mesh {
  /** Interleaved x, y, z. */
  position: Float32Array | Float64Array;
  /** Three vertex indices a triangle, counter-clockwise seen from outside. */
  triangles: Uint32Array;
  variables: Variable[];
  /**
   * A label for each triangle. Where labels differ the surface has a border, which is kept within the bounds: each side keeps
   * its label, and so do the corners in which borders meet or end.
   */
  regions?: Int32Array;
}

/** The largest allowed error: a fraction of the variable's extent, a value in its unit, or none. */
export type Bound = { relative: number } | { absolute: number } | 'free';

/** A box along the axes, in the unit of position; its faces belong to it. */
export interface Box {
  lowest: [number, number, number];
  highest: [number, number, number];
}

export interface ReduceOptions {
  /**
   * By variable name; `position` is the geometry, `*` every variable not named but identifiers (`Variable.kind`). A variable
   * that none reaches is free.
   */
  bounds: Record<string, Bound>;
  /** How errors are accounted for. Default: the core's. */
  errors?: 'propagated' | 'tracked';
  /**
   * The sweeps over the surface: each removes what stays within this fraction of the bounds. Rising, above 0, the last one 1.
   * Default: the core's, 1/8 and 1. Not of a resumed reduction, which takes one.
   */
  sweeps?: number[];
  /**
   * How many threads share the work, 1 to 64, where the page is isolated from other origins; never more than the engine was
   * started with. The result is the same for any number. Default: all of these.
   */
  threads?: number;
  /** Tracked errors: choose places of vertices and crossings in the map with smaller errors. Default: the core's. */
  optimizeVertexImages?: boolean;
  optimizeEdgeCrossings?: boolean;
  /** Tracked errors: count the map's cells and folds, a few percent of the time. Default: the core's. */
  countFolds?: boolean;
  /**
   * Refuse what would make a part of the surface pierce or touch another one that passes near. Two triangles of the result
   * then meet beyond common corners and edges only if both are triangles of the input, which met before. Default: false.
   */
  refusePiercing?: boolean;
  /**
   * Limit the bound of position to half the smallest distance between two parts of the surface that face each other: where
   * that is below the bound, the report has it as `featureSize`. Default: false.
   */
  limitToFeatureSize?: boolean;
  /** What retriangulation makes small (§3.4.1). Default: the core's. */
  cost?: 'maximum' | 'introduced';
  /** Vertices that must stay. */
  locked?: Uint32Array;
  /** Labels of regions that must stay as they are, borders included. */
  lockedRegions?: Int32Array;
  /** What must stay as it is: every triangle whose own box meets one of these boxes, with its vertices. */
  lockedBoxes?: Box[];
  /**
   * Leave out, and count, parts of the surface whose box has a diagonal within the bound of position; the guarantee is then
   * about the rest. The largest part stays, as do parts with locked vertices. Default: false.
   */
  dropSmallComponents?: boolean;
  /**
   * The name of a variable with one component, above zero everywhere, which multiplies every bound: at a point where the
   * original has the multiplier m, no error exceeds m times the bound. It is carried along like any other variable.
   */
  boundMultiplier?: string;
  /** Give out the surface that the reduction passes on its way, too: `Reduction.checkpoint`, for `resumeReduction`. Default: false. */
  checkpoint?: boolean;
  /**
   * Hand the mesh's arrays over instead of copying them: they are detached (empty) afterwards. Saves one copy of a large
   * mesh. Default: false, they stay the caller's.
   */
  transfer?: boolean;
  /** Aborts the running reduction; the promise rejects with an AbortError. */
  signal?: AbortSignal;
  /** Called with the progress, 0…1, never falling. */
  onProgress?: (progress: number) => void;
}

/** What can be asked of a reduction that goes on from a checkpoint; what only the original can tell cannot. */
export type ResumeOptions = Omit<
  ReduceOptions,
  'sweeps' | 'countFolds' | 'limitToFeatureSize' | 'dropSmallComponents' | 'boundMultiplier' | 'checkpoint' | 'transfer'
>;

export interface LevelsOptions extends Omit<ReduceOptions, 'bounds' | 'checkpoint'> {
  /** The bounds of each level, finest first. From level to level no bound may fall, and at least one must rise. */
  levels: Record<string, Bound>[];
  /** Tracked errors only: make the morphs between neighbours too; a few more triangles may stay. Default: false. */
  morphs?: boolean;
}

/** Where a variable is NaN or infinite: at how many of the vertices that triangles use, and the first of them. */
export interface NonFinite {
  vertices: number;
  first: number;
}

/** What was guaranteed and reached for one variable; errors and bounds in its unit. */
export interface VariableReport {
  name: string;
  components: number;
  /** Left out: a quantity. */
  kind?: VariableKind;
  extent: number;
  magnitude: number;
  /** Extent is rounding noise; a relative bound was taken from the magnitude. */
  constant: boolean;
  /** Left out where all values are numbers; else the variable must be free. */
  nonFinite?: NonFinite;
  /** The bound in the variable's unit; Infinity where it is free. */
  bound: number;
  /** NaN where it is not known, because the variable is NaN or infinite somewhere. */
  error: number;
  /** The largest of error / bound, multiplied by `boundMultiplier` as it is there; 1 is the limit; 0 where it is free. */
  ratio: number;
  /** Vertices still there because removing them would break this variable's bound. */
  refused: number;
  /** What the format of the file takes of the bound; `error` includes it. Set by whoever writes the file. */
  rounding?: number;
}

/** How much there is of a region, see `Mesh.regions`; one without triangles has vanished. */
export interface RegionReport {
  label: number;
  triangles: { before: number; after: number };
  /** In the unit of position, squared. */
  area: { before: number; after: number };
}

export interface Report {
  triangles: { before: number; after: number };
  vertices: { before: number; after: number };
  /** Position first, then the mesh's variables in their order. */
  variables: VariableReport[];
  /**
   * Vertices of the input that were there to go, locked ones too: all that triangles use, but for those of parts that were left
   * out.
   */
  candidates: number;
  /** Why vertices that are left could not go, besides the bounds. Each counts once, for the first of these reasons. */
  refused: {
    /** Where curves meet or end (edges of three or more triangles, borders of regions, seams), or in a bow-tie. */
    nonManifold: number;
    locked: number;
    /** More than 48 neighbours. */
    ring: number;
    /** Without it the surface would be another one: an edge there already, a tetrahedron, the last loop. */
    topology: number;
    /** Whatever takes its place folds, or turns away from the surface. */
    fold: number;
    /** What takes its place would pierce another part (`refusePiercing`). */
    piercing: number;
  };
  defects: {
    repeatedVertexTriangles: number;
    zeroAreaTriangles: number;
    unusedVertices: number;
    /** Triangles that face the other side than most around them: turned round. */
    flippedTriangles: number;
    /** Parts without two sides (a Möbius band), oriented up to a line across them, and the first triangle of the first of them. */
    unorientableComponents: number;
    unorientableTriangle?: number;
    /** Triangles on the three vertices of an earlier one that face the same way: left out of the result. */
    copiedTriangles: number;
    /** Pairs of triangles on the same three vertices that face opposite ways: two sides of a sheet, reduced together. */
    twoSidedTriangles: number;
  };
  /** Parts of the surface that were left out, see `ReduceOptions.dropSmallComponents`. */
  dropped: { components: number; triangles: number };
  /**
   * Which of `ReduceOptions.lockedBoxes` meet no triangle, so that nothing stays because of them; rising indices. Of what was
   * resumed: no triangle of the checkpoint.
   */
  unusedLockedBoxes: number[];
  /** By rising labels; empty where triangles have none. */
  regions: RegionReport[];
  /** The smallest distance between two lobes, where it limited the bound of position (see `limitToFeatureSize`). */
  featureSize?: number;
  /** Triangles that turn more than a right angle against the original between their corners. */
  flippedNormals: { before: number; after: number };
  nonManifoldVertices: number;
  /** Tracked errors only: into how many cells the map cuts the original, and how many of them it turns over. */
  cells: number;
  foldedCells: number;
  /** `intermediate`: of a checkpoint. */
  termination: 'finished' | 'cancelled' | 'intermediate';
  /** Errors are upper bounds, sums over a checkpoint and the way on from there (`resumeReduction`). */
  errorsAreUpperBounds: boolean;
  /** Wall time of the call in the core; of a level that of all levels. */
  seconds: number;
}

/** The error of one variable on every reduced triangle, in its unit; NaN where the variable is NaN or infinite there. */
export interface TriangleErrors {
  largest: Float32Array;
  /** Signed, original minus reduced; empty for a variable with several components (position: distance along the normal). */
  lowest: Float32Array;
  highest: Float32Array;
  /** The largest of error / bound, the bound multiplied as it is at each point (`boundMultiplier`); 0 where the variable is free. */
  ratio: Float32Array;
}

/** Where the map puts the vertices of the input, and where their edges cross edges of the reduced mesh. */
export interface SurfaceMap {
  /** For each vertex of the input the triangle of the reduced mesh in which it lies; 4294967295 where no triangle uses it. */
  triangle: Uint32Array;
  /** Three barycentric coordinates for each vertex of the input. */
  barycentric: Float64Array;
  /** For each crossing: the two input vertices of the original edge, the two vertices of the reduced edge. */
  crossingEdges: Uint32Array;
  /** For each crossing: s along the original edge, t along the reduced edge. */
  crossingShares: Float64Array;
  /**
   * For each crossing: 1 where, with s rising, it passes from the left of the reduced edge (the triangle that has it from its
   * first to its second vertex) to its right, 0 the other way.
   */
  crossingRightward: Uint8Array;
}

/** The errors of one variable at the vertices of the input, in its unit; NaN where the variable is NaN or infinite there. */
export interface VertexErrors {
  error: Float32Array;
  /** Original minus reduced; empty for a variable with several components (position: distance along the normal). */
  signedError: Float32Array;
}

/**
 * A surface on the way of a reduction, or its result: what is left of the original, and by its report how far from that it
 * may lie by now. From there `resumeReduction` goes on.
 */
export interface Checkpoint {
  mesh: Mesh;
  /** For each of its vertices the index in the original, rising. */
  vertices: Uint32Array;
  /** Its errors are what was spent. */
  report: Report;
}

export interface Reduction extends Checkpoint {
  /** Position first, then the mesh's variables in their order. */
  triangleErrors: TriangleErrors[];
  /** Tracked errors only: the map, and the errors at the input's vertices (position first, then the variables). */
  map?: SurfaceMap;
  vertexErrors?: VertexErrors[];
  /** Where `ReduceOptions.checkpoint` asks for it: the surface before the last sweep, within an eighth of every bound. */
  checkpoint?: Checkpoint;
}

/** Of a reduction what says where the mesh went that was reduced: the triangles, where they come from, and the map. */
export type MappedReduction = Pick<Reduction, 'mesh' | 'vertices'> & { map: SurfaceMap };

/**
 * The mutual segmentation of a mesh and its reduction: the mesh cut into triangular pieces, each of which lies in one triangle
 * of either surface and is mapped linearly from the one into the other, all variables included. So it tells of every point
 * where the map takes it, exactly, and of every point of the reduced surface where it comes from.
 *
 * A corner of a piece is named by one number: below the number of vertices of the mesh it is that vertex, at
 * `map.triangle` and `map.barycentric`; from there on it is a crossing of the map, counted from 0.
 */
export interface Segmentation {
  /** Three corners a piece. */
  pieces: Uint32Array;
  /** For each piece the triangle of the mesh that it is a part of; rising. */
  original: Uint32Array;
  /** For each piece the triangle of the reduced mesh that it lands in. */
  reduced: Uint32Array;
  /** Pieces that run clockwise in the reduced mesh. */
  foldedPieces: number;
}

/** One of the two levels that a morph leads between. */
export interface MorphEnd {
  /** At the corners of the morph. */
  position: Float32Array | Float64Array;
  variables: Variable[];
  /** For each triangle of the morph the triangle of the level that it lies in. */
  triangle: Uint32Array;
  /** Where each corner lies: three vertices of one triangle of the level, and their weights, which add up to 1. */
  vertices: Uint32Array;
  weights: Float64Array;
}

/**
 * The way from a finer level to the next coarser one, as triangles whose corners carry the place and the values of both.
 * Mixed linearly, they lead from the one surface to the other without a jump or a crack, boundary on boundary: at 0 it is the
 * finer level, at 1 the coarser one. The first corners are the vertices of the finer level, bit for bit.
 */
export interface Morph {
  /** Three corners a triangle. */
  triangles: Uint32Array;
  finer: MorphEnd;
  coarser: MorphEnd;
  /** Triangles that run clockwise on the coarser level, and their share of the finer level's area. */
  foldedTriangles: number;
  foldedShare: number;
}

/** Nested levels of detail, finest first. */
export interface Levels {
  /** Each against the original: errors, map and vertices as if it were reduced alone. */
  levels: Reduction[];
  /** `morphs[i]` leads to `levels[i]`, from the level before or, i being 0, from the original; empty unless asked for. */
  morphs: Morph[];
}

/** The bounds of a call of `verify`, and how thoroughly it looks. */
export interface VerifyOptions {
  /**
   * Absolute, in the unit of each variable: that of position first, then one a variable of the original, in their order. Above
   * zero; Infinity is free. Those of a reduction are `report.variables.map(({ bound }) => bound)`.
   */
  bounds: readonly number[];
  /** How many points of each surface are looked at, more or less; never fewer than its vertices, edges and triangles. Default: 50 000. */
  samples?: number;
  /** The same of each boundary. Default: 50 000. */
  boundarySamples?: number;
  /** What multiplies all bounds at each vertex of the original: numbers above zero. Default: nothing. */
  multipliers?: Float32Array | Float64Array;
  signal?: AbortSignal;
  /** Called with the progress so far, 0…1, never falling. */
  onProgress?: (progress: number) => void;
}

/** The sample of one surface that lies farthest from the other. */
export interface Deviation {
  /** Distance in bounds: 1 is the limit. Infinity where there is nothing to be near to. */
  ratio: number;
  /** Of the sampled surface, counting those with three distinct vertices; of a boundary the edge. */
  triangle: number;
  barycentric: [number, number, number];
  /** The same point in space, in the user's unit of length. */
  position: [number, number, number];
  /** Which variable is farthest there: 0 position, i + 1 the mesh's variable i. */
  variable: number;
  /** How many points were looked at. */
  samples: number;
}

/** What was found between two surfaces, or two boundaries, both ways. */
export interface Judgement {
  fromOriginal: Deviation;
  fromReduced: Deviation;
}

/** What the judge says of a reduced surface. */
export interface Verdict {
  surface: Judgement;
  /** Of the boundaries, as curves. */
  boundary: Judgement;
  /** The largest of surface and boundary; too large by at most 1e-6. */
  ratio: number;
  /** Whether no bound is broken at any sample. */
  withinBounds: boolean;
}
