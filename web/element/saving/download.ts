import type { Levels } from '../../../wasm/types.ts';
import { formatNames } from '../../formats/format-names.ts';
import type { Format } from '../../formats/surface.ts';
import { listed } from '../../formats/text/wording.ts';
import { labelsWithMap, takenMapNames, withMap } from '../../formats/variables/map-variables.ts';
import { lossesOf, writeLevels, writeSurface } from '../../formats/write.ts';
import { asBounds } from '../../session/bounds/bound-setting.ts';
import { leastMultiplier, requireKept } from '../../session/bounds/bounds-for-file.ts';
import { pointsText } from '../../session/constraints/point-list.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import { reducedForFile } from '../../session/reducing/reduced-for-file.ts';
import { taskOf } from '../../session/reducing/task.ts';
import { reportJson } from '../../session/report/report-json.ts';
import type { Services } from '../../session/services.ts';
import type { Reduced } from '../../session/session-state.ts';
import { english } from '../../words/english.ts';
import { savedFileName } from './file-name.ts';

/** What can be saved of a reduction: the surface in each format, the report, the original with the map, all levels of detail. */
export const savedKinds = [...(Object.keys(formatNames) as Format[]), 'report', 'map', 'levels'] as const;
export type SavedKind = (typeof savedKinds)[number];

interface Saved {
  name: string;
  content: Uint8Array | string;
  /** What the file does not hold, a sentence each. */
  losses: string[];
}

/**
 * A reduction as a file of this kind, or its levels of detail; reduced anew where the format rounds numbers and the bounds
 * would not hold then. Rejects where the file cannot hold it.
 */
export async function savedFile(
  surface: OpenSurface,
  reduced: Reduced,
  levels: Levels | null,
  kind: SavedKind,
  reduce: Services['reduce'],
): Promise<Saved> {
  if (kind === 'levels') return levelsFile(surface, reduced, levels);
  if (kind === 'map') return mapFile(surface, reduced);
  if (kind === 'report') {
    return { name: savedFileName(surface.name, 'report', 'json'), content: reportOf(reduced), losses: [] };
  }
  const labels = { ...surface.labels, regionName: reduced.keeping.regions ?? undefined };
  const { mesh, origin } = await reducedForFile(kind, surface, reduced, reduce);
  const content = await writeSurface(kind, mesh, { ...labels, origin });
  return {
    name: savedFileName(surface.name, 'reduced', kind),
    content,
    losses: await lossesOf(kind, mesh, { ...labels, origin }),
  };
}

function reportOf({ result, bounds, method, keeping }: Reduced): string {
  const { regions: region, lockBox, lockRegions, boundMultiplier, focusPoint } = keeping;
  const lockPoints = keeping.lockPoints.length > 0 ? [pointsText(keeping.lockPoints)] : [];
  const kept = { region, lockRegions, lockBoxes: lockBox ? [lockBox] : [], lockPoints, boundMultiplier, focusPoint };
  return reportJson(result.report, { ...method, ...kept, bounds: asBounds(bounds) });
}

/** As one GLB file, which holds all of them. */
async function levelsFile(surface: OpenSurface, reduced: Reduced, levels: Levels | null): Promise<Saved> {
  const { name, labels } = surface;
  if (!levels) throw new Error(english.faults.noLevels);
  const { mesh: asked, options } = taskOf(surface, reduced.method, reduced.keeping);
  const least = leastMultiplier(asked, options.boundMultiplier);
  for (const { mesh, report } of levels.levels) requireKept('glb', mesh, report, least);
  const content = await writeLevels(levels, labels);
  const losses = await lossesOf('glb', levels.levels[0].mesh, labels);
  return { name: savedFileName(name, 'levels', 'glb'), content, losses };
}

/** As VTP, which holds doubles, and which the programs of the field read. */
async function mapFile({ name, mesh, labels, regions }: OpenSurface, { result, keeping }: Reduced): Promise<Saved> {
  if (!result.map) throw new Error(english.faults.noMap);
  const taken = takenMapNames(mesh);
  if (taken.length > 0) throw new Error(english.faults.namesTaken(listed(taken)));
  const regionName = keeping.regions ?? undefined;
  const parted = { ...mesh, regions: regions?.get(regionName ?? '') };
  const content = await writeSurface('vtp', withMap(parted, result), { ...labelsWithMap(labels), regionName });
  return { name: savedFileName(name, 'map', 'vtp'), content, losses: [] };
}

/** Offers a file as a download. */
export function download(name: string, content: Blob | Uint8Array | string): void {
  const blob = content instanceof Blob ? content : new Blob([content as Uint8Array<ArrayBuffer> | string]);
  const address = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  // The download has its own hold on the data once it has started.
  setTimeout(() => URL.revokeObjectURL(address));
}
