import type { Mesh, VariableExtent } from '../../../wasm/index.ts';
import type { Labels } from '../../formats/surface.ts';

/** Where a surface comes from. */
export interface Source {
  /** For people: the name of the file. */
  name: string;
  /** The address that it was loaded from; null for a file of the user. */
  address: string | null;
}

/** A surface that passed validation. */
export interface OpenSurface extends Source {
  mesh: Mesh;
  /** Units and names of components, where the file states them. */
  labels: Labels;
  /** Position first, then the mesh's variables in their order. */
  variables: VariableExtent[];
  /** Vertices that must stay, because sheets only touch there. */
  locked: Uint32Array | undefined;
  /** Labels of the triangles, by the cell data that hold them. */
  regions?: ReadonlyMap<string, Int32Array>;
}
