import type { Mesh, Variable } from '../../wasm/types.ts';

export function bytesOf(text: string): Uint8Array {
  return new TextEncoder().encode(text);
}

/** A tetrahedron without its floor: 4 points, 3 triangles. */
export function smallMesh(variables: Variable[] = []): Mesh {
  return {
    position: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0.1, 0.2, 0.3),
    triangles: Uint32Array.of(0, 1, 3, 1, 2, 3, 2, 0, 3),
    variables,
  };
}

/** Numbers that are easily spoilt on their way through text or a narrower type. */
export const awkwardFloats = Float32Array.of(0.1, -0, 1e-45, 3.4028234663852886e38);
export const awkwardDoubles = Float64Array.of(0.1, -0, 5e-324, 1.7976931348623157e308);

/** Every kind of variable: both precisions, one to nine components, names that formats must not trip over. */
export function mixedVariables(): Variable[] {
  const ramp = (length: number) => Array.from({ length }, (_, index) => index / 7 - 1);
  return [
    { name: 'pressure', components: 1, values: awkwardFloats },
    { name: 'temperature', components: 1, values: awkwardDoubles },
    { name: 'velocity', components: 3, values: Float32Array.from(ramp(12)) },
    { name: 'normal', components: 3, values: Float64Array.from(ramp(12)) },
    { name: 'color', components: 4, values: Float32Array.from(ramp(16)) },
    // Eighths, which single precision holds from either edge of a picture.
    { name: 'uv', components: 2, values: Float32Array.from({ length: 8 }, (_, index) => index / 8 - 1) },
    { name: 'stress', components: 9, values: Float64Array.from(ramp(36)) },
    { name: 'Mach number', components: 1, values: Float32Array.from(ramp(4)) },
    { name: '__proto__', components: 1, values: Float32Array.from(ramp(4)) },
    { name: 'Größe <&">', components: 3, values: Float32Array.from(ramp(12)) },
    { name: 'wind_x', components: 1, values: Float32Array.from(ramp(4)) },
    { name: 'wind_y', components: 1, values: Float32Array.from(ramp(4)) },
    { name: 'wind_z', components: 1, values: Float32Array.from(ramp(4)) },
    { name: 'x', components: 1, values: Float32Array.from(ramp(4)) },
  ];
}

/** The mesh without variables that are beyond single precision, which not every format can write. */
export function withinSingles(mesh: Mesh): Mesh {
  const fits = (value: number) => Number.isFinite(Math.fround(value));
  return { ...mesh, variables: mesh.variables.filter(({ values }) => values.every(fits)) };
}

type Numbers = ArrayLike<number> & {
  constructor: { name: string };
  buffer: ArrayBufferLike;
  byteOffset: number;
  byteLength: number;
};

/** The type and the bits, so that −0, NaN and precision count. */
export function bits(values: Numbers): string {
  const bytes = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
  return `${values.constructor.name} ${Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('')}`;
}

/** A mesh as plain text: equal texts mean equal bit for bit. */
export function fingerprint(mesh: Mesh): string[] {
  const variables = mesh.variables.map(({ name, components, values }) => `${name} ${components} ${bits(values)}`);
  return [bits(mesh.position), bits(mesh.triangles), ...variables];
}
