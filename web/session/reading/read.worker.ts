import type { ReadOptions } from '../../formats/read.ts';
import { type NamedFile, readTogether } from '../../formats/read-together.ts';
import { withoutRegionNotes } from '../../formats/regions/region-notes.ts';
import { codeOf, messageOf } from './failure.ts';
import type { OpenedFile, ReadAnswer } from './read.ts';

/** A surface and the files that were chosen with it. */
type Files = NamedFile & { beside: NamedFile[]; options: ReadOptions };

addEventListener('message', async ({ data }: MessageEvent<Files>) => {
  try {
    const { mesh, locked, regions, notes, units, componentNames, regionNames, wholeTypes, roles, crack } =
      await readTogether(data.name, data.bytes, data.beside, data.options);
    const file = {
      mesh,
      locked,
      regions,
      notes: withoutRegionNotes(notes, regions).filter((note) => note !== crack?.note),
      crack,
      labels: { units, componentNames, regionNames, wholeTypes, roles },
    };
    postMessage({ file } satisfies ReadAnswer, { transfer: buffersOf(file) });
  } catch (error) {
    postMessage({ code: codeOf(error), message: messageOf(error) } satisfies ReadAnswer);
  }
});

/** Each buffer once: arrays may share one, and a buffer can be handed over only once. */
function buffersOf({ mesh, locked = new Uint32Array(), regions = new Map() }: OpenedFile): ArrayBuffer[] {
  const values = mesh.variables.map((variable) => variable.values);
  const arrays = [mesh.position, mesh.triangles, ...values, locked, ...regions.values()];
  return [...new Set(arrays.map((array) => array.buffer as ArrayBuffer))];
}
