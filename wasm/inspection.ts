import type { Report, VariableKind } from './types.ts';

/** What a variable's values span, in its unit. A relative bound is a fraction of the extent. */
export interface VariableExtent {
  name: string;
  components: number;
  /** Left out: a quantity. */
  kind?: VariableKind;
  /** Length of the diagonal of the box of the values: max − min for a scalar. */
  extent: number;
  /** Largest absolute value of a component. */
  magnitude: number;
  /** The extent is rounding noise; a relative bound is taken from the magnitude instead. */
  constant: boolean;
}

/** What is known of a valid mesh before it is reduced. */
export interface Inspection {
  triangles: number;
  vertices: number;
  /** Position first, then the mesh's variables in their order. */
  variables: VariableExtent[];
  oddities: Report['oddities'];
}
