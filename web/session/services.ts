import type { Inspection, Mesh, ReduceOptions, Reduction } from '../../wasm/index.ts';
import type { OpenedFile } from './read.ts';

/** A surface that comes with the page. */
export interface Sample {
  name: string;
  title: string;
  /** Where its file is, relative to the page. */
  url: string;
}

/** What a session needs of the world around it; tests give it other ones. */
export interface Services {
  /** Rejects with an error that has a `code`, and a `variable` where one is at fault. */
  inspect(mesh: Mesh): Promise<Inspection>;
  reduce(mesh: Mesh, options: ReduceOptions): Promise<Reduction>;
  read(name: string, bytes: Uint8Array<ArrayBuffer>): Promise<OpenedFile>;
  fetchBytes(url: string): Promise<Uint8Array<ArrayBuffer>>;
}
