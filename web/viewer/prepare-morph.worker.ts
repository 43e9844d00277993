import type { Frame } from './frame.ts';
import { morphArrays, morphCorners } from './morph-corners.ts';
import type { MorphSource, PreparedEnd, PrepareMorphAnswer, PrepareMorphRequest } from './prepare-morph.ts';
import { surfaceArrays } from './surface-arrays.ts';

function prepareEnd(triangles: Uint32Array, { end, surface }: MorphSource['finer'], frame: Frame): PreparedEnd {
  const at = morphCorners(triangles, end, surface.triangles);
  return { arrays: morphArrays(surfaceArrays(surface, frame), at), at };
}

addEventListener('message', ({ data: { id, morph, frame } }: MessageEvent<PrepareMorphRequest>) => {
  const finer = prepareEnd(morph.triangles, morph.finer, frame);
  const coarser = prepareEnd(morph.triangles, morph.coarser, frame);
  const answer: PrepareMorphAnswer = { id, prepared: { finer, coarser } };
  const buffers = [finer, coarser].flatMap(({ arrays, at }) => [
    arrays.corners.buffer,
    arrays.normals.buffer,
    arrays.faces.buffer,
    arrays.within.buffer,
    at.weights.buffer as ArrayBuffer,
  ]);
  postMessage(answer, { transfer: buffers });
});
