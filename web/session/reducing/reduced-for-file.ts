import type { Mesh } from '../../../wasm/types.ts';
import { originIn } from '../../formats/file-rounding.ts';
import type { Origin } from '../../formats/gltf/local-origin.ts';
import type { Format } from '../../formats/surface.ts';
import { asBounds } from '../bounds/bound-setting.ts';
import { boundsForFile, isKept, leastMultiplier } from '../bounds/bounds-for-file.ts';
import type { OpenSurface } from '../reading/open-surface.ts';
import type { Services } from '../services.ts';
import type { Reduced } from '../session-state.ts';
import { resultOf, taskOf } from './task.ts';

/** What goes into a file. */
export interface ForFile {
  mesh: Mesh;
  /** From where the file measures places; left out where it chooses that itself. */
  origin?: Origin;
}

/**
 * The result, where a file of this format keeps its bounds; else what a reduction leaves that has to keep so much less of them
 * as the format takes. Rejects with a FormatError, before anything is reduced, where the format takes too much.
 */
export async function reducedForFile(
  format: Format,
  surface: OpenSurface,
  { result, bounds, method, keeping }: Reduced,
  reduce: Services['reduce'],
): Promise<ForFile> {
  const task = taskOf(surface, method, keeping);
  const least = leastMultiplier(task.mesh, task.options.boundMultiplier);
  if (isKept(format, result.mesh, result.report, least)) return { mesh: result.mesh };
  const part = boundsForFile(format, surface.mesh, asBounds(bounds), least);
  const again = resultOf(task, await reduce(task.mesh, { ...task.options, bounds: part.bounds }));
  return { mesh: again.mesh, origin: originIn(format, surface.mesh) };
}
