// Edges of no length, at which VTK with attribute errors gives up, are not in the surfaces of the benchmark.
import { execFileSync } from 'node:child_process';
import { expect, test } from 'vitest';
import { mustSkip } from '../skipping.ts';
import { fromRoot } from './cases.ts';
import { findPythonWithVtk } from './contenders.ts';

/** An octahedron whose first corner stands there three times, as a triangle of no area with two more along its edges. */
const surface = {
  position: [
    [0, 0, 1],
    [0, 0, 1],
    [0, 0, 1],
    [1, 0, 0],
    [0, 1, 0],
    [-1, 0, 0],
    [0, -1, 0],
    [0, 0, -1],
  ],
  triangles: [
    [0, 1, 2],
    [0, 3, 1],
    [1, 4, 5],
    [1, 5, 2],
    [2, 5, 6],
    [2, 6, 0],
    [0, 6, 3],
    [1, 3, 4],
    [7, 4, 3],
    [7, 5, 4],
    [7, 6, 5],
    [7, 3, 6],
  ],
};

const python = findPythonWithVtk();

const program = `
import json, sys
sys.path.append(sys.argv[1])
import numpy
from make_meshes import without_point_edges
position, triangles = (numpy.array(json.loads(text)) for text in sys.argv[2:])
print(json.dumps([array.tolist() for array in without_point_edges(position.astype("f4"), triangles)]))
`;

const missing = python ? undefined : 'no Python here has VTK';

test.skipIf(mustSkip(missing))('the ends of edges of no length are merged, and the surface stays closed', () => {
  const given = [fromRoot('tests/bench'), JSON.stringify(surface.position), JSON.stringify(surface.triangles)];
  const [remaining, triangles] = JSON.parse(execFileSync(`${python}`, ['-c', program, ...given], { encoding: 'utf8' }));
  expect(remaining).toEqual([0, 3, 4, 5, 6, 7]);
  // Numbered anew.
  expect(triangles).toEqual([
    [0, 2, 3],
    [0, 3, 4],
    [0, 4, 1],
    [0, 1, 2],
    [5, 2, 1],
    [5, 3, 2],
    [5, 4, 3],
    [5, 1, 4],
  ]);
});
