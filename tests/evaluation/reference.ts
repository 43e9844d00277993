import type { Mesh } from '../../wasm/types.ts';
import type { Surface } from '../../web/formats/surface.ts';
import { spanOf } from '../../web/surface/value-span.ts';
import { markdownTable } from './markdown.ts';
import { type Bounds, outcomeOf } from './outcome.ts';

/** The bound of every variable, and of the geometry as a fraction of one length or another. */
const fraction = 0.03;

/** How the count of triangles depends on what the geometric bound is relative to, the variables' bounds being the same. */
export async function referenceTable(surfaces: Map<string, Surface>): Promise<string> {
  const lines: (string | number)[][] = [];
  for (const [name, { mesh }] of surfaces) {
    for (const [reference, length] of lengthsOf(mesh)) {
      const bounds: Bounds = { position: { absolute: fraction * length }, '*': { relative: fraction } };
      lines.push(await line(name, mesh, `3 % of the ${reference}`, fraction * length, bounds));
    }
    lines.push(await line(name, mesh, 'free', Infinity, { position: 'free', '*': { relative: fraction } }));
  }
  return markdownTable(['surface', 'geometric bound', 'in mean edges', 'propagated', 'tracked'], lines, 2);
}

async function line(name: string, mesh: Mesh, words: string, bound: number, bounds: Bounds) {
  const propagated = await outcomeOf(mesh, bounds, 'propagated');
  const tracked = await outcomeOf(mesh, bounds, 'tracked');
  const edges = Number.isFinite(bound) ? (bound / meanEdge(mesh)).toFixed(2) : '';
  return [name, words, edges, propagated.triangles, tracked.triangles];
}

/** What a relative bound could be relative to. */
function lengthsOf({ position, triangles }: Mesh): [string, number][] {
  const { components, extent } = spanOf({ name: 'position', components: 3, values: position }, triangles);
  const sides = components.map(({ lowest, highest }) => highest - lowest);
  return [
    ['diagonal of the box (ours)', extent],
    ['longest side', Math.max(...sides)],
    ['shortest side', Math.min(...sides)],
  ];
}

function meanEdge({ position, triangles }: Mesh): number {
  let sum = 0;
  for (let corner = 0; corner < triangles.length; corner++) {
    const next = corner % 3 === 2 ? corner - 2 : corner + 1;
    const [p, q] = [3 * triangles[corner], 3 * triangles[next]];
    sum += Math.hypot(...[0, 1, 2].map((axis) => position[p + axis] - position[q + axis]));
  }
  return sum / triangles.length;
}
