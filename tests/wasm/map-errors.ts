import type { Mesh, Reduction, SurfaceMap, Variable } from '../../wasm/types.ts';

/** Position and data of a mesh as variables, in the order of reports. */
export function variablesOf({ position, variables }: Mesh): Variable[] {
  return [{ name: 'position', components: 3, values: position }, ...variables];
}

export function placesOf({ triangle, barycentric }: SurfaceMap): { triangle: number; barycentric: number[] }[] {
  return Array.from(triangle, (index, vertex) => ({
    triangle: index,
    barycentric: Array.from(barycentric.subarray(3 * vertex, 3 * vertex + 3)),
  }));
}

/** Original minus reduced of every component of a variable at every vertex of the original, by the map and both meshes alone. */
export function vertexDifferences(mesh: Mesh, { mesh: reduced, map }: Reduction, variable: number): number[][] {
  const [from, to] = [variablesOf(mesh)[variable], variablesOf(reduced)[variable]];
  return placesOf(map as SurfaceMap).map(({ triangle, barycentric }, vertex) =>
    components(from).map((component) => {
      const mapped = barycentric.map(
        (weight, corner) => weight * valueAt(to, reduced.triangles[3 * triangle + corner], component),
      );
      return valueAt(from, vertex, component) - sum(mapped);
    }),
  );
}

/** The same at every crossing. */
export function crossingDifferences(mesh: Mesh, { mesh: reduced, map }: Reduction, variable: number): number[][] {
  const [from, to] = [variablesOf(mesh)[variable], variablesOf(reduced)[variable]];
  const { crossingEdges, crossingShares } = map as SurfaceMap;
  return Array.from({ length: crossingShares.length / 2 }, (_, crossing) => {
    const [a, b, c, d] = crossingEdges.subarray(4 * crossing, 4 * crossing + 4);
    const [s, t] = crossingShares.subarray(2 * crossing, 2 * crossing + 2);
    return components(from).map(
      (component) =>
        between(valueAt(from, a, component), valueAt(from, b, component), s) -
        between(valueAt(to, c, component), valueAt(to, d, component), t),
    );
  });
}

/** The unit normal of a triangle. */
export function normalOf({ position, triangles }: Mesh, triangle: number): number[] {
  const [a, b, c] = [0, 1, 2].map((corner) => {
    const vertex = triangles[3 * triangle + corner];
    return Array.from(position.subarray(3 * vertex, 3 * vertex + 3));
  });
  const [u, v] = [difference(b, a), difference(c, a)];
  const area = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  return area.map((part) => part / length(area));
}

export function length(vector: number[]): number {
  return Math.hypot(...vector);
}

export function dot(a: number[], b: number[]): number {
  return sum(a.map((part, index) => part * b[index]));
}

function components({ components: count }: Variable): number[] {
  return Array.from({ length: count }, (_, component) => component);
}

function valueAt({ values, components: count }: Variable, vertex: number, component: number): number {
  return values[vertex * count + component];
}

function between(first: number, second: number, share: number): number {
  return (1 - share) * first + share * second;
}

function difference(a: number[], b: number[]): number[] {
  return a.map((part, index) => part - b[index]);
}

function sum(numbers: number[]): number {
  return numbers.reduce((total, next) => total + next, 0);
}
