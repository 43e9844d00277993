import type { PrepareAnswer, PrepareRequest } from './prepare.ts';
import { surfaceArrays } from './surface-arrays.ts';

addEventListener('message', ({ data }: MessageEvent<PrepareRequest>) => {
  const arrays = surfaceArrays(data.surface, data.frame);
  const answer: PrepareAnswer = { id: data.id, arrays };
  postMessage(answer, { transfer: [arrays.corners.buffer, arrays.normals.buffer] });
});
