import type { Checkpoint, Inspection, Mesh, ReduceOptions, Reduction, ResumeOptions } from '../../wasm/index.ts';
import type { ReadOptions } from '../formats/read.ts';
import type { NamedFile } from '../formats/read-together.ts';
import type { OpenedFile } from './reading/read.ts';
import type { Watchers } from './watchers.ts';

/** What a session needs of the world around it; tests give it other ones. */
export interface Services {
  /** Rejects with an error that has a `code`, and a `variable` where one is at fault. */
  inspect(mesh: Mesh, watchers?: Watchers): Promise<Inspection>;
  reduce(mesh: Mesh, options: ReduceOptions): Promise<Reduction>;
  resumeReduction(checkpoint: Checkpoint, options: ResumeOptions): Promise<Reduction>;
  /** `beside` are the files that were chosen together with this one. */
  read(
    name: string,
    bytes: Uint8Array<ArrayBuffer>,
    watchers?: Watchers,
    beside?: NamedFile[],
    options?: ReadOptions,
  ): Promise<OpenedFile>;
  fetchBytes(address: string, watchers?: Watchers): Promise<Uint8Array<ArrayBuffer>>;
}
