import type { Surface } from '../../web/formats/surface.ts';
import { markdownTable } from './markdown.ts';
import { outcomeOf } from './outcome.ts';

/** Geometry and variables, in percent. */
const pairs: [number, number][] = [
  [1, 3],
  [3, 3],
  [6, 6],
  [9, 9],
];

/** Triangles left of surfaces that the paper has not. */
export async function othersTable(surfaces: Map<string, Surface>): Promise<string> {
  const lines: (string | number)[][] = [];
  for (const [name, { mesh }] of surfaces) {
    const before = mesh.triangles.length / 3;
    const share = (count: number) => `${count} (${((100 * count) / before).toFixed(1)} %)`;
    for (const [geometry, variables] of pairs) {
      const bounds = { position: { relative: geometry / 100 }, '*': { relative: variables / 100 } };
      const propagated = await outcomeOf(mesh, bounds, 'propagated');
      const tracked = await outcomeOf(mesh, bounds, 'tracked');
      const judged = [propagated, tracked].map((outcome) => outcome.judged.toFixed(3));
      lines.push([
        name,
        before,
        `${geometry}/${variables}`,
        share(propagated.triangles),
        judged[0],
        share(tracked.triangles),
        judged[1],
      ]);
    }
  }
  return markdownTable(['surface', 'triangles', 'bounds, %', 'propagated', 'judge', 'tracked', 'judge'], lines);
}
