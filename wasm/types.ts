/** A named array at the vertices, interleaved: component j of vertex i stands at `values[i * components + j]`. */
export interface Variable {
  name: string;
  components: number;
  values: Float32Array | Float64Array;
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
  /** By variable name; `position` is the geometry, `*` every variable not named. A variable that none reaches is free. */
  bounds: Record<string, Bound>;
  /** How errors are accounted for. Default: the core's. */
  errors?: 'propagated' | 'tracked';
  /**
   * The sweeps over the surface: each removes what stays within this fraction of the bounds. Rising, above 0, the last one 1.
   * Default: the core's, 1/8 and 1. Not of a reduction onward, which takes one.
   */
  sweeps?: number[];
  /**
   * How many threads share the work, 1 to 64, where the page is isolated from other origins; never more than the engine was
   * started with. The result is the same for any number. Default: all of these.
   */
  threads?: number;
  /** Tracked errors: choose places of vertices and crossings in the map with smaller errors. Default: the core's. */
  choosePlaces?: boolean;
  chooseCrossings?: boolean;
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
   * Leave out, and count, parts of the surface whose box has a diagonal within the bound of position; the promise is then
   * about the rest. The largest part stays, as do parts with locked vertices. Default: false.
   */
  dropSmallParts?: boolean;
  /**
   * The name of a variable with one component, above zero everywhere, which multiplies every bound: at a point where the
   * original has the multiplier m, no error exceeds m times the bound. It is carried along like any other variable.
   */
  focus?: string;
  /** Give out the surface that the reduction passes on its way, too: `Reduction.waypoint`, for `reduceOnward`. Default: false. */
  waypoint?: boolean;
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

/** What can be asked of a reduction that goes on from a waypoint; what only the original can tell cannot. */
export type OnwardOptions = Omit<
  ReduceOptions,
  'sweeps' | 'countFolds' | 'limitToFeatureSize' | 'dropSmallParts' | 'focus' | 'waypoint' | 'transfer'
>;

export interface LevelsOptions extends Omit<ReduceOptions, 'bounds' | 'waypoint'> {
  /** The bounds of each level, finest first. From level to level no bound may fall, and at least one must rise. */
  levels: Record<string, Bound>[];
  /** Tracked errors only: make the morphs between neighbours too; a few more triangles may stay. Default: false. */
  morphs?: boolean;
}

/** What was promised and reached for one variable; errors and bounds in its unit. */
export interface VariableReport {
  name: string;
  components: number;
  extent: number;
  magnitude: number;
  /** Extent is rounding noise; a relative bound was taken from the magnitude. */
  constant: boolean;
  /** The bound in the variable's unit; Infinity where it is free. */
  bound: number;
  error: number;
  /** The largest of error / bound, multiplied by the focus as it is there; 1 is the limit; 0 where it is free. */
  ratio: number;
  /** Vertices still there because removing them would break this variable's bound. */
  refused: number;
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
  refused: { fixed: number; topology: number; fold: number; piercing: number };
  oddities: {
    repeatedVertexTriangles: number;
    zeroAreaTriangles: number;
    unusedVertices: number;
    /** Triangles that face the other side than most around them: turned round. */
    turnedTriangles: number;
    /** Parts without two sides (a Möbius band), oriented up to a line across them, and the first triangle of the first of them. */
    unorientableParts: number;
    unorientableTriangle?: number;
  };
  /** Parts of the surface that were left out, see `ReduceOptions.dropSmallParts`. */
  dropped: { parts: number; triangles: number };
  /**
   * Which of `ReduceOptions.lockedBoxes` meet no triangle, so that nothing stays because of them; rising indices. Of what was
   * reduced onward: no triangle of the waypoint.
   */
  unmetBoxes: number[];
  /** By rising labels; empty where triangles have none. */
  regions: RegionReport[];
  /** The smallest distance between two lobes, where it limited the bound of position (see `limitToFeatureSize`). */
  featureSize?: number;
  /** Triangles that turn more than a right angle against the original between their corners. */
  turnedAway: { before: number; after: number };
  nonManifoldVertices: number;
  /** Tracked errors only: into how many cells the map cuts the original, and how many of them it turns over. */
  cells: number;
  foldedCells: number;
  /** `on_the_way`: of a waypoint. */
  stopped: 'finished' | 'cancelled' | 'on_the_way';
  /** Errors are upper bounds, sums over a waypoint and the way on from there (`reduceOnward`). */
  summed: boolean;
  /** Wall time of the call in the core; of a level that of all levels. */
  seconds: number;
}

/** The error of one variable on every reduced triangle, in its unit. */
export interface TriangleErrors {
  largest: Float32Array;
  /** Signed, original minus reduced; empty for a variable with several components (position: distance along the normal). */
  lowest: Float32Array;
  highest: Float32Array;
  /** The largest of error / bound, the bound multiplied as it is at each point (`focus`); 0 where the variable is free. */
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
  crossingPlaces: Float64Array;
  /**
   * For each crossing: 1 where, with s rising, it passes from the left of the reduced edge (the triangle that has it from its
   * first to its second vertex) to its right, 0 the other way.
   */
  crossingRightward: Uint8Array;
}

/** The errors of one variable at the vertices of the input, in its unit. */
export interface VertexErrors {
  error: Float32Array;
  /** Original minus reduced; empty for a variable with several components (position: distance along the normal). */
  signedError: Float32Array;
}

/**
 * A surface on the way of a reduction, or its result: what is left of the original, and by its report how far from that it
 * may lie by now. From there `reduceOnward` goes on.
 */
export interface Waypoint {
  mesh: Mesh;
  /** For each of its vertices the index in the original, rising. */
  vertices: Uint32Array;
  /** Its errors are what was spent. */
  report: Report;
}

export interface Reduction extends Waypoint {
  /** Position first, then the mesh's variables in their order. */
  triangleErrors: TriangleErrors[];
  /** Tracked errors only: the map, and the errors at the input's vertices (position first, then the variables). */
  map?: SurfaceMap;
  vertexErrors?: VertexErrors[];
  /** Where `ReduceOptions.waypoint` asks for it: the surface before the last sweep, within an eighth of every bound. */
  waypoint?: Waypoint;
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
