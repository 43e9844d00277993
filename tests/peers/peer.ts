import type { Mesh } from '../../wasm/types.ts';

/** What can be chosen in a run of a peer, beside the number of triangles to leave. */
export interface Setting {
  /** One a variable. At 1 an error of one bound in the variable weighs as much as one of one bound in position. */
  weights: number[];
  /** The peer's options that are on. */
  options: string[];
}

/** A surface that a peer is to simplify. */
export interface Task {
  path: string;
  /** With variables of one component each. */
  mesh: Mesh;
  /** Absolute: of position first, then one a variable. */
  bounds: number[];
}

/** Leaves about `target` triangles, writes the result as PLY to `output` and returns how many there are. */
export type Simplify = (setting: Setting, target: number, output: string) => Promise<number>;

/** Another tool that reduces triangle meshes with data. */
export interface Peer {
  name: string;
  version: string;
  /** Options that can be switched on and off in search of the best. */
  options: string[];
  /** The sets of options to start the search from. */
  starts: string[][];
  /** Triangles that it reduces in a second, more or less: a peer that is quick may run more often. */
  pace: number;
  open(task: Task): Promise<Simplify>;
  close(): void;
}
