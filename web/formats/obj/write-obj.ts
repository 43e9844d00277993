import type { Mesh, Variable } from '../../../wasm/types.ts';
import { labelArrays } from '../regions/label-arrays.ts';
import type { WriteOptions } from '../surface.ts';
import { asFractions } from '../variables/colours.ts';
import { byRole } from '../variables/roles.ts';

/** The variables that OBJ has a place for; of colours it knows no opacity. */
function heldIn({ variables }: Mesh, options: WriteOptions): Record<'colour' | 'uv' | 'normal', Variable | undefined> {
  const held = byRole(variables, options);
  const opaque = variables.filter(({ components }) => components === 3);
  return {
    colour: byRole(opaque, options).get('colour'),
    uv: held.get('textureCoordinates'),
    normal: held.get('normal'),
  };
}

/** The variables that an OBJ file cannot hold. */
export function lostInObj(mesh: Mesh, options: WriteOptions = {}): Variable[] {
  const held = Object.values(heldIn(mesh, options));
  return mesh.variables.filter((each) => !held.includes(each));
}

/**
 * Writes an OBJ file, in the shortest digits that give every number back. Of the variables it holds colours, texture
 * coordinates and normals only: ask lostInObj. Labels of triangles become materials where they have names.
 */
export function writeObj(mesh: Mesh, options: WriteOptions = {}): Uint8Array {
  const { colour, uv, normal } = heldIn(mesh, options);
  const fractions = colour && asFractions(colour.values);
  const lines = ['# written by Meshbound'];
  const points = mesh.position.length / 3;
  const row = (values: ArrayLike<number>, components: number, point: number) =>
    Array.from({ length: components }, (_, i) => numberText(values[point * components + i])).join(' ');
  for (let point = 0; point < points; point++) {
    lines.push(`v ${row(mesh.position, 3, point)}${fractions ? ` ${row(fractions, 3, point)}` : ''}`);
  }
  for (let point = 0; uv && point < points; point++) lines.push(`vt ${row(uv.values, 2, point)}`);
  for (let point = 0; normal && point < points; point++) lines.push(`vn ${row(normal.values, 3, point)}`);
  const materialAt = materials(mesh, options);
  for (let at = 0; at < mesh.triangles.length; at += 3) {
    const material = materialAt(at / 3);
    if (material !== materialAt(at / 3 - 1)) lines.push(`usemtl ${material}`);
    const corners = Array.from(mesh.triangles.subarray(at, at + 3), (corner) => cornerText(corner + 1, uv, normal));
    lines.push(`f ${corners.join(' ')}`);
  }
  return new TextEncoder().encode(`${lines.join('\n')}\n`);
}

/** The array of labels that becomes materials: the first one whose labels have names. */
export function materialArray(mesh: Mesh, options: WriteOptions): string | undefined {
  return labelArrays(mesh, options).find(([name]) => options.regionNames?.has(name))?.[0];
}

/** The name of the material of a triangle; none where there are none, and before the first triangle. */
function materials(mesh: Mesh, options: WriteOptions): (triangle: number) => string | undefined {
  const array = materialArray(mesh, options);
  if (array === undefined) return () => undefined;
  const labels = new Map(labelArrays(mesh, options)).get(array);
  const names = options.regionNames?.get(array);
  return (triangle) => {
    const label = labels?.[triangle];
    return label === undefined ? undefined : (names?.get(label) ?? String(label));
  };
}

function cornerText(index: number, uv: Variable | undefined, normal: Variable | undefined): string {
  if (normal) return `${index}/${uv ? index : ''}/${index}`;
  return uv ? `${index}/${index}` : String(index);
}

function numberText(value: number): string {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? 'nan' : value > 0 ? 'inf' : '-inf';
  return Object.is(value, -0) ? '-0' : String(value);
}
