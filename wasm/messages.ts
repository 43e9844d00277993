import type { Failure } from './errors.ts';
import type { Inspection } from './inspection.ts';
import type {
  Levels,
  LevelsOptions,
  MappedReduction,
  Mesh,
  OnwardOptions,
  ReduceOptions,
  Reduction,
  Segmentation,
  Waypoint,
} from './types.ts';

/** The options that cross to the worker; signal and progress stay with the caller. */
export type CoreOptions = Omit<ReduceOptions, 'signal' | 'onProgress'>;

export type CoreOnwardOptions = Omit<OnwardOptions, 'signal' | 'onProgress'>;

export type CoreLevelsOptions = Omit<LevelsOptions, 'signal' | 'onProgress'>;

/** What the worker is asked to do. The arrays of the mesh are transferred. */
export type Task =
  | { kind: 'reduce'; mesh: Mesh; options: CoreOptions }
  | { kind: 'reduceOnward'; waypoint: Waypoint; options: CoreOnwardOptions }
  | { kind: 'reduceLevels'; mesh: Mesh; options: CoreLevelsOptions }
  | { kind: 'segment'; mesh: Mesh; reduction: MappedReduction }
  | { kind: 'inspect'; mesh: Mesh };

/** What a task gives when it succeeds. */
export type Value = Reduction | Levels | Segmentation | Inspection;

/** What a task gives: a value, or a fault with its place. */
export type Outcome<Value> = { ok: true; value: Value } | { ok: false; failure: Failure };

/** To the worker: one task at a time. `cancel`, where memory can be shared, is raised to stop it. */
export interface Request {
  task: Task;
  cancel?: Int32Array<SharedArrayBuffer>;
}

/** From the worker: any number of progress messages, then the outcome, with how much memory the worker holds by now. */
export type Answer = { progress: number } | { outcome: Outcome<Value>; memory: number };
