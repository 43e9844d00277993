import { architecture } from './architecture.ts';
import { cells } from './cells.ts';
import { mapping, proportions } from './mapping.ts';
import { propagation } from './propagation.ts';
import { retriangulation, star } from './star.ts';
import { removal, state } from './tracked.ts';

/** By name of its file, what draws each drawing. */
export const drawings = {
  star,
  retriangulation,
  mapping,
  proportions,
  propagation,
  state,
  removal,
  cells,
  architecture,
};
