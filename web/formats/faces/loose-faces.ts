import type { Mesh } from '../../../wasm/types.ts';
import { firstOfEqual, placesOf, weld } from '../cracks/weld.ts';
import type { Surface } from '../surface.ts';
import { counted, listed } from '../text/wording.ts';

/**
 * A file may have points of its own for every face, so that no face hangs together with another one. Points of such a surface
 * that agree in place and in every variable are made one. Those that differ stay: the surface is cut there. Any other surface
 * stays as it is, slits and all.
 */
export function withJoinedFaces(surface: Surface): Surface {
  if (!isLoose(surface.mesh)) return surface;
  const { mesh, welded } = weld(surface.mesh);
  const labels = surface.mesh.regions ? { regions: surface.mesh.regions } : {};
  const notes = [...surface.notes];
  if (welded > 0)
    notes.push(`${counted(welded, 'repeated point')} welded: the file has points of its own for every face.`);
  if (isLoose(mesh)) notes.push(...jumpNotes(mesh));
  return { ...surface, mesh: { ...mesh, ...labels }, notes };
}

/** A surface of fewer triangles is as quickly all corners and seams. */
const fewestTriangles = 64;

/** Around a point meet six triangles or four squares or so, along a seam two sheets. */
const pointsInAPlace = 2.5;

/** Whether faces have points of their own, as far as the numbers tell. */
function isLoose({ position, triangles }: Mesh): boolean {
  const points = position.length / 3;
  // Where faces share points there are about half as many points as triangles.
  if (triangles.length / 3 < fewestTriangles || points < triangles.length / 3) return false;
  const places = placesOf(position).reduce((sum, first, point) => sum + (first === point ? 1 : 0), 0);
  return points > pointsInAPlace * places;
}

/** Which variables keep the faces apart. */
function jumpNotes({ position, variables }: Mesh): string[] {
  const places = placesOf(position);
  const repeated = places.filter((first, point) => first !== point).length;
  const jumping = variables.filter(({ values, components }) => {
    const rows = [
      { values: position, components: 3 },
      { values, components },
    ];
    const apart = firstOfEqual(rows, places.length).filter(
      (first, point) => first === point && places[point] !== point,
    );
    return 2 * apart.length > repeated;
  });
  if (jumping.length === 0) return [];
  const names = listed(jumping.map(({ name }) => name));
  return [`Hardly anything can be removed, since the values at one place differ from face to face: ${names}.`];
}
