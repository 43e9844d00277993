import { readSurface } from '../formats/read.ts';
import { codeOf, messageOf } from './failure.ts';
import type { OpenedFile, ReadAnswer } from './read.ts';

addEventListener('message', async ({ data }: MessageEvent<{ name: string; bytes: Uint8Array }>) => {
  try {
    const { mesh, locked, notes, units, componentNames } = await readSurface(data.name, data.bytes);
    const file = { mesh, locked, notes, labels: { units, componentNames } };
    postMessage({ file } satisfies ReadAnswer, { transfer: buffersOf(file) });
  } catch (error) {
    postMessage({ code: codeOf(error), message: messageOf(error) } satisfies ReadAnswer);
  }
});

/** Each buffer once: arrays may share one, and a buffer can be handed over only once. */
function buffersOf({ mesh, locked = new Uint32Array() }: OpenedFile): ArrayBuffer[] {
  const arrays = [mesh.position, mesh.triangles, ...mesh.variables.map(({ values }) => values), locked];
  return [...new Set(arrays.map((array) => array.buffer as ArrayBuffer))];
}
