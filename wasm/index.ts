import { checkMap, checkMesh, checkVertices, copyMap, copyMesh } from './copy-mesh.ts';
import type { Inspection } from './inspection.ts';
import { TaskQueue } from './task-queue.ts';
import type {
  Levels,
  LevelsOptions,
  Mesh,
  OnwardOptions,
  ReduceOptions,
  Reduction,
  Segmentation,
  Waypoint,
} from './types.ts';

export { type ErrorCode, type Failure, MeshboundError } from './errors.ts';
export type { Inspection, VariableExtent } from './inspection.ts';
export type * from './types.ts';

const queue = new TaskQueue();

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
export async function reduce(mesh: Mesh, options: ReduceOptions): Promise<Reduction> {
  const { signal, onProgress, locked, transfer, ...rest } = options;
  checkMesh(mesh);
  const task = {
    kind: 'reduce',
    mesh: transfer ? mesh : copyMesh(mesh),
    options: { ...rest, locked: locked?.slice() },
  } as const;
  return (await queue.run(task, { signal, onProgress })) as Reduction;
}

/**
 * Reduces onward from a waypoint, in a fraction of the time that a reduction from scratch takes, and keeps the same promise:
 * every bound holds between the original and the result. That is seldom quite as small and depends on the waypoint: something
 * to show until the other one is there.
 *
 * The result has neither a map nor errors of vertices, and its errors are upper bounds (`Report.summed`). `options.locked`
 * are indices into the original. The arrays stay the caller's. Rejects as `reduce` does; with the code `bad_waypoint` where
 * the waypoint contradicts itself, has spent what the bound of `variable` allows, or lacks a vertex that is locked.
 */
export async function reduceOnward(waypoint: Waypoint, options: OnwardOptions): Promise<Reduction> {
  const { signal, onProgress, locked, ...rest } = options;
  const { mesh, vertices, report } = waypoint;
  checkMesh(mesh);
  checkVertices(vertices);
  const task = {
    kind: 'reduceOnward',
    waypoint: { mesh: copyMesh(mesh), vertices: vertices.slice(), report },
    options: { ...rest, locked: locked?.slice() },
  } as const;
  return (await queue.run(task, { signal, onProgress })) as Reduction;
}

/**
 * Reduces a mesh to nested levels of detail, one for each of the bounds, finest first: each continues from the one before, so
 * its vertices are a subset of the finer one's, and each keeps its own bounds against the original, as `reduce` promises.
 *
 * Runs and rejects as `reduce` does; with the code `bad_levels` where a bound falls from one level to the next or none rises.
 */
export async function reduceLevels(mesh: Mesh, options: LevelsOptions): Promise<Levels> {
  const { signal, onProgress, locked, transfer, ...rest } = options;
  checkMesh(mesh);
  const task = {
    kind: 'reduceLevels',
    mesh: transfer ? mesh : copyMesh(mesh),
    options: { ...rest, locked: locked?.slice() },
  } as const;
  return (await queue.run(task, { signal, onProgress })) as Levels;
}

/**
 * Cuts a mesh into pieces that the map of its reduction takes linearly into one triangle each: what tells of any point where
 * it went, and from where it came. `reduction` is that of this mesh, with tracked errors: else there is no map, and a
 * TypeError says so. The arrays stay the caller's. Rejects as `reduce` does; with the code `bad_map` where the map is not one
 * from this mesh onto the reduced one.
 */
export async function segment(
  mesh: Mesh,
  reduction: Reduction,
  { signal }: { signal?: AbortSignal } = {},
): Promise<Segmentation> {
  const { vertices, map } = reduction;
  checkMesh(mesh);
  checkMesh(reduction.mesh);
  checkVertices(vertices);
  if (map) checkMap(map);
  if (!map?.triangle.length) throw new TypeError('The reduction has no map: only tracked errors make one.');
  const task = {
    kind: 'segment',
    mesh: copyMesh({ ...mesh, variables: [] }),
    reduction: {
      mesh: copyMesh({ ...reduction.mesh, variables: [] }),
      vertices: vertices.slice(),
      map: copyMap(map),
    },
  } as const;
  return (await queue.run(task, { signal })) as Segmentation;
}

/**
 * Checks a mesh and tells what its variables span, without reducing it. Rejects as `reduce` does.
 */
export async function inspect(mesh: Mesh, { signal }: { signal?: AbortSignal } = {}): Promise<Inspection> {
  checkMesh(mesh);
  return (await queue.run({ kind: 'inspect', mesh: copyMesh(mesh) }, { signal })) as Inspection;
}
