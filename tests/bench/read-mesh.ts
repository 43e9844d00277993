import { readFileSync } from 'node:fs';
import type { Mesh } from '../../wasm/types.ts';
import type { Case } from './cases.ts';

/** Reads a surface of the benchmark (binary PLY in single precision, faces with a count of one byte) with those variables. */
export function readMesh({ path, variables }: Case): Mesh {
  const file = readFileSync(path);
  const end = file.indexOf('end_header\n') + 'end_header\n'.length;
  const header = file.toString('latin1', 0, end);
  const [vertices = 0, faces = 0] = ['vertex', 'face'].map((name) => count(header, name));
  const names = [...header.matchAll(/property float (\S+)/g)].map((match) => match[1]);
  const rows = new Float32Array(
    file.buffer.slice(file.byteOffset + end, file.byteOffset + end + rowBytes(names) * vertices),
  );
  const column = (name: string) => {
    const place = names.indexOf(name);
    return Float32Array.from({ length: vertices }, (_, vertex) => rows[vertex * names.length + place] as number);
  };
  const [x, y, z] = ['x', 'y', 'z'].map(column) as [Float32Array, Float32Array, Float32Array];
  const position = new Float32Array(3 * vertices);
  for (let vertex = 0; vertex < vertices; vertex++) {
    position[3 * vertex] = x[vertex] as number;
    position[3 * vertex + 1] = y[vertex] as number;
    position[3 * vertex + 2] = z[vertex] as number;
  }
  return {
    position,
    triangles: readTriangles(file, end + rowBytes(names) * vertices, faces),
    variables: variables.map((name) => ({ name, components: 1, values: column(name) })),
  };
}

function count(header: string, element: string): number {
  return Number(header.match(new RegExp(`element ${element} (\\d+)`))?.[1]);
}

function rowBytes(names: unknown[]): number {
  return names.length * Float32Array.BYTES_PER_ELEMENT;
}

function readTriangles(file: Buffer, start: number, faces: number): Uint32Array {
  const triangles = new Uint32Array(3 * faces);
  for (let face = 0, at = start; face < faces; face++, at += 13) {
    for (let corner = 0; corner < 3; corner++) triangles[3 * face + corner] = file.readUInt32LE(at + 1 + 4 * corner);
  }
  return triangles;
}
