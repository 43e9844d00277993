/**
 * What choosing places and crossings of the tracked map is worth (docs/algorithm.md): triangles left at 1 % of the geometry
 * and 3 % of every variable, and the share of the map's cells that are folded, for the surfaces in the given PLY files.
 *
 *     npx tsx tests/evaluation/freedom.ts FILE.ply...
 */

import { readFileSync } from 'node:fs';
import { basename } from 'node:path';

import { reduce } from '../../wasm/index.ts';
import type { Mesh } from '../../wasm/types.ts';
import { readPly } from '../../web/formats/ply/read-ply.ts';
import { markdownTable } from './markdown.ts';

const bounds = { position: { relative: 0.01 }, '*': { relative: 0.03 } };

const freedoms = [
  { title: 'neither', optimizeVertexImages: false, optimizeEdgeCrossings: false },
  { title: 'places', optimizeVertexImages: true, optimizeEdgeCrossings: false },
  { title: 'crossings', optimizeVertexImages: false, optimizeEdgeCrossings: true },
  { title: 'both', optimizeVertexImages: true, optimizeEdgeCrossings: true },
];

/** Triangles left, and how much of the map is folded: "950 · 2.1 %". */
async function outcome(
  mesh: Mesh,
  { optimizeVertexImages, optimizeEdgeCrossings }: (typeof freedoms)[number],
): Promise<string> {
  const { report } = await reduce(mesh, { bounds, optimizeVertexImages, optimizeEdgeCrossings });
  return `${report.triangles.after} · ${((100 * report.foldedCells) / report.cells).toFixed(1)} %`;
}

const lines: (string | number)[][] = [];
for (const path of process.argv.slice(2)) {
  const { mesh } = readPly(readFileSync(path));
  const line: (string | number)[] = [basename(path, '.ply'), mesh.triangles.length / 3];
  for (const freedom of freedoms) line.push(await outcome(mesh, freedom));
  lines.push(line);
}
console.log(markdownTable(['surface', 'triangles', ...freedoms.map(({ title }) => title)], lines));
