import type { Mesh, Variable } from '../../wasm/types.ts';
import { FormatError } from './format-error.ts';
import { formatNames } from './format-names.ts';
import { gzip } from './gzip.ts';
import type { Format, WriteOptions } from './surface.ts';
import { withinMemory } from './within-memory.ts';
import { listed, quoted } from './wording.ts';

interface Writer {
  write: (mesh: Mesh, options?: WriteOptions) => Uint8Array | Promise<Uint8Array>;
  /** Variables that the format has no place for. */
  lost: (mesh: Mesh) => Variable[];
  /** Whether numbers go out in single precision, and finite, only. */
  single: boolean;
}

const lossless = { lost: () => [], single: false };

/** One writer a format, each loaded when first asked for. */
const writers: Record<Format, () => Promise<Writer>> = {
  ply: async () => ({ write: (await import('./write-ply.ts')).writePly, ...lossless }),
  vtp: async () => ({ write: (await import('./write-vtp.ts')).writeVtp, ...lossless }),
  vtk: async () => ({ write: (await import('./write-vtk.ts')).writeVtk, ...lossless }),
  obj: async () => {
    const { writeObj, lostInObj } = await import('./write-obj.ts');
    return { write: writeObj, lost: lostInObj, single: false };
  },
  stl: async () => {
    const { writeStl } = await import('./write-stl.ts');
    return { write: writeStl, lost: (mesh) => mesh.variables, single: true };
  },
  glb: async () => {
    const { writeGlb } = await import('./write-glb.ts');
    return { write: writeGlb, lost: () => [], single: true };
  },
};

/**
 * Writes a mesh as a file in memory. PLY, VTP and legacy VTK hold all variables in single and double precision as given,
 * with units and component names; for what others lose ask lossesOf. Throws a FormatError where a format cannot hold a name, size
 * or value; `where` is the variable then.
 */
export async function writeSurface(format: Format, mesh: Mesh, options?: WriteOptions): Promise<Uint8Array> {
  const { write, lost, single } = await writers[format]();
  if (single) requireFinite(format, keptVariables(mesh, lost(mesh)));
  const file = await withinMemory(() => write(mesh, options));
  return options?.gzip ? gzip(file) : file;
}

/** What a file of this format will not hold of the mesh, a sentence each; nothing for PLY, VTP and legacy VTK. */
export async function lossesOf(format: Format, mesh: Mesh): Promise<string[]> {
  const { lost, single } = await writers[format]();
  const sentences: string[] = [];
  const names = lost(mesh).map(({ name }) => name);
  if (names.length > 0) sentences.push(`${formatNames[format]} has no place for the variables ${listed(names)}.`);
  const doubles = keptVariables(mesh, lost(mesh)).filter(({ values }) => values instanceof Float64Array);
  if (single && doubles.length > 0) {
    const rounded = listed(doubles.map(({ name }) => name));
    sentences.push(`${formatNames[format]} knows single precision only; rounded: ${rounded}.`);
  }
  return sentences;
}

/** The geometry and what is not lost. */
function keptVariables({ position, variables }: Mesh, lost: Variable[]): Variable[] {
  return [{ name: 'position', components: 3, values: position }, ...variables.filter((each) => !lost.includes(each))];
}

function requireFinite(format: Format, variables: Variable[]): void {
  for (const { name, values } of variables) {
    const wrong = values.find((value: number) => !Number.isFinite(Math.fround(value)));
    if (wrong === undefined) continue;
    const fault = Number.isFinite(wrong) ? 'which is beyond single precision' : 'which is not finite';
    const message = `${formatNames[format]} cannot hold the value ${wrong} of ${quoted(name)}, ${fault}.`;
    throw new FormatError('not_finite', message, name);
  }
}
