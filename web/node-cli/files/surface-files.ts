import { readFile } from 'node:fs/promises';
import { basename, dirname, join } from 'node:path';
import type { Mesh } from '../../../wasm/types.ts';
import { formatByEnding, formatNames } from '../../formats/format-names.ts';
import { addVariables, type ReadOptions, readSurface, type SurfaceFile } from '../../formats/read.ts';
import type { Format, Labels, WriteOptions } from '../../formats/surface.ts';
import { lossesOf, writeSurface } from '../../formats/write.ts';
import { Fault, faultOf, UsageFault } from '../fault.ts';

/** A surface with the path that it was read from. */
export interface OpenedSurface extends SurfaceFile {
  path: string;
  /** What the array is called that holds the mesh's regions. */
  regionName?: string;
  /** From where a GLB file of it measures places. */
  origin?: WriteOptions['origin'];
}

/** Reads a surface, and more of its variables from the CSV file `csvPath`. Throws a Fault that names the file. */
export async function openSurface(path: string, csvPath?: string, options: ReadOptions = {}): Promise<OpenedSurface> {
  const beside = (name: string) => named(join(dirname(path), name), () => bytesOf(join(dirname(path), name)));
  const surface = await named(path, async () => readSurface(basename(path), await bytesOf(path), beside, options));
  if (csvPath === undefined) return { ...surface, path };
  return { ...(await named(csvPath, async () => addVariables(surface, await bytesOf(csvPath)))), path };
}

/** As a plain array: Node's Buffer means something else by slice(). */
async function bytesOf(path: string): Promise<Uint8Array> {
  const { buffer, byteOffset, length } = await readFile(path);
  return new Uint8Array(buffer, byteOffset, length);
}

/** Does what has to do with a file; faults name it. */
export async function named<Value>(path: string, work: () => Promise<Value>): Promise<Value> {
  try {
    return await work();
  } catch (error) {
    throw faultOf(path, error);
  }
}

/** The format that the ending of a name asks for. Throws a UsageFault where there is none. */
export function outputFormat(path: string): Format {
  const format = formatByEnding(path);
  if (format) return format;
  const endings = Object.keys(formatNames).map((each) => `.${each}`);
  throw new UsageFault(
    `${path}: the ending of the name decides about the format; it can be ${endings.join(', ')}, or one of them with .gz.`,
  );
}

/** A surface as the bytes of a file, and what the file does not hold of it. Throws a Fault that names the file. */
export function encodeSurface(
  path: string,
  mesh: Mesh,
  {
    units,
    componentNames,
    regionNames,
    wholeTypes,
    roles,
    regionName,
    cellData,
    origin,
  }: Labels & Pick<WriteOptions, 'regionName' | 'cellData' | 'origin'>,
): Promise<{ bytes: Uint8Array; losses: string[] }> {
  const format = outputFormat(path);
  const gzip = /\.gz$/i.test(path);
  const labels = { units, componentNames, regionNames, wholeTypes, roles, regionName, cellData };
  return named(path, async () => ({
    bytes: await writeSurface(format, mesh, { ...labels, gzip, origin }),
    losses: await lossesOf(format, mesh, { ...labels, origin }),
  }));
}

/** Throws a Fault where a file of this name has no place for a variable. */
export async function requirePlaceFor(variable: string, path: string): Promise<void> {
  const variables = [{ name: variable, components: 1, values: new Float32Array() }];
  const mesh = { position: new Float32Array(), triangles: new Uint32Array(), variables };
  const [loss] = await lossesOf(outputFormat(path), mesh);
  if (loss) throw new Fault(`${path}: ${loss}`);
}
