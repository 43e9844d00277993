import type { Mesh } from '../../wasm/types.ts';
import type { Origin } from './gltf/local-origin.ts';
import type { Role } from './variables/roles.ts';
import type { WholeType } from './variables/whole-types.ts';

/** The formats that are read and written, by the usual ending of their names. */
export type Format = 'ply' | 'vtp' | 'vtk' | 'obj' | 'stl' | 'glb';

/** What a file says of its variables beside their values. Keys are variable names; `position` is the geometry. */
export interface Labels {
  /** Units as written in the file: `{ pressure: 'Pa' }`. */
  units: Record<string, string>;
  /** What the components of a variable are called, one name each. */
  componentNames: Record<string, string[]>;
  /** The types of the variables that the file holds as whole numbers. */
  wholeTypes?: Record<string, WholeType>;
  /** What the file declares its variables to be, whatever they are called. */
  roles?: Record<string, Role>;
  /** What labels of triangles stand for, by the arrays that hold them, where the file has names for that. */
  regionNames?: ReadonlyMap<string, ReadonlyMap<number, string>>;
}

/** What can part a surface into regions, and what cannot. */
export interface CellLabels {
  /** Labels of the triangles, by the names of the cell-data arrays that hold them. */
  regions: ReadonlyMap<string, Int32Array>;
  /** Why other arrays of one number a cell cannot be labels, by their names: a clause each. */
  unfitRegions: ReadonlyMap<string, string>;
}

/** Where sheets end beside each other within rounding. */
export interface Crack {
  /** A sentence that says where, and how wide. */
  note: string;
  /** The weld that closes it, as a fraction of the extent. */
  weld: number;
}

/** What a reader hands over. */
export interface Surface extends Labels, Partial<CellLabels> {
  mesh: Mesh;
  /** What the user should know of the reading: what was changed, what is not carried. One sentence each. */
  notes: string[];
  /** Points where sheets touch and no seam joins them; unless these stay (ReduceOptions.locked), gaps open. */
  locked?: Uint32Array;
  /** How many points are on seams, where several lie in one place and are reduced together. */
  seamPoints?: number;
  /** Its sentence is among the notes, too. */
  crack?: Crack;
}

/** Gives the bytes of a file that another one names, by its path relative to that one; throws where there is none. */
export type Beside = (path: string) => Promise<Uint8Array>;

export interface WriteOptions extends Partial<Labels> {
  /** What the array of the mesh's regions is called. Default: regions. */
  regionName?: string;
  /** More labels of the triangles, by the names of their arrays. */
  cellData?: CellLabels['regions'];
  /** GLB only: where the node of the mesh is moved to, from where its places are measured. Default: localOrigin. */
  origin?: Origin;
  /** Packed by gzip, for a name that ends in .gz. Default: no. */
  gzip?: boolean;
  /** PLY only. Default: binary little endian. */
  encoding?: 'ascii' | 'binary_little_endian' | 'binary_big_endian';
}

/** Labels without any; their keys come from files, so they have no prototype that a name could reach. */
export function noLabels(): Labels {
  return { units: Object.create(null), componentNames: Object.create(null) };
}
