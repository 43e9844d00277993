import { requireKnown } from './bound-arguments.ts';
import { UsageFault } from './fault.ts';
import type { OpenedSurface } from './surface-files.ts';

/** The surface without these variables. Throws a Fault where one does not exist or cannot be left out. */
export function without(names: readonly string[], surface: OpenedSurface): OpenedSurface {
  requireKnown(names, surface);
  if (names.includes('position')) throw new UsageFault('--exclude: the position cannot be left out.');
  const variables = surface.mesh.variables.filter(({ name }) => !names.includes(name));
  return { ...surface, mesh: { ...surface.mesh, variables } };
}
