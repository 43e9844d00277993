import type { Mesh } from '../../../wasm/types.ts';
import { type Labels, noLabels, type Surface } from '../surface.ts';
import { counted } from '../text/wording.ts';
import { placesOf, type Weld, weld } from './weld.ts';

/**
 * A surface of a format made for drawing, welded. Normals that differ in one place draw a crease and nothing else: they follow
 * from the surface, so they go rather than cut it up. `copies` as in sealed.
 */
export function weldedSurface(mesh: Mesh, notes: string[], copies = 0): Surface {
  return { ...sealed(withoutCreases(mesh, notes), notes, copies), ...noLabels() };
}

/** What was welded; says so in its notes. `copies` points were repeated not in the file but by its reader, which need not be said. */
export function sealed({ mesh, welded }: Weld, notes: string[], copies = 0): Omit<Surface, keyof Labels> {
  if (welded > copies) notes.push(`${counted(welded - copies, 'repeated point')} welded.`);
  return { mesh, notes };
}

function withoutCreases(mesh: Mesh, notes: string[]): Weld {
  const result = weld(mesh);
  const variables = mesh.variables.filter(({ name }) => name !== 'normal');
  if (variables.length === mesh.variables.length) return result;
  if (placesOf(result.mesh.position).every((first, point) => first === point)) return result;
  const smooth = weld({ ...mesh, variables });
  const creases = smooth.welded - result.welded;
  if (creases === 0) return result;
  notes.push('Not carried: normals, since they differ at creases; they follow from the surface.');
  return smooth;
}
