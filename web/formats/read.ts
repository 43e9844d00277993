import type { Variable } from '../../wasm/types.ts';
import { gunzip, isGzip } from './bytes/gzip.ts';
import { withinMemory } from './bytes/within-memory.ts';
import { withCrackNotes, withWeldedEnds } from './cracks/cracks.ts';
import { withOpenSeams } from './cracks/open-seams.ts';
import { withJoinedFaces } from './faces/loose-faces.ts';
import { FormatError } from './format-error.ts';
import { formatNames } from './format-names.ts';
import { recognise } from './recognise.ts';
import { stlKind } from './stl/stl-kind.ts';
import { type Beside, type Format, noLabels, type Surface } from './surface.ts';
import { quoted } from './text/wording.ts';
import { identifierNotes, withKinds } from './variables/identifiers.ts';
import { renamedKeys, renamedVariables, reservedNames } from './variables/reserved-names.ts';

/** One reader a format, each loaded when the first file of its format comes. */
const readers: Record<Format, () => Promise<(bytes: Uint8Array, beside?: Beside) => Surface | Promise<Surface>>> = {
  ply: async () => (await import('./ply/read-ply.ts')).readPly,
  vtp: async () => (await import('./vtp/read-vtp.ts')).readVtp,
  vtk: async () => (await import('./legacy-vtk/read-vtk.ts')).readVtk,
  obj: async () => (await import('./obj/read-obj.ts')).readObj,
  stl: async () => (await import('./stl/read-stl.ts')).readStl,
  glb: async () => (await import('./gltf/read-gltf.ts')).readGltf,
};

export interface SurfaceFile extends Surface {
  format: Format;
  /** The notes as one text; empty if there is nothing to say. */
  summary: string;
  /** The surface before faces were joined, where they were: with the points of the file. */
  asRead?: Surface & { format: Format };
  /** What it was read with. */
  options: ReadOptions;
}

export interface ReadOptions {
  /**
   * Points where sheets end that lie within this fraction of the extent of the surface are put into one place, and made one where
   * their values agree as well (see withWeldedEnds). Default: none are.
   */
  weld?: number;
}

/**
 * Reads a surface with its variables from a file in memory, packed by gzip or not, in the browser, a worker or Node. The
 * content decides about the format; `name` serves to say so where its ending claims another, and where the content has no
 * mark. `beside` gives the files that a glTF file names; without it, one that does is refused. Throws a FormatError for whatever is wrong with the file. Values that are NaN or infinite, repeated corners and
 * unused points are passed on: they are the core's to judge.
 */
export async function readSurface(
  name: string,
  bytes: Uint8Array,
  beside?: Beside,
  options: ReadOptions = {},
): Promise<SurfaceFile> {
  const plainName = isGzip(bytes) ? name.replace(/\.gz$/i, '') : name;
  const asRead = await readUnpacked(plainName, await withinMemory(() => unpacked(bytes)), beside);
  return withinMemory(async () => joinedFile(asRead, options));
}

async function unpacked(bytes: Uint8Array): Promise<Uint8Array> {
  return isGzip(bytes) ? gunzip(bytes) : bytes;
}

/** The surface with the variables of a CSV file beside it, packed by gzip or not, a line for each point; see readCsv. */
export async function addVariables(surface: SurfaceFile, csv: Uint8Array): Promise<SurfaceFile> {
  const { readCsv } = await import('./csv/read-csv.ts');
  const { mesh } = surface.asRead ?? surface;
  const added = await withinMemory(async () => readCsv(await unpacked(csv), mesh.position.length / 3));
  const known = new Set([...reservedNames, ...mesh.variables.map(({ name }) => name)]);
  const twice = added.variables.find(({ name }) => known.has(name));
  if (twice) {
    const { name } = twice;
    const why = name === '*' ? 'it stands for all variables' : 'the surface already has one of that name';
    throw new FormatError('duplicate_name', `No variable can be added as ${quoted(name)}: ${why}.`, quoted(name));
  }
  const more = withKinds(added.variables, mesh.triangles);
  const extended = withVariables(surface, (variables) => [...variables, ...more]);
  const notes = [...extended.notes, ...added.notes, ...identifierNotes(more)];
  const units = Object.assign(noLabels().units, surface.units, added.units);
  return { ...extended, units, notes, summary: notes.join(' ') };
}

/** Without the mark that some programs put before a text in UTF-8. */
function withoutByteOrderMark(bytes: Uint8Array): Uint8Array {
  const isMarked = [0xef, 0xbb, 0xbf].every((byte, i) => bytes[i] === byte);
  return isMarked && stlKind(bytes) !== 'binary' ? bytes.slice(3) : bytes;
}

async function readUnpacked(name: string, whole: Uint8Array, beside?: Beside): Promise<Surface & { format: Format }> {
  const bytes = withoutByteOrderMark(whole);
  const format = recognise(bytes, name);
  const read = await readers[format]();
  const surface = withIdentifiers(withoutReservedNames(await withinMemory(async () => read(bytes, beside))));
  return { ...surface, format, notes: [...endingNote(name, format), ...surface.notes] };
}

/** The surface that the core gets, of what a reader left. */
function joinedFile(asRead: Surface & { format: Format }, options: ReadOptions): SurfaceFile {
  const faces = withJoinedFaces(asRead);
  const joined = options.weld === undefined ? faces : withWeldedEnds(faces, options.weld);
  const surface = withCrackNotes(withOpenSeams(joined));
  const file = { ...asRead, ...surface, summary: surface.notes.join(' '), options };
  return joined === asRead ? file : { ...file, asRead };
}

/** The surface with other variables at the points of its file, in which it may hang together otherwise. */
export function withVariables(file: SurfaceFile, change: (variables: Variable[]) => Variable[]): SurfaceFile {
  const changed = <Changed extends Surface>(surface: Changed): Changed => {
    return { ...surface, mesh: { ...surface.mesh, variables: change(surface.mesh.variables) } };
  };
  return file.asRead ? joinedFile(changed(file.asRead), file.options) : changed(file);
}

/** Says which variables are identifiers, of what the reader left open too. */
function withIdentifiers(surface: Surface): Surface {
  const { mesh, notes } = surface;
  const variables = withKinds(mesh.variables, mesh.triangles);
  return { ...surface, mesh: { ...mesh, variables }, notes: [...notes, ...identifierNotes(variables)] };
}

/** A surface with names that its variables may have. */
function withoutReservedNames(surface: Surface): Surface {
  const { mesh, notes, units, componentNames, wholeTypes = {}, roles = {} } = surface;
  const { variables, names, notes: more } = renamedVariables(mesh.variables);
  if (names.size === 0) return surface;
  // What a file says of “position” it says of the geometry.
  const others = new Map([...names].filter(([name]) => name !== 'position'));
  const labels = {
    units: renamedKeys(units, others),
    componentNames: renamedKeys(componentNames, others),
    wholeTypes: renamedKeys(wholeTypes, names),
    roles: renamedKeys(roles, names),
  };
  return { ...surface, ...labels, mesh: { ...mesh, variables }, notes: [...notes, ...more] };
}

function endingNote(name: string, format: Format): string[] {
  const ending = /\.(\w+)$/.exec(name)?.[1]?.toLowerCase();
  if (!ending || ending === format || (ending === 'gltf' && format === 'glb')) return [];
  return [`The name ends in .${ending}, but the content is ${formatNames[format]}; it was read as such.`];
}
