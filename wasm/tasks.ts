import type { Failure } from './errors.ts';
import type { Inspection } from './inspection.ts';
import type {
  Checkpoint,
  Levels,
  LevelsOptions,
  MappedReduction,
  Mesh,
  ReduceOptions,
  Reduction,
  ResumeOptions,
  Segmentation,
  Verdict,
  VerifyOptions,
} from './types.ts';

/** The options that cross to the worker; signal and progress stay with the caller. */
export type CoreOptions = Omit<ReduceOptions, 'signal' | 'onProgress'>;

export type CoreResumeOptions = Omit<ResumeOptions, 'signal' | 'onProgress'>;

export type CoreLevelsOptions = Omit<LevelsOptions, 'signal' | 'onProgress'>;

export type CoreVerifyOptions = Omit<VerifyOptions, 'signal' | 'onProgress'>;

/** What the worker takes for each kind of task, and what that gives when it succeeds. */
interface Tasks {
  reduce: { input: { mesh: Mesh; options: CoreOptions }; value: Reduction };
  resumeReduction: { input: { checkpoint: Checkpoint; options: CoreResumeOptions }; value: Reduction };
  reduceLevels: { input: { mesh: Mesh; options: CoreLevelsOptions }; value: Levels };
  segment: { input: { mesh: Mesh; reduction: MappedReduction }; value: Segmentation };
  verify: { input: { original: Mesh; reduced: Mesh; options: CoreVerifyOptions }; value: Verdict };
  inspect: { input: { mesh: Mesh }; value: Inspection };
}

export type TaskKind = keyof Tasks;

export type Value<Kind extends TaskKind = TaskKind> = Tasks[Kind]['value'];

/** What the worker is asked to do. The arrays of the mesh are transferred. */
export type Task<Kind extends TaskKind = TaskKind> = { [K in Kind]: { kind: K; input: Tasks[K]['input'] } }[Kind];

/** What a task gives: a value, or a fault with its place. */
export type Outcome<Value> = { ok: true; value: Value } | { ok: false; failure: Failure };

/** The end of a task: an outcome of its kind. */
export type Ending<Kind extends TaskKind = TaskKind> = { [K in Kind]: { kind: K; outcome: Outcome<Value<K>> } }[Kind];
