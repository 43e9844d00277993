import { readSurface } from '../formats/read.ts';
import type { OpenedFile, ReadAnswer } from './read.ts';

addEventListener('message', async ({ data }: MessageEvent<{ name: string; bytes: Uint8Array }>) => {
  try {
    const { mesh, notes, units, componentNames } = await readSurface(data.name, data.bytes);
    postMessage({ file: { mesh, notes, labels: { units, componentNames } } } satisfies ReadAnswer, {
      transfer: buffersOf(mesh),
    });
  } catch (error) {
    postMessage({ message: error instanceof Error ? error.message : String(error) } satisfies ReadAnswer);
  }
});

/** Each buffer once: arrays may share one, and a buffer can be handed over only once. */
function buffersOf({ position, triangles, variables }: OpenedFile['mesh']): ArrayBuffer[] {
  const arrays = [position, triangles, ...variables.map(({ values }) => values)];
  return [...new Set(arrays.map((array) => array.buffer as ArrayBuffer))];
}
