/** Cosine of the crease angle: triangles that meet at more than 60° are shaded as two faces, not as one bend. */
const creaseCosine = Math.cos((60 * Math.PI) / 180);

/**
 * Normals for smooth shading, one a triangle corner: the area-weighted mean over the triangles at its vertex that turn
 * away from the corner's own by less than the crease angle.
 *
 * @param corners x, y, z of every triangle corner, nine numbers a triangle
 * @param triangles three vertex indices a triangle
 * @param vertices how many vertices there are
 */
export function cornerNormals(
  corners: Float32Array,
  triangles: Uint32Array,
  vertices: number,
): Float32Array<ArrayBuffer> {
  const { area, unit } = faceNormals(corners);
  const around = cornersAround(triangles, vertices);
  const normals = new Float32Array(corners.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const own = 3 * Math.floor(corner / 3);
    const vertex = triangles[corner];
    for (let place = around.first[vertex]; place < around.first[vertex + 1]; place++) {
      const other = 3 * Math.floor(around.corners[place] / 3);
      if (dot(unit, own, other) < creaseCosine && own !== other) continue;
      for (let axis = 0; axis < 3; axis++) normals[3 * corner + axis] += area[other + axis];
    }
    normalise(normals, 3 * corner);
  }
  return normals;
}

/** Face normals twice: as long as twice the triangle's area, and of length 1. */
export function faceNormals(corners: Float32Array): { area: Float64Array; unit: Float64Array } {
  const area = new Float64Array(corners.length / 3);
  for (let first = 0, out = 0; first < corners.length; first += 9, out += 3) {
    const [ux, uy, uz] = difference(corners, first + 3, first);
    const [vx, vy, vz] = difference(corners, first + 6, first);
    area[out] = uy * vz - uz * vy;
    area[out + 1] = uz * vx - ux * vz;
    area[out + 2] = ux * vy - uy * vx;
  }
  const unit = area.slice();
  for (let first = 0; first < unit.length; first += 3) normalise(unit, first);
  return { area, unit };
}

/** For each vertex the corners that lie on it: `corners[first[v]] … corners[first[v + 1] - 1]`. */
function cornersAround(triangles: Uint32Array, vertices: number): { first: Uint32Array; corners: Uint32Array } {
  const first = new Uint32Array(vertices + 1);
  for (const vertex of triangles) first[vertex + 1]++;
  for (let vertex = 0; vertex < vertices; vertex++) first[vertex + 1] += first[vertex];
  const next = first.slice();
  const corners = new Uint32Array(triangles.length);
  for (let corner = 0; corner < triangles.length; corner++) corners[next[triangles[corner]]++] = corner;
  return { first, corners };
}

function difference(points: Float32Array, to: number, from: number): [number, number, number] {
  return [points[to] - points[from], points[to + 1] - points[from + 1], points[to + 2] - points[from + 2]];
}

function dot(vectors: Float64Array, a: number, b: number): number {
  return vectors[a] * vectors[b] + vectors[a + 1] * vectors[b + 1] + vectors[a + 2] * vectors[b + 2];
}

function normalise(vectors: Float32Array | Float64Array, at: number): void {
  const length = Math.sqrt(vectors[at] ** 2 + vectors[at + 1] ** 2 + vectors[at + 2] ** 2);
  if (length === 0) return;
  for (let axis = 0; axis < 3; axis++) vectors[at + axis] /= length;
}
