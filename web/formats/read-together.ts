import { FormatError } from './format-error.ts';
import { addVariables, type ReadOptions, readSurface, type SurfaceFile } from './read.ts';
import { listed, quoted } from './text/wording.ts';

/** A file in memory by its name alone. */
export interface NamedFile {
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
}

const tables = /\.csv(\.gz)?$/i;

/**
 * Reads a surface and the files that were chosen together with it: CSV files add variables, and a glTF file finds the
 * files that it names, whatever folders it thinks them in. Files that have no part in the surface are named in the notes.
 */
export async function readTogether(
  name: string,
  bytes: Uint8Array,
  others: readonly NamedFile[],
  options: ReadOptions = {},
): Promise<SurfaceFile> {
  const unused = new Set(others);
  const beside = async (path: string) => {
    const file = others.find((other) => other.name === path.split('/').at(-1));
    if (!file) {
      const message = `The file refers to ${quoted(path)}, which is not at hand. Open both together, or save it as GLB.`;
      throw new FormatError('unsupported_feature', message);
    }
    unused.delete(file);
    return file.bytes;
  };
  let surface = await readSurface(name, bytes, beside, options);
  for (const table of others.filter((other) => tables.test(other.name))) {
    surface = await withTable(surface, table);
    unused.delete(table);
  }
  const notes = [...surface.notes, ...unusedNotes([...unused])];
  return { ...surface, notes, summary: notes.join(' ') };
}

async function withTable(surface: SurfaceFile, { name, bytes }: NamedFile): Promise<SurfaceFile> {
  try {
    return await addVariables(surface, bytes);
  } catch (error) {
    if (!(error instanceof FormatError)) throw error;
    throw new FormatError(error.code, `${quoted(name)}: ${error.message}`, error.where);
  }
}

function unusedNotes(files: NamedFile[]): string[] {
  if (files.length === 0) return [];
  const names = listed(files.map(({ name }) => name));
  return [
    `Not opened with it: ${names}. One surface is opened at a time; what can be opened with it are CSV files that hold variables of its points, and files that it refers to.`,
  ];
}
