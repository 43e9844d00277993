import type { Levels, Mesh } from '../../wasm/index.ts';
import { lossesOf } from '../formats/write.ts';
import { writeGlbLevels } from '../formats/write-glb-levels.ts';
import type { StagedFiles } from './staged-files.ts';
import { encodeSurface, type OpenedSurface } from './surface-files.ts';

/** What a file does not hold, a sentence each, by its path. */
export type FileNotes = [path: string, notes: string[]];

/** Writes levels to their files: one each, or all to one GLB file. */
export async function writeLevelFiles(
  files: StagedFiles,
  paths: string[],
  { levels }: Levels,
  surface: OpenedSurface,
): Promise<FileNotes[]> {
  if (paths.length < levels.length) return [await writeTogether(files, paths[0], { levels, morphs: [] }, surface)];
  const notes: FileNotes[] = [];
  for (const [i, path] of paths.entries()) {
    const { bytes, losses } = await encodeSurface(path, levels[i].mesh, surface);
    await files.write(path, bytes);
    notes.push([path, losses]);
  }
  return notes;
}

async function writeTogether(
  files: StagedFiles,
  path: string,
  { levels }: Levels,
  { units, componentNames }: OpenedSurface,
): Promise<FileNotes> {
  const parts = levels.map(({ mesh, report }) => ({ mesh, error: relativeError(report.variables[0]) }));
  const gzip = /\.gz$/i.test(path);
  await files.write(path, await writeGlbLevels(parts, { units, componentNames, gzip }));
  return [path, await lossesOf('glb', levels[0].mesh as Mesh)];
}

/** The geometric error as a fraction of the extent: known whether or not it was bounded. */
function relativeError({ error, extent }: { error: number; extent: number }): number | undefined {
  return extent > 0 ? error / extent : undefined;
}
