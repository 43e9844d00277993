import type { NonFinite, Report, VariableKind } from './types.ts';

/**
 * What a variable's values span where triangles are, in its unit, as far as they are numbers. A relative bound is a fraction of
 * the extent.
 */
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
  /** Left out where all values are numbers; else the variable must be free. */
  nonFinite?: NonFinite;
}

/** What is known of a valid mesh before it is reduced. */
export interface Inspection {
  triangles: number;
  vertices: number;
  /** Position first, then the mesh's variables in their order. */
  variables: VariableExtent[];
  defects: Report['defects'];
}
