type PlyNumber = 'char' | 'uchar' | 'short' | 'ushort' | 'int' | 'uint' | 'float' | 'double';
export type PlyOrder = 'ascii' | 'binary_little_endian' | 'binary_big_endian';
export const plyOrders: PlyOrder[] = ['ascii', 'binary_little_endian', 'binary_big_endian'];

/** An element: its property lines and its rows, a number for a plain property and an array for a list. */
export interface PlyPart {
  name: string;
  properties: string[];
  rows: (number | number[])[][];
}

const setters: Record<PlyNumber, [size: number, set: (view: DataView, value: number, little: boolean) => void]> = {
  char: [1, (view, value) => view.setInt8(0, value)],
  uchar: [1, (view, value) => view.setUint8(0, value)],
  short: [2, (view, value, little) => view.setInt16(0, value, little)],
  ushort: [2, (view, value, little) => view.setUint16(0, value, little)],
  int: [4, (view, value, little) => view.setInt32(0, value, little)],
  uint: [4, (view, value, little) => view.setUint32(0, value, little)],
  float: [4, (view, value, little) => view.setFloat32(0, value, little)],
  double: [8, (view, value, little) => view.setFloat64(0, value, little)],
};

function encode(value: number, type: PlyNumber, order: PlyOrder): number[] {
  if (order === 'ascii') return [...` ${Object.is(value, -0) ? '-0' : value}`].map((letter) => letter.charCodeAt(0));
  const [size, set] = setters[type];
  const bytes = new Uint8Array(size);
  set(new DataView(bytes.buffer), value, order === 'binary_little_endian');
  return [...bytes];
}

/** A PLY file put together independently of the project's writer. */
export function plyFile(order: PlyOrder, parts: PlyPart[], extraLines: string[] = []): Uint8Array {
  const lines = ['ply', `format ${order} 1.0`, ...extraLines];
  const body: number[] = [];
  for (const { name, properties, rows } of parts) {
    lines.push(`element ${name} ${rows.length}`, ...properties.map((property) => `property ${property}`));
    const types = properties.map((property) => property.split(' ') as PlyNumber[]);
    for (const row of rows) {
      for (const [index, cell] of row.entries()) {
        const words = types[index];
        if (typeof cell === 'number') body.push(...encode(cell, words[0], order));
        else
          for (const [at, value] of [cell.length, ...cell].entries())
            body.push(...encode(value, words[at === 0 ? 1 : 2], order));
      }
      if (order === 'ascii') body.push(10);
    }
  }
  const header = new TextEncoder().encode(`${lines.join('\n')}\nend_header\n`);
  return Uint8Array.from([...header, ...body]);
}

export const square: PlyPart = {
  name: 'vertex',
  properties: ['float x', 'float y', 'float z'],
  rows: [
    [0, 0, 0],
    [1, 0, 0],
    [1, 1, 0],
    [0, 1, 0],
  ],
};

export function faces(...rows: number[][]): PlyPart {
  return { name: 'face', properties: ['list uchar int vertex_indices'], rows: rows.map((row) => [row]) };
}
