import type { NonFinite, Report } from '../../../wasm/types.ts';
import { quoted } from '../../formats/text/wording.ts';

/** A sentence for each kind of defect that a valid surface has. */
export function defectNotes({
  repeatedVertexTriangles,
  zeroAreaTriangles,
  unusedVertices,
  flippedTriangles,
  unorientableComponents,
  unorientableTriangle,
  copiedTriangles,
  twoSidedTriangles,
}: Report['defects']): string[] {
  const sentences: [number, string][] = [
    [repeatedVertexTriangles, 'with a repeated vertex: not a surface, left out of the result.'],
    [zeroAreaTriangles, 'without area: kept as part of the surface.'],
  ];
  const notes = sentences.filter(([count]) => count > 0).map(([count, text]) => `${triangles(count)} ${text}`);
  notes.push(...unusedNotes(unusedVertices));
  if (flippedTriangles > 0) {
    const facing = flippedTriangles === 1 ? 'faces' : 'face';
    notes.push(`${triangles(flippedTriangles)} ${facing} the other side than most around them: turned round.`);
  }
  if (unorientableComponents > 0) {
    const parts = unorientableComponents === 1 ? '1 part has' : `${unorientableComponents} parts have`;
    notes.push(
      `${parts} no two sides (triangle ${unorientableTriangle}, counted from 0): along some line its triangles face different ways.`,
    );
  }
  if (copiedTriangles > 0) {
    const lie = copiedTriangles === 1 ? 'is a copy of another one' : 'are copies of others';
    notes.push(
      `${triangles(copiedTriangles)} ${lie}, on the same three points and facing the same way: left out of the result.`,
    );
  }
  if (twoSidedTriangles > 0) {
    const pairs = twoSidedTriangles === 1 ? '1 pair' : `${twoSidedTriangles} pairs`;
    notes.push(
      `${pairs} of triangles on the same three points, facing opposite ways: two sides of one sheet, reduced together.`,
    );
  }
  return notes;
}

/** A sentence on points of no surface, and what becomes of them; none where there are none. */
export function unusedNotes(count: number, become = 'left out of the result'): string[] {
  if (count === 0) return [];
  const vertices = count === 1 ? '1 vertex belongs' : `${count} vertices belong`;
  return [`${vertices} to no triangle: ${become}.`];
}

/** What a variable holds that lets it have no bound, to go before a colon. */
export function nonFiniteWords(name: string, { vertices, first }: NonFinite): string {
  const points = vertices === 1 ? `1 point, which is ${first}` : `${vertices} points, the first of which is ${first}`;
  return `${quoted(name)} holds NaN or infinity (at ${points})`;
}

function triangles(count: number): string {
  return count === 1 ? '1 triangle' : `${count} triangles`;
}

/** A sentence for what was left out of a result because it is small; none where nothing was. */
export function droppedNotes({ components: parts, triangles: count }: Report['dropped']): string[] {
  if (parts === 0) return [];
  const left = parts === 1 ? '1 part' : `${parts} parts`;
  return [`${left} smaller than the bound of position, ${triangles(count)}: left out; nothing is guaranteed of them.`];
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
