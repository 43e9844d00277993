import type { Mesh } from '../../wasm/types.ts';

/**
 * A square plate of 2·side² triangles with smooth bumps and two variables: `height` (double precision, values that single
 * precision cannot hold) and `flow` (three components, single precision).
 */
export function bumpyPlate(side: number): Mesh {
  const rows = side + 1;
  const position = new Float32Array(rows * rows * 3);
  const height = new Float64Array(rows * rows);
  const flow = new Float32Array(rows * rows * 3);
  for (let vertex = 0; vertex < rows * rows; vertex++) {
    const x = (vertex % rows) / side;
    const y = Math.floor(vertex / rows) / side;
    const bump = 0.1 * Math.sin(6 * x) * Math.cos(5 * y);
    position.set([x, y, bump], 3 * vertex);
    height[vertex] = 1 / 3 + bump;
    flow.set([y, -x, bump], 3 * vertex);
  }
  return {
    position,
    triangles: gridTriangles(side),
    variables: [
      { name: 'height', components: 1, values: height },
      { name: 'flow', components: 3, values: flow },
    ],
  };
}

function gridTriangles(side: number): Uint32Array {
  const rows = side + 1;
  const indices: number[] = [];
  for (let y = 0; y < side; y++) {
    for (let x = 0; x < side; x++) {
      const corner = y * rows + x;
      indices.push(corner, corner + 1, corner + rows + 1, corner, corner + rows + 1, corner + rows);
    }
  }
  return new Uint32Array(indices);
}
