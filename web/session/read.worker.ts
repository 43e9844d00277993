import { type NamedFile, readTogether } from '../formats/read-together.ts';
import { codeOf, messageOf } from './failure.ts';
import type { OpenedFile, ReadAnswer } from './read.ts';

/** A surface and the files that were chosen with it. */
type Files = NamedFile & { beside: NamedFile[] };

addEventListener('message', async ({ data }: MessageEvent<Files>) => {
  try {
    const { mesh, locked, notes, units, componentNames } = await readTogether(data.name, data.bytes, data.beside);
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
