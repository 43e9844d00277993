import type { Mesh } from '../../wasm/types.ts';

/** A binary little-endian PLY file in single precision: x, y, z, then the variables, one component each, by name. */
export function plyOf(mesh: Mesh, comments: string[]): Buffer {
  const columns = mesh.variables.map((variable) => variable.values);
  const vertices = mesh.position.length / 3;
  const triangles = mesh.triangles.length / 3;
  const header = Buffer.from(
    [
      'ply',
      'format binary_little_endian 1.0',
      ...comments.map((comment) => `comment ${comment}`),
      `element vertex ${vertices}`,
      ...['x', 'y', 'z', ...mesh.variables.map((variable) => variable.name)].map((name) => `property float ${name}`),
      `element face ${triangles}`,
      'property list uchar uint vertex_indices',
      'end_header\n',
    ].join('\n'),
  );
  const file = Buffer.alloc(header.length + vertices * 4 * (3 + columns.length) + triangles * 13);
  let at = header.copy(file);
  for (let vertex = 0; vertex < vertices; ++vertex) {
    for (let axis = 0; axis < 3; ++axis) {
      at = file.writeFloatLE(mesh.position[3 * vertex + axis], at);
    }
    for (const column of columns) {
      at = file.writeFloatLE(column[vertex], at);
    }
  }
  for (let triangle = 0; triangle < triangles; ++triangle) {
    at = file.writeUInt8(3, at);
    for (let corner = 0; corner < 3; ++corner) {
      at = file.writeUInt32LE(mesh.triangles[3 * triangle + corner], at);
    }
  }
  return file;
}
