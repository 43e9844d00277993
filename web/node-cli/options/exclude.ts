import { withVariables } from '../../formats/read.ts';
import { UsageFault } from '../fault.ts';
import type { OpenedSurface } from '../files/surface-files.ts';
import { requireKnown } from './bound-arguments.ts';

/** The surface without these variables. Throws a Fault where one does not exist or cannot be left out. */
export function without(names: readonly string[], surface: OpenedSurface): OpenedSurface {
  requireKnown(names, surface);
  if (names.includes('position')) throw new UsageFault('--exclude: the position cannot be left out.');
  if (names.length === 0) return surface;
  return {
    ...withVariables(surface, (variables) => variables.filter(({ name }) => !names.includes(name))),
    path: surface.path,
  };
}
