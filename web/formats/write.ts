import type { Mesh, Reduction, Variable, VariableReport } from '../../wasm/types.ts';
import { gzip } from './bytes/gzip.ts';
import { withinMemory } from './bytes/within-memory.ts';
import { gather } from './cracks/weld.ts';
import { roundingsOf } from './file-rounding.ts';
import { FormatError } from './format-error.ts';
import { formatNames } from './format-names.ts';
import { labelArrays } from './regions/label-arrays.ts';
import type { Format, Labels, WriteOptions } from './surface.ts';
import { counted, listed, quoted } from './text/wording.ts';
import { noLongerWhole } from './variables/whole-numbers.ts';

interface Writer {
  write: (mesh: Mesh, options?: WriteOptions) => Uint8Array | Promise<Uint8Array>;
  /** Variables that the format has no place for. */
  lost: (mesh: Mesh, labels: LabelNames) => Variable[];
  /** Variables with a role whose place in the format their values do not fit. */
  unfit: (mesh: Mesh, labels: LabelNames) => Variable[];
  /** Whether numbers go out in single precision, and finite, only. */
  single: boolean;
  /** Whether units and component names have a place. */
  labels: boolean;
  /** The arrays of labels of triangles that have a place. */
  heldLabels: (mesh: Mesh, labels: LabelNames) => string[];
  /** Whether names of such labels have a place. */
  regionNames: boolean;
  /** Whether a variable may have an empty name. */
  nameless: boolean;
}

const allLabels = (mesh: Mesh, labels: LabelNames) => labelArrays(mesh, labels).map(([name]) => name);
const none = () => [];

const lossless = {
  lost: none,
  unfit: none,
  single: false,
  labels: true,
  heldLabels: allLabels,
  regionNames: false,
  nameless: false,
};

/** One writer a format, each loaded when first asked for. */
const writers: Record<Format, () => Promise<Writer>> = {
  ply: async () => ({ write: (await import('./ply/write-ply.ts')).writePly, ...lossless, nameless: true }),
  vtp: async () => ({ write: (await import('./vtp/write-vtp.ts')).writeVtp, ...lossless }),
  vtk: async () => ({ write: (await import('./legacy-vtk/write-vtk.ts')).writeVtk, ...lossless }),
  obj: async () => {
    const { writeObj, lostInObj, materialArray } = await import('./obj/write-obj.ts');
    return {
      write: writeObj,
      lost: lostInObj,
      unfit: none,
      single: false,
      labels: false,
      heldLabels: (mesh, labels) => [materialArray(mesh, labels)].filter((name) => name !== undefined),
      regionNames: true,
      nameless: true,
    };
  },
  stl: async () => {
    const { writeStl } = await import('./stl/write-stl.ts');
    return {
      write: writeStl,
      lost: (mesh) => mesh.variables,
      unfit: none,
      single: true,
      labels: false,
      heldLabels: none,
      regionNames: false,
      nameless: true,
    };
  },
  glb: async () => {
    const [{ writeGlb }, { unfitInGltf }] = await Promise.all([
      import('./gltf/write-glb.ts'),
      import('./gltf/gltf-variables.ts'),
    ]);
    return {
      write: writeGlb,
      lost: none,
      unfit: unfitInGltf,
      single: true,
      labels: true,
      heldLabels: none,
      regionNames: false,
      nameless: false,
    };
  },
};

/**
 * Writes a mesh as a file in memory. PLY, VTP and legacy VTK hold all variables in single and double precision as given,
 * with units and component names, and labels of triangles; for what others lose ask lossesOf. Throws a FormatError where a format cannot hold a name, size
 * or value; `where` is the variable then.
 */
export async function writeSurface(format: Format, mesh: Mesh, options?: WriteOptions): Promise<Uint8Array> {
  const writer = await writers[format]();
  requirePlace(format, mesh, writer, options ?? {});
  const held = withPoints(mesh, writtenPoints(format, mesh));
  const file = await withinMemory(() => writer.write(held, options));
  return options?.gzip ? gzip(file) : file;
}

/** A level of detail as it goes into a file. */
type LevelOfFile = Pick<Reduction, 'mesh' | 'report'>;

/** Writes nested levels of detail as one GLB file (see writeGlbLevels), of which the same holds. */
export async function writeLevels(levels: LevelOfFile[], options?: WriteOptions): Promise<Uint8Array> {
  const writer = await writers.glb();
  for (const { mesh } of levels) requirePlace('glb', mesh, writer, options ?? {});
  const { writeGlbLevels } = await import('./gltf/write-glb-levels.ts');
  const parts = levels.map(({ mesh, report }) => ({ mesh, error: relativeError(report.variables[0]) }));
  return writeGlbLevels(parts, options);
}

/** The geometric error as a fraction of the extent: known whether or not it was bounded. */
function relativeError({ error, extent }: VariableReport): number | undefined {
  return extent > 0 ? error / extent : undefined;
}

/** Throws a FormatError where no file of this format can hold the mesh, nor what a reduction leaves of it: before that is made. */
export async function requireHeld(format: Format, mesh: Mesh, labels: LabelNames): Promise<void> {
  requirePlace(format, mesh, await writers[format](), labels);
}

function requirePlace(format: Format, mesh: Mesh, { lost, single, nameless }: Writer, labels: LabelNames): void {
  if (!nameless) requireNames(format, mesh);
  if (single) requireFinite(format, keptVariables(mesh, lost(mesh, labels)), writtenPoints(format, mesh));
}

/** What a file of this format will not hold of the mesh and its labels, a sentence each; nothing for PLY, VTP and legacy VTK. */
export async function lossesOf(format: Format, mesh: Mesh, labels: LabelNames = {}): Promise<string[]> {
  const writer = await writers[format]();
  const { lost, single, labels: holdsLabels } = writer;
  const sentences = pointLosses(format, mesh);
  const names = lost(mesh, labels).map(({ name }) => name);
  if (names.length > 0) sentences.push(`${formatNames[format]} has no place for the variables ${listed(names)}.`);
  const kept = keptVariables(mesh, lost(mesh, labels));
  const unfit = writer.unfit(mesh, labels).map(({ name }) => name);
  if (unfit.length > 0)
    sentences.push(
      `${formatNames[format]} takes unit vectors for normals, and bytes or fractions for colours; just numbers in it: ${listed(unfit)}.`,
    );
  sentences.push(...regionLosses(format, mesh, labels, writer));
  if (!holdsLabels) sentences.push(...labelLosses(format, kept, labels));
  const floated = noLongerWhole(format, kept.slice(1), labels).map(({ name }) => name);
  if (floated.length > 0)
    sentences.push(`${formatNames[format]} holds as floating point what were whole numbers: ${listed(floated)}.`);
  const roundings = single ? roundingsOf(format, { ...mesh, variables: kept.slice(1) }, labels) : [];
  const rounded = kept.flatMap(({ name }, i) =>
    roundings[i] > 0 ? [`${quoted(name)} (by up to ${roundings[i].toPrecision(2)})`] : [],
  );
  if (rounded.length > 0)
    sentences.push(`${formatNames[format]} knows single precision only; rounded: ${rounded.join(', ')}.`);
  return sentences;
}

/** What there is of a mesh beside its values. */
type LabelNames = Omit<WriteOptions, 'gzip' | 'encoding'>;

function regionLosses(format: Format, mesh: Mesh, labels: LabelNames, { heldLabels, regionNames }: Writer): string[] {
  const held = heldLabels(mesh, labels);
  const lost = allLabels(mesh, labels).filter((name) => !held.includes(name));
  const cellData = lost.filter((name) => labels.cellData?.has(name));
  const named = regionNames ? [] : held.filter((name) => labels.regionNames?.has(name));
  const losses = [
    ...(lost.length > cellData.length ? ['the regions'] : []),
    ...(cellData.length > 0 ? [`the cell data ${listed(cellData)}`] : []),
    ...(named.length > 0 ? [`the names of what is in the cell data ${listed(named)}`] : []),
  ];
  return losses.map((loss) => `${formatNames[format]} has no place for ${loss}.`);
}

function labelLosses(format: Format, kept: Variable[], { units = {}, componentNames = {} }: Partial<Labels>): string[] {
  const kinds: [noun: string, labels: Record<string, unknown>][] = [
    ['units', units],
    ['component names', componentNames],
  ];
  return kinds.flatMap(([noun, labels]) => {
    const names = kept.map(({ name }) => name).filter((name) => Object.hasOwn(labels, name));
    return names.length > 0 ? [`${formatNames[format]} has no place for the ${noun} of ${listed(names)}.`] : [];
  });
}

/** The geometry and what is not lost. */
function keptVariables({ position, variables }: Mesh, lost: Variable[]): Variable[] {
  return [{ name: 'position', components: 3, values: position }, ...variables.filter((each) => !lost.includes(each))];
}

function requireNames(format: Format, { variables }: Mesh): void {
  if (variables.every(({ name }) => name !== '')) return;
  throw new FormatError('empty_name', `${formatNames[format]} cannot hold a variable without a name.`);
}

/**
 * By point whether a file of this format holds it: STL has triangles, and no points without; GLB has no NaN, so a point without a
 * triangle stays behind where it holds one.
 */
function writtenPoints(format: Format, { position, triangles, variables }: Mesh): Uint8Array {
  const points = position.length / 3;
  if (format !== 'stl' && format !== 'glb') return new Uint8Array(points).fill(1);
  const written = new Uint8Array(points);
  if (format === 'glb') {
    const arrays = [{ components: 3, values: position }, ...variables];
    for (let point = 0; point < points; point++)
      written[point] = arrays.every((each) => isSingleAt(each, point)) ? 1 : 0;
  }
  for (const corner of triangles) written[corner] = 1;
  return written;
}

function isSingle(value: number): boolean {
  return Number.isFinite(Math.fround(value));
}

function isSingleAt({ values, components }: Pick<Variable, 'values' | 'components'>, point: number): boolean {
  return values.subarray(point * components, (point + 1) * components).every(isSingle);
}

/** The mesh of the points that a file holds. */
function withPoints(mesh: Mesh, written: Uint8Array): Mesh {
  if (!written.includes(0)) return mesh;
  const kept = Uint32Array.from(written.keys()).filter((point) => written[point] === 1);
  const numbers = new Uint32Array(written.length);
  for (const [number, point] of kept.entries()) numbers[point] = number;
  const variables = mesh.variables.map((each) => ({ ...each, values: gather(each.values, each.components, kept) }));
  const triangles = mesh.triangles.map((corner) => numbers[corner]);
  return { ...mesh, position: gather(mesh.position, 3, kept), triangles, variables };
}

function pointLosses(format: Format, mesh: Mesh): string[] {
  const lost = writtenPoints(format, mesh).filter((written) => written === 0).length;
  const where = format === 'glb' ? ' where something is not finite' : '';
  return lost > 0 ? [`${formatNames[format]} has no place for ${counted(lost, 'point')} of no triangle${where}.`] : [];
}

function requireFinite(format: Format, variables: Variable[], written: Uint8Array): void {
  for (const { name, components, values } of variables) {
    const wrong = values.find(
      (value: number, i: number) => written[Math.floor(i / components)] === 1 && !isSingle(value),
    );
    if (wrong === undefined) continue;
    const fault = Number.isFinite(wrong) ? 'which is beyond single precision' : 'which is not finite';
    const message = `${formatNames[format]} cannot hold the value ${wrong} of ${quoted(name)}, ${fault}.`;
    throw new FormatError('not_finite', message, name);
  }
}
