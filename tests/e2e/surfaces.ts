/** Files made for tests, as bytes. */

import { gzipSync } from 'node:zlib';

interface PlyParts {
  /** x, y, z and the variables of each vertex, as written. */
  vertices: (string | number)[][];
  faces: number[][];
  variables?: string[];
  /** Where the header is to say something else than the truth. */
  declared?: { vertices?: number; faces?: number };
}

export function ply({ vertices, faces, variables = [], declared = {} }: PlyParts): Buffer {
  const lines = [
    'ply',
    'format ascii 1.0',
    `element vertex ${declared.vertices ?? vertices.length}`,
    ...['x', 'y', 'z', ...variables].map((name) => `property float ${name}`),
    `element face ${declared.faces ?? faces.length}`,
    'property list uchar int vertex_indices',
    'end_header',
    ...vertices.map((vertex) => vertex.join(' ')),
    ...faces.map((face) => [face.length, ...face].join(' ')),
  ];
  return Buffer.from(`${lines.join('\n')}\n`);
}

/** Two triangles to each square of side × side vertices, row by row. */
function gridFaces(side: number): number[][] {
  const faces: number[][] = [];
  for (let row = 0; row + 1 < side; row++) {
    for (let column = 0; column + 1 < side; column++) {
      const corner = row * side + column;
      faces.push([corner, corner + 1, corner + side + 1], [corner, corner + side + 1, corner + side]);
    }
  }
  return faces;
}

/** A wavy sheet of 2 × (side − 1)² triangles with two variables, `heat` and `wind`. */
export function sheet(side: number): Buffer {
  const vertices = Array.from({ length: side * side }, (_, index) => {
    const [x, y] = [(index % side) / (side - 1), Math.floor(index / side) / (side - 1)];
    return [x, y, 0.1 * Math.sin(7 * x) * Math.cos(5 * y), 300 + 40 * Math.sin(9 * x + 4 * y), Math.cos(11 * x * y)];
  });
  return ply({ vertices, faces: gridFaces(side), variables: ['heat', 'wind'] });
}

/** A flat sheet with z = x, whose box along the axes is large, but not those of its triangles. */
export function slope(side: number): Buffer {
  const vertices = Array.from({ length: side * side }, (_, index) => {
    const [x, y] = [(index % side) / (side - 1), Math.floor(index / side) / (side - 1)];
    return [x, y, x];
  });
  return ply({ vertices, faces: gridFaces(side) });
}

/**
 * A flat sheet with a hill of height 0.1 on the left and a hollow as deep on the right; `heat` rises to 1 on the hill and
 * falls to −1 in the hollow; the vector `wind` does so in one component. Everything is zero along the boundary.
 */
export function hillAndHollow(side: number): Buffer {
  const bump = (x: number, y: number, middle: number) => {
    const distance = Math.hypot(x - middle, y - 0.5) / 0.25;
    return distance < 1 ? Math.cos((Math.PI / 2) * distance) ** 2 : 0;
  };
  const vertices = Array.from({ length: side * side }, (_, index) => {
    const [x, y] = [(index % side) / (side - 1), Math.floor(index / side) / (side - 1)];
    const heat = bump(x, y, 0.25) - bump(x, y, 0.75);
    return [x, y, 0.1 * heat, heat, 0, heat, 0];
  });
  return ply({ vertices, faces: gridFaces(side), variables: ['heat', 'wind_x', 'wind_y', 'wind_z'] });
}

/** A square around a middle vertex, whose variable `pressure` has no number at vertex 1. */
export function squareWithNaN(): Buffer {
  return ply({
    vertices: [
      [0, 0, 0, 1, 0],
      [1, 0, 0, 'nan', 1],
      [1, 1, 0, 2, 2],
      [0, 1, 0, 3, 1],
      [0.5, 0.5, 0, 1.5, 1],
    ],
    faces: [
      [0, 1, 4],
      [1, 2, 4],
      [2, 3, 4],
      [3, 0, 4],
    ],
    variables: ['pressure', 'height'],
  });
}

const corners = [
  [0, 0, 0],
  [1, 0, 0],
  [0, 1, 0],
];
const face = [[0, 1, 2]];

const shortVtp = `<VTKFile type="PolyData" version="1.0"><PolyData><Piece NumberOfPoints="3" NumberOfPolys="1">
<PointData><DataArray type="Float32" Name="heat" format="ascii">1 2</DataArray></PointData>
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys></Piece></PolyData></VTKFile>`;

/** Files that cannot be opened, with what the message must say. */
export const brokenFiles: { name: string; content: Buffer; says: RegExp }[] = [
  { name: 'diary.txt', content: Buffer.from('Dear diary'), says: /no mesh file/ },
  { name: 'empty.ply', content: Buffer.alloc(0), says: /empty/ },
  { name: 'cut.ply', content: ply({ vertices: corners, faces: [], declared: { faces: 1 } }), says: /face/ },
  { name: 'points.ply', content: ply({ vertices: corners, faces: [] }), says: /no faces/ },
  { name: 'index.ply', content: ply({ vertices: corners, faces: [[0, 1, 7]] }), says: /[Ff]ace 0 .*7.*3 points/ },
  { name: 'bomb.ply.gz', content: gzipSync(Buffer.alloc(64 << 20)), says: /that is no mesh/ },
  { name: 'short.vtp', content: Buffer.from(shortVtp), says: /heat.*3/ },
  {
    name: 'nowhere.ply',
    content: ply({ vertices: [corners[0], [1, 'nan', 0], corners[2]], faces: face }),
    says: /position.*vertex 1/,
  },
];
