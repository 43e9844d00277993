import type { Levels, LevelsOptions, Mesh, Reduction, Report } from '../../../wasm/types.ts';
import { originIn } from '../../formats/file-rounding.ts';
import type { Origin } from '../../formats/gltf/local-origin.ts';
import type { Format } from '../../formats/surface.ts';
import { asBounds } from '../bounds/bound-setting.ts';
import { boundsForFile, isKept, leastMultiplier, reducedWithin, reportInFile } from '../bounds/bounds-for-file.ts';
import type { OpenSurface } from '../reading/open-surface.ts';
import type { Services } from '../services.ts';
import type { Reduced } from '../session-state.ts';
import { resultOf, taskOf } from './task.ts';

/** What goes into a file: one result, or levels of detail. */
export interface ForFile {
  results: { mesh: Mesh; report: Report }[];
  /** From where the file measures places; left out where it chooses that itself. */
  origin?: Origin;
  /** It was reduced again, so that the bounds hold of what is in the file. */
  again: boolean;
}

/** What reduces again. */
export interface Reducers {
  reduce: Services['reduce'];
  reduceLevels(mesh: Mesh, options: LevelsOptions): Promise<Levels>;
}

/**
 * Results, where a file of this format keeps their bounds; else what a reduction leaves that has to keep so much less of them as
 * the format takes. One result is reduced alone, several are levels of detail, finest first. Reports have the errors of the file.
 * Rejects with a FormatError, before anything is reduced, where the format takes too much.
 */
export async function reducedForFile(
  format: Format,
  surface: OpenSurface,
  reduced: readonly Reduced[],
  reducers: Reducers,
): Promise<ForFile> {
  const [{ method, keeping }] = reduced;
  const task = taskOf(surface, method, keeping);
  const least = leastMultiplier(task.mesh, task.options.boundMultiplier);
  const { labels } = surface;
  if (reduced.every(({ result: { mesh, report } }) => isKept(format, mesh, report, least, labels))) {
    const results = reduced.map(({ result: { mesh, report } }) => ({
      mesh,
      report: reportInFile(format, mesh, report, least, labels),
    }));
    return { results, again: false };
  }
  const parts = reduced.map(({ bounds }) => boundsForFile(format, surface.mesh, asBounds(bounds), least, labels));
  const results = await reducedWithin(format, parts, least, async (bounds): Promise<Reduction[]> => {
    if (bounds.length === 1) return [await reducers.reduce(task.mesh, { ...task.options, bounds: bounds[0] })];
    const nested: Levels = await reducers.reduceLevels(task.mesh, { ...task.options, levels: bounds });
    return nested.levels;
  });
  const own = results.map((result) => resultOf(task, result));
  return { results: own, origin: originIn(format, surface.mesh), again: true };
}
