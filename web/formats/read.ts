import { FormatError } from './format-error.ts';
import { formatNames } from './format-names.ts';
import { gunzip, isGzip } from './gzip.ts';
import { withOpenSeams } from './open-seams.ts';
import { recognise } from './recognise.ts';
import { type Beside, type Format, noLabels, type Surface } from './surface.ts';
import { withinMemory } from './within-memory.ts';
import { quoted } from './wording.ts';

/** One reader a format, each loaded when the first file of its format comes. */
const readers: Record<Format, () => Promise<(bytes: Uint8Array, beside?: Beside) => Surface | Promise<Surface>>> = {
  ply: async () => (await import('./read-ply.ts')).readPly,
  vtp: async () => (await import('./read-vtp.ts')).readVtp,
  vtk: async () => (await import('./read-vtk.ts')).readVtk,
  obj: async () => (await import('./read-obj.ts')).readObj,
  stl: async () => (await import('./read-stl.ts')).readStl,
  glb: async () => (await import('./read-gltf.ts')).readGltf,
};

export interface SurfaceFile extends Surface {
  format: Format;
  /** The notes as one text; empty if there is nothing to say. */
  summary: string;
}

/**
 * Reads a surface with its variables from a file in memory, packed by gzip or not, in the browser, a worker or Node. The
 * content decides about the format; `name` serves to say so where its ending claims another, and where the content has no
 * mark. `beside` gives the files that a glTF file names; without it, one that does is refused. Throws a FormatError for whatever is wrong with the file. Values that are NaN or infinite, repeated corners and
 * unused points are passed on: they are the core's to judge.
 */
export async function readSurface(name: string, bytes: Uint8Array, beside?: Beside): Promise<SurfaceFile> {
  const plainName = isGzip(bytes) ? name.replace(/\.gz$/i, '') : name;
  return readUnpacked(plainName, await withinMemory(() => unpacked(bytes)), beside);
}

async function unpacked(bytes: Uint8Array): Promise<Uint8Array> {
  return isGzip(bytes) ? gunzip(bytes) : bytes;
}

/** The surface with the variables of a CSV file beside it, packed by gzip or not, a line for each point; see readCsv. */
export async function addVariables(surface: SurfaceFile, csv: Uint8Array): Promise<SurfaceFile> {
  const { readCsv } = await import('./read-csv.ts');
  const { mesh } = surface;
  const added = await withinMemory(async () => readCsv(await unpacked(csv), mesh.position.length / 3));
  const known = new Set([geometry, ...mesh.variables.map(({ name }) => name)]);
  const twice = added.variables.find(({ name }) => known.has(name));
  if (twice) {
    throw new FormatError(
      'duplicate_name',
      `The surface already has a variable named ${quoted(twice.name)}.`,
      quoted(twice.name),
    );
  }
  const notes = [...surface.notes, ...added.notes];
  const units = Object.assign(noLabels().units, surface.units, added.units);
  const variables = [...mesh.variables, ...added.variables];
  return { ...surface, mesh: { ...mesh, variables }, units, notes, summary: notes.join(' ') };
}

async function readUnpacked(name: string, bytes: Uint8Array, beside?: Beside): Promise<SurfaceFile> {
  const format = recognise(bytes, name);
  const read = await readers[format]();
  const surface = withoutGeometryName(await withinMemory(async () => withOpenSeams(await read(bytes, beside))));
  const notes = [...endingNote(name, format), ...surface.notes];
  return { ...surface, format, notes, summary: notes.join(' ') };
}

/** What the geometry is called among the variables. */
const geometry = 'position';

/** No variable can be called as the geometry is; one that is gets another name, and this is said. */
function withoutGeometryName(surface: Surface): Surface {
  const { mesh, notes } = surface;
  const names = new Set(mesh.variables.map(({ name }) => name));
  if (!names.has(geometry)) return surface;
  let free = `${geometry}_2`;
  for (let copy = 3; names.has(free); copy++) free = `${geometry}_${copy}`;
  const variables = mesh.variables.map((each) => (each.name === geometry ? { ...each, name: free } : each));
  const note = `The variable ${quoted(geometry)} is called ${quoted(free)} from here on: ${quoted(geometry)} is the geometry.`;
  return { ...surface, mesh: { ...mesh, variables }, notes: [...notes, note] };
}

function endingNote(name: string, format: Format): string[] {
  const ending = /\.(\w+)$/.exec(name)?.[1]?.toLowerCase();
  if (!ending || ending === format || (ending === 'gltf' && format === 'glb')) return [];
  return [`The name ends in .${ending}, but the content is ${formatNames[format]}; it was read as such.`];
}
