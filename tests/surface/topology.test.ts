import { expect, test } from 'vitest';
import { topologyOf } from '../../web/surface/topology.ts';

const manifold = { nonManifoldEdges: 0, discordantEdges: 0, nonManifoldVertices: 0 };

function topology(...triangles: [number, number, number][]) {
  const corners = Uint32Array.from(triangles.flat());
  return topologyOf(corners, Math.max(...corners) + 1);
}

/** A grid of columns × rows squares, two triangles each; with `wrapped` its last column is joined to the first. */
function grid(columns: number, rows: number, wrapped = false): [number, number, number][] {
  const width = wrapped ? columns : columns + 1;
  const at = (x: number, y: number) => y * width + (x % width);
  const squares = Array.from({ length: columns * rows }, (_, i) => [i % columns, Math.floor(i / columns)]);
  return squares.flatMap(([x, y]): [number, number, number][] => [
    [at(x, y), at(x + 1, y), at(x + 1, y + 1)],
    [at(x, y), at(x + 1, y + 1), at(x, y + 1)],
  ]);
}

test('a plate has one boundary', () => {
  expect(topology(...grid(3, 4))).toEqual({ components: 1, boundaryLoops: 1, ...manifold });
});

test('a tube has two boundaries', () => {
  expect(topology(...grid(5, 2, true))).toEqual({ components: 1, boundaryLoops: 2, ...manifold });
});

test('a tetrahedron has none', () => {
  const faces: [number, number, number][] = [
    [0, 2, 1],
    [0, 1, 3],
    [1, 2, 3],
    [2, 0, 3],
  ];
  expect(topology(...faces)).toEqual({ components: 1, boundaryLoops: 0, ...manifold });
});

test('parts that share no vertex are components; unused vertices are not', () => {
  expect(topology([0, 1, 2], [7, 5, 4])).toEqual({ components: 2, boundaryLoops: 2, ...manifold });
});

test('triangles with a vertex twice do not count', () => {
  expect(topology([0, 1, 2], [2, 1, 1], [5, 5, 6])).toEqual({ components: 1, boundaryLoops: 1, ...manifold });
});

test('two triangles that touch in a vertex: one component, two loops, one vertex with two fans', () => {
  expect(topology([0, 1, 2], [0, 3, 4])).toEqual({
    components: 1,
    boundaryLoops: 2,
    nonManifoldEdges: 0,
    discordantEdges: 0,
    nonManifoldVertices: 1,
  });
});

test('an edge of three triangles is not manifold', () => {
  expect(topology([0, 1, 2], [1, 0, 3], [0, 1, 4])).toMatchObject({
    components: 1,
    nonManifoldEdges: 1,
    discordantEdges: 0,
    nonManifoldVertices: 2,
  });
});

test('every vertex on the edge that three sheets share is not manifold, and no other is', () => {
  const rows = 30;
  // The first column of each sheet is the shared one: vertices 0 … rows.
  const sheets = [0, 1, 2].flatMap((sheet) => {
    const own = (vertex: number) => (vertex % 2 === 0 ? vertex / 2 : (sheet + 1) * (rows + 1) + (vertex - 1) / 2);
    return grid(1, rows).map((corners) => corners.map(own) as [number, number, number]);
  });
  expect(topology(...sheets)).toMatchObject({ components: 1, nonManifoldEdges: rows, nonManifoldVertices: rows + 1 });
});

test('nor is an edge whose two triangles disagree about the orientation', () => {
  expect(topology([0, 1, 2], [0, 1, 3])).toMatchObject({
    boundaryLoops: 1,
    nonManifoldEdges: 1,
    discordantEdges: 1,
    nonManifoldVertices: 0,
  });
});

test('no triangles, nothing', () => {
  expect(topologyOf(new Uint32Array(), 0)).toEqual({ components: 0, boundaryLoops: 0, ...manifold });
});
