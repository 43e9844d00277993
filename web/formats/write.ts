import type { Mesh } from '../../wasm/types.ts';
import type { Format, WriteOptions } from './surface.ts';

/** One writer a format, each loaded when first asked for. */
const writers: Record<Format, () => Promise<(mesh: Mesh, options?: WriteOptions) => Uint8Array | Promise<Uint8Array>>> =
  {
    ply: async () => (await import('./write-ply.ts')).writePly,
    vtp: async () => (await import('./write-vtp.ts')).writeVtp,
    vtk: async () => (await import('./write-vtk.ts')).writeVtk,
  };

/**
 * Writes a mesh with all its variables as a file in memory. These formats carry single and double precision as given; names,
 * units and component names come back when the file is read. Throws a FormatError where the format cannot hold the mesh.
 */
export async function writeSurface(format: Format, mesh: Mesh, options?: WriteOptions): Promise<Uint8Array> {
  const write = await writers[format]();
  return write(mesh, options);
}
