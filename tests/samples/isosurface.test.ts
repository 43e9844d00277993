import { describe, expect, it } from 'vitest';

import type { Mesh } from '../../wasm/types.ts';
import { isosurface } from '../../web/samples/isosurface.ts';
import type { Volume } from '../../web/samples/simulate.ts';
import { topology } from '../../web/samples/topology.ts';

const nothing = { mass: 0, energy: 0, partialMass: [] };

/** A volume of 20 x 18 x 16 values, 0.5 apart, with the variables that the functions give. */
function volumeOf(functions: Record<string, (x: number, y: number, z: number) => number>): Volume {
  const cells: Volume['cells'] = [20, 18, 16];
  const origin: Volume['origin'] = [-5, -4, -3.75];
  const spacing = 0.5;
  const variables = Object.entries(functions).map(([name, value]) => {
    const values = Float32Array.from({ length: cells[0] * cells[1] * cells[2] }, (_, node) => {
      const [i, j, k] = [
        node % cells[0],
        Math.floor(node / cells[0]) % cells[1],
        Math.floor(node / cells[0] / cells[1]),
      ];
      return value(origin[0] + i * spacing, origin[1] + j * spacing, origin[2] + k * spacing);
    });
    return { name, unit: '1', values };
  });
  return {
    scene: 'test',
    lengthUnit: '1',
    cells,
    origin,
    spacing,
    end: 0,
    steps: 0,
    before: nothing,
    after: nothing,
    variables,
  };
}

/** The volume that a closed surface encloses; negative where it is turned inside out. */
function enclosed(mesh: Mesh): number {
  let sum = 0;
  for (let corner = 0; corner < mesh.triangles.length; corner += 3) {
    const [a, b, c] = [0, 1, 2].map((i) => mesh.position.subarray(3 * mesh.triangles[corner + i]));
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

const linear = (x: number, y: number, z: number) => 1 + 2 * x - 3 * y + 0.5 * z;

describe('isosurface', () => {
  const radius = 3;
  // A ball whose surface passes exactly through values: its radius is a whole number of spacings.
  const volume = volumeOf({ density: (x, y, z) => 10 - Math.hypot(x, y, z), linear });
  const mesh = isosurface(volume, 'density', 10 - radius, ['density', 'linear']);
  const vertices = mesh.position.length / 3;

  it('of a ball is one closed manifold, oriented towards lower values', () => {
    expect(topology(mesh.triangles, vertices)).toEqual({
      badEdges: 0,
      badVertices: 0,
      boundaryLoops: 0,
      components: 1,
    });
    const ball = (4 / 3) * Math.PI * radius ** 3;
    expect(enclosed(mesh)).toBeGreaterThan(0.97 * ball);
    expect(enclosed(mesh)).toBeLessThan(ball);
  });

  it('has each point once', () => {
    const points = Array.from({ length: vertices }, (_, i) => mesh.position.slice(3 * i, 3 * i + 3).join());
    expect(new Set(points).size).toBe(vertices);
  });

  it('carries the isovalue and, exactly, what is linear in space', () => {
    const [density, carried] = mesh.variables;
    for (let i = 0; i < vertices; ++i) {
      const [x, y, z] = mesh.position.subarray(3 * i);
      expect(density.values[i]).toBeCloseTo(10 - radius, 5);
      expect(carried.values[i]).toBeCloseTo(linear(x, y, z), 4);
    }
  });

  it('that leaves the box is open there', () => {
    const plane = isosurface(volumeOf({ density: (x) => x }), 'density', 0.2, []);
    expect(topology(plane.triangles, plane.position.length / 3)).toMatchObject({ boundaryLoops: 1, components: 1 });
    const [a, b, c] = [0, 1, 2].map((i) => plane.position.subarray(3 * plane.triangles[i]));
    const normalX = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
    expect(normalX).toBeLessThan(0); // the lower values are at lower x
  });

  it('of an unknown variable is refused', () => {
    expect(() => isosurface(volume, 'colour', 1, [])).toThrow('no variable “colour”');
  });
});

describe('topology', () => {
  const clean = { badEdges: 0, badVertices: 0, boundaryLoops: 0, components: 1 };

  it.each([
    ['a tetrahedron', [0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2], clean],
    ['a square of two triangles', [0, 1, 2, 0, 2, 3], { ...clean, boundaryLoops: 1 }],
    ['a strip around a hole', [0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 2, 0, 5, 0, 3, 5], { ...clean, boundaryLoops: 2 }],
    ['two triangles apart', [0, 1, 2, 3, 4, 5], { ...clean, boundaryLoops: 2, components: 2 }],
    ['two triangles that touch at a corner', [0, 1, 2, 0, 3, 4], { ...clean, badVertices: 1, boundaryLoops: 1 }],
    ['two triangles that disagree', [0, 1, 2, 0, 1, 3], { ...clean, badEdges: 1, boundaryLoops: 1 }],
    ['three triangles at an edge', [0, 1, 2, 1, 0, 3, 0, 1, 4], { ...clean, badEdges: 1, boundaryLoops: 1 }],
  ])('tells %s', (_, triangles, expected) => {
    expect(topology(Uint32Array.from(triangles), 6)).toEqual(expected);
  });
});
