import { readFile } from 'node:fs/promises';
import { basename } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { Mesh } from '../../wasm/types.ts';
import { readSurface, type SurfaceFile } from '../formats/read.ts';
import type { Format, Labels } from '../formats/surface.ts';
import { lossesOf, writeSurface } from '../formats/write.ts';
import { Fault, faultOf, UsageFault } from './fault.ts';

/** A surface with the path that it was read from. */
export interface OpenedSurface extends SurfaceFile {
  path: string;
}

/** Reads a surface. Throws a Fault that names the file. */
export async function openSurface(path: string): Promise<OpenedSurface> {
  try {
    const { buffer, byteOffset, length } = await readFile(path);
    // A plain array: Node's Buffer means something else by slice().
    return { ...(await readSurface(basename(path), new Uint8Array(buffer, byteOffset, length))), path };
  } catch (error) {
    throw faultOf(path, error);
  }
}

/** What a file is to be written as. */
export interface OutputFormat {
  format: Format;
  gzip: boolean;
}

/** All formats that are written; the compiler sees to it that none is left out. */
const written: Record<Format, true> = { vtp: true, vtk: true, ply: true, glb: true, obj: true, stl: true };

/** The endings of names that can be written, for messages: ".vtp, .vtk, …". */
export const writtenEndings = Object.keys(written)
  .map((format) => `.${format}`)
  .join(', ');

/** The format that the ending of a name asks for, `.gz` behind it or not. Throws a UsageFault where there is none. */
export function outputFormat(path: string): OutputFormat {
  const [, ending = '', gzip] = /(?:\.([^./\\]+?))?(\.gz)?$/i.exec(path) ?? [];
  const format = ending.toLowerCase();
  if (Object.hasOwn(written, format)) return { format: format as Format, gzip: gzip !== undefined };
  throw new UsageFault(
    `${path}: the ending of the name decides about the format; it can be ${writtenEndings}, or one of them with .gz.`,
  );
}

/** A surface as the bytes of a file, and what the file does not hold of it. Throws a Fault that names the file. */
export async function encodeSurface(
  path: string,
  mesh: Mesh,
  { units, componentNames }: Labels,
): Promise<{ bytes: Uint8Array; notes: string[] }> {
  const { format, gzip } = outputFormat(path);
  try {
    const bytes = await writeSurface(format, mesh, { units, componentNames });
    return { bytes: gzip ? gzipSync(bytes) : bytes, notes: await lossesOf(format, mesh) };
  } catch (error) {
    throw faultOf(path, error);
  }
}

/** Throws a Fault unless a file of this name holds the variables of a mesh. */
export async function requireVariables(path: string, mesh: Mesh): Promise<void> {
  const [loss] = await lossesOf(outputFormat(path).format, mesh);
  if (loss) throw new Fault(`${path}: ${loss}`);
}
