import type { Reduction } from '../../../wasm/index.ts';
import { lossesOf, writeLevels } from '../../formats/write.ts';
import type { StagedFiles } from './staged-files.ts';
import { encodeSurface, named, type OpenedSurface } from './surface-files.ts';

/** What a file does not hold, a sentence each, by its path. */
export type FileNotes = [path: string, notes: string[]];

/** Writes levels to their files: one each, or all to one GLB file. */
export async function writeLevelFiles(
  files: StagedFiles,
  paths: string[],
  levels: Reduction[],
  surface: OpenedSurface,
): Promise<FileNotes[]> {
  if (paths.length < levels.length) return [await writeTogether(files, paths[0], levels, surface)];
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
  levels: Reduction[],
  { units, componentNames, roles, origin }: OpenedSurface,
): Promise<FileNotes> {
  const gzip = /\.gz$/i.test(path);
  const bytes = await named(path, () => writeLevels(levels, { units, componentNames, roles, gzip, origin }));
  await files.write(path, bytes);
  return [path, await lossesOf('glb', levels[0].mesh, { roles, origin })];
}
