import { Engine, type EngineSettings } from './engine.ts';
import type { Inspection } from './inspection.ts';
import type {
  Checkpoint,
  Levels,
  LevelsOptions,
  Mesh,
  ReduceOptions,
  Reduction,
  ResumeOptions,
  Segmentation,
  Verdict,
  VerifyOptions,
} from './types.ts';

export { Engine, type EngineSettings } from './engine.ts';
export { type ErrorCode, type Failure, MeshboundError } from './errors.ts';
export type { Inspection, VariableExtent } from './inspection.ts';
export type * from './types.ts';

let shared: Engine | undefined;
let settings: EngineSettings = {};

/** The engine that all calls share. It takes nothing before the first of them. */
function sharedEngine(): Engine {
  shared ??= new Engine(settings);
  return shared;
}

/**
 * Says where worker and module lie and how many threads may share the work, for the engine that `reduce` and the others share.
 * Throws an Error after the first call of one of them: an `Engine` of one's own takes settings at any time.
 */
export function configure(chosen: EngineSettings): void {
  if (shared) throw new Error('configure() must be called before the first reduction.');
  settings = chosen;
}

/**
 * Reduces a mesh so that every bound holds at every point of its surface:
 *
 * > There is a continuous map from the original surface onto the reduced one that moves no point by more than the bound of
 * > `position` and changes no variable by more than its bound.
 *
 * Runs in a worker; calls queue. The arrays of `mesh` are copied at the call and stay the caller's, unless
 * `options.transfer` hands them over. Rejects with a
 * MeshboundError that names the fault and its place, with a TypeError for arrays of another type than `Mesh` says, and with
 * an AbortError once `options.signal` is aborted.
 */
export function reduce(mesh: Mesh, options: ReduceOptions): Promise<Reduction> {
  return sharedEngine().reduce(mesh, options);
}

/**
 * Resumes a reduction from a checkpoint, in a fraction of the time that a reduction from scratch takes, and gives the same guarantee:
 * every bound holds between the original and the result. That is seldom quite as small and depends on the checkpoint: something
 * to show until the other one is there.
 *
 * The result has neither a map nor errors of vertices, and its errors are upper bounds (`Report.errorsAreUpperBounds`). `options.locked`
 * are indices into the original. The arrays stay the caller's. Rejects as `reduce` does; with the code `bad_checkpoint` where
 * the checkpoint contradicts itself, has spent what the bound of `variable` allows, or lacks a vertex that is locked.
 */
export function resumeReduction(checkpoint: Checkpoint, options: ResumeOptions): Promise<Reduction> {
  return sharedEngine().resumeReduction(checkpoint, options);
}

/**
 * Reduces a mesh to nested levels of detail, one for each of the bounds, finest first: each continues from the one before, so
 * its vertices are a subset of the finer one's, and each keeps its own bounds against the original, as `reduce` guarantees.
 *
 * Runs and rejects as `reduce` does; with the code `bad_levels` where a bound falls from one level to the next or none rises.
 */
export function reduceLevels(mesh: Mesh, options: LevelsOptions): Promise<Levels> {
  return sharedEngine().reduceLevels(mesh, options);
}

/**
 * Cuts a mesh into pieces that the map of its reduction takes linearly into one triangle each: what tells of any point where
 * it went, and from where it came. `reduction` is that of this mesh, with tracked errors: else there is no map, and a
 * TypeError says so. The arrays stay the caller's. Rejects as `reduce` does; with the code `bad_map` where the map is not one
 * from this mesh onto the reduced one.
 */
export function segment(
  mesh: Mesh,
  reduction: Reduction,
  options: { signal?: AbortSignal } = {},
): Promise<Segmentation> {
  return sharedEngine().segment(mesh, reduction, options);
}

/**
 * Judges a reduced surface, whoever made it, by what anyone can see of it: by a judge that uses nothing that reduces, in
 * a WebAssembly module of its own, which is loaded by the first call. Both surfaces are taken as they are in the joint space of
 * position and variables; from many points of each the nearest of the other is looked for, in bounds, and the same of their
 * boundaries. `reduced` has the bounded variables of `original`, in the same order.
 *
 * A ratio above 1 + 1e-6 proves that a bound is broken. One up to that proves that every point looked at is within the bounds; it
 * says nothing of those between them.
 *
 * The arrays stay the caller's. Runs and rejects as `reduce` does; the message says which of the meshes is at fault.
 */
export function verify(original: Mesh, reduced: Mesh, options: VerifyOptions): Promise<Verdict> {
  return sharedEngine().verify(original, reduced, options);
}

/**
 * Checks a mesh and tells what its variables span, without reducing it. Rejects as `reduce` does.
 */
export function inspect(mesh: Mesh, options: { signal?: AbortSignal } = {}): Promise<Inspection> {
  return sharedEngine().inspect(mesh, options);
}
