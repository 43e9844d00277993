import type { Report } from '../../../wasm/types.ts';
import { formatNames } from '../../formats/format-names.ts';
import type { Format } from '../../formats/surface.ts';
import { listed } from '../../formats/text/wording.ts';
import { labelsWithMap, takenMapNames, withMap } from '../../formats/variables/map-variables.ts';
import { lossesOf, writeLevels, writeSurface } from '../../formats/write.ts';
import { asBounds } from '../../session/bounds/bound-setting.ts';
import { pointsText } from '../../session/constraints/point-list.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import { type ForFile, type Reducers, reducedForFile } from '../../session/reducing/reduced-for-file.ts';
import { reportJson } from '../../session/report/report-json.ts';
import type { Reduced } from '../../session/session-state.ts';
import { english } from '../../words/english.ts';
import { countText } from '../number-text.ts';
import { savedFileName } from './file-name.ts';

/** What can be saved of a reduction: the surface in each format, the report, the original with the map, all levels of detail. */
export const savedKinds = [...(Object.keys(formatNames) as Format[]), 'report', 'map', 'levels'] as const;
export type SavedKind = (typeof savedKinds)[number];

export interface Saved {
  name: string;
  content: Uint8Array | string;
  /** What the user should know of the file: what it does not hold, that it was reduced again. A sentence each. */
  notes: string[];
  /** Of a surface: its report, with the errors that it has in this file. */
  report?: Report;
}

/** A surface that was saved, and of what. */
export interface SavedSurface {
  of: Reduced;
  name: string;
  report: Report;
}

/** What there is to save. */
export interface Savable {
  surface: OpenSurface;
  reduced: Reduced;
  /** Levels of detail, finest first; empty where there are none. */
  levels: readonly Reduced[];
  /** The surface that was saved last: of the same result, the report is that of its file. */
  last: SavedSurface | null;
}

/**
 * A reduction as a file of this kind, or its levels of detail; reduced anew where the format rounds numbers and the bounds
 * would not hold then. Rejects where the file cannot hold it.
 */
export async function savedFile(kind: SavedKind, savable: Savable, reducers: Reducers): Promise<Saved> {
  if (kind === 'levels') return levelsFile(savable, reducers);
  if (kind === 'map') return mapFile(savable);
  if (kind === 'report') return reportFile(savable);
  const { surface, reduced } = savable;
  const labels = { ...surface.labels, regionName: reduced.keeping.regions ?? undefined };
  const forFile = await reducedForFile(kind, surface, [reduced], reducers);
  const { results, origin } = forFile;
  const [{ mesh, report }] = results;
  const content = await writeSurface(kind, mesh, { ...labels, origin });
  const losses = await lossesOf(kind, mesh, { ...labels, origin });
  const notes = [...againNotes(kind, forFile, [reduced]), ...losses];
  return { name: savedFileName(surface.name, 'reduced', kind), content, notes, report };
}

/** Says that a file holds another surface than is shown, and why. */
function againNotes(format: Format, { again, results }: ForFile, shown: readonly Reduced[]): string[] {
  if (!again) return [];
  const counts = (reports: Report[]) => reports.map(({ triangles }) => countText(triangles.after)).join(', ');
  const [there, here] = [counts(results.map(({ report }) => report)), counts(shown.map(({ result }) => result.report))];
  return [english.save.again(formatNames[format], there, here)];
}

function reportFile({ surface, reduced, last }: Savable): Saved {
  const inFile = last?.of === reduced ? last : null;
  const content = reportOf(inFile?.report ?? reduced.result.report, reduced, inFile?.name);
  return { name: savedFileName(surface.name, 'report', 'json'), content, notes: [] };
}

function reportOf(report: Report, { bounds, method, keeping }: Reduced, file?: string): string {
  const { regions: region, lockBox, lockRegions, boundMultiplier, focusPoint } = keeping;
  const lockPoints = keeping.lockPoints.length > 0 ? [pointsText(keeping.lockPoints)] : [];
  const kept = { region, lockRegions, lockBoxes: lockBox ? [lockBox] : [], lockPoints, boundMultiplier, focusPoint };
  return reportJson(report, { ...method, ...kept, bounds: asBounds(bounds) }, { file });
}

/** As one GLB file, which holds all of them. */
async function levelsFile({ surface, levels }: Savable, reducers: Reducers): Promise<Saved> {
  const { name, labels } = surface;
  if (levels.length === 0) throw new Error(english.faults.noLevels);
  const forFile = await reducedForFile('glb', surface, levels, reducers);
  const { results, origin } = forFile;
  const content = await writeLevels(results, { ...labels, origin });
  const losses = await lossesOf('glb', results[0].mesh, { ...labels, origin });
  return {
    name: savedFileName(name, 'levels', 'glb'),
    content,
    notes: [...againNotes('glb', forFile, levels), ...losses],
  };
}

/** As VTP, which holds doubles, and which the programs of the field read. */
async function mapFile({ surface, reduced: { result, keeping } }: Savable): Promise<Saved> {
  const { name, mesh, labels, regions } = surface;
  if (!result.map) throw new Error(english.faults.noMap);
  const taken = takenMapNames(mesh);
  if (taken.length > 0) throw new Error(english.faults.namesTaken(listed(taken)));
  const regionName = keeping.regions ?? undefined;
  const parted = { ...mesh, regions: regions?.get(regionName ?? '') };
  const content = await writeSurface('vtp', withMap(parted, result), { ...labelsWithMap(labels), regionName });
  return { name: savedFileName(name, 'map', 'vtp'), content, notes: [] };
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
