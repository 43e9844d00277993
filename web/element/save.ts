import type { Mesh } from '../../wasm/types.ts';
import type { Format, Labels } from '../formats/surface.ts';
import { writeSurface } from '../formats/write.ts';

/** Offers a surface as a download. Rejects where the format cannot hold it. */
export async function save(mesh: Mesh, labels: Labels, format: Format, fileName: string): Promise<void> {
  const bytes = await writeSurface(format, mesh, labels);
  const address = URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>]));
  const link = document.createElement('a');
  link.href = address;
  link.download = fileName;
  link.click();
  // The download has its own hold on the data once it has started.
  setTimeout(() => URL.revokeObjectURL(address));
}
