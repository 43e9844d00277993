import type { Report } from '../../wasm/types.ts';

/** A sentence for each kind of oddity that a valid surface has. */
export function oddityNotes({
  repeatedVertexTriangles,
  zeroAreaTriangles,
  unusedVertices,
  turnedTriangles,
  unorientableParts,
  unorientableTriangle,
}: Report['oddities']): string[] {
  const sentences: [number, string][] = [
    [repeatedVertexTriangles, 'with a repeated vertex: not a surface, left out of the result.'],
    [zeroAreaTriangles, 'without area: kept as part of the surface.'],
  ];
  const notes = sentences.filter(([count]) => count > 0).map(([count, text]) => `${triangles(count)} ${text}`);
  if (unusedVertices > 0) {
    const vertices = unusedVertices === 1 ? '1 vertex belongs' : `${unusedVertices} vertices belong`;
    notes.push(`${vertices} to no triangle: left out of the result.`);
  }
  if (turnedTriangles > 0) {
    const facing = turnedTriangles === 1 ? 'faces' : 'face';
    notes.push(`${triangles(turnedTriangles)} ${facing} the other side than most around them: turned round.`);
  }
  if (unorientableParts > 0) {
    const parts = unorientableParts === 1 ? '1 part has' : `${unorientableParts} parts have`;
    notes.push(
      `${parts} no two sides (triangle ${unorientableTriangle}, counted from 0): along some line its triangles face different ways.`,
    );
  }
  return notes;
}

function triangles(count: number): string {
  return count === 1 ? '1 triangle' : `${count} triangles`;
}

/** A sentence for what was left out of a result because it is small; none where nothing was. */
export function droppedNotes({ parts, triangles: count }: Report['dropped']): string[] {
  if (parts === 0) return [];
  const left = parts === 1 ? '1 part' : `${parts} parts`;
  return [`${left} smaller than the bound of position, ${triangles(count)}: left out; nothing is promised of them.`];
}

/** Where parts may come to pierce each other, and what keeps them from it: a sentence; `near` as havePartsWithin has it. */
export function nearPartsNotes(near: boolean | undefined): string[] {
  if (near !== true) return [];
  return [
    'parts of the surface are nearer to each other than the bound of position, and may pierce each other in the result: --refuse-piercing keeps them from it.',
  ];
}

/** Significant digits of a feature size in a sentence; the report has them all. */
const featureDigits = 4;

/** What limited the bound of position, a sentence. */
export function featureNotes(size: Report['featureSize']): string[] {
  if (size === undefined) return [];
  const near = Number(size.toPrecision(featureDigits));
  return [
    `parts of the surface come as near to each other as ${near}: the bound of position is limited to half of it.`,
  ];
}
