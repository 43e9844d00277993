import type { Report } from '../../wasm/types.ts';

/** A sentence for each kind of oddity that a valid surface has. */
export function oddityNotes({
  repeatedVertexTriangles,
  zeroAreaTriangles,
  unusedVertices,
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
  return notes;
}

function triangles(count: number): string {
  return count === 1 ? '1 triangle' : `${count} triangles`;
}
