import type { Inspection, Mesh, ReduceOptions, Reduction } from '../../wasm/index.ts';
import type { OpenedFile } from './read.ts';

/** What a session needs of the world around it; tests give it other ones. */
export interface Services {
  /** Rejects with an error that has a `code`, and a `variable` where one is at fault. */
  inspect(mesh: Mesh): Promise<Inspection>;
  reduce(mesh: Mesh, options: ReduceOptions): Promise<Reduction>;
  read(name: string, bytes: Uint8Array<ArrayBuffer>): Promise<OpenedFile>;
  fetchBytes(address: string): Promise<Uint8Array<ArrayBuffer>>;
}
