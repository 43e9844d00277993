import { existsSync, readFileSync } from 'node:fs';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { beforeAll, describe, expect, it } from 'vitest';

import { type ListedSample, samples } from '../../web/samples/catalogue.ts';
import { topology } from '../../web/samples/topology.ts';

const folder = new URL('../../build/samples/', import.meta.url);

interface Surface {
  header: string;
  position: Float32Array;
  triangles: Uint32Array;
  variables: Record<string, Float32Array>;
}

/** Milliseconds that a busy machine may need for the fine surfaces. */
const reading = 60_000;

/** Reads a sample with three's loader, which knows nothing of how it was written. */
function read(name: string, variables: readonly string[]): Surface {
  const file = new URL(`${name}.ply`, folder);
  if (!existsSync(file)) {
    throw new Error(`There is no ${name}.ply yet: make the samples with "npx tsx web/samples/build.ts".`);
  }
  const bytes = readFileSync(file);
  const loader = new PLYLoader();
  loader.setCustomPropertyNameMapping(Object.fromEntries(variables.map((variable) => [variable, [variable]])));
  const geometry = loader.parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
  const array = (attribute: string) => geometry.getAttribute(attribute).array as Float32Array;
  return {
    header: bytes.toString('latin1', 0, bytes.indexOf('end_header')),
    position: array('position'),
    triangles: Uint32Array.from(geometry.index?.array ?? []),
    variables: Object.fromEntries(variables.map((variable) => [variable, array(variable)])),
  };
}

/** What is promised of each: how many triangles, how many boundary loops (none: closed), how many variables. */
const promised = {
  fireballs: { triangles: [7000, 7500], boundaryLoops: 0, variables: 7 },
  impact: { triangles: [7000, 7500], boundaryLoops: 2, variables: 6 },
  'fireballs-fine': { triangles: [100_000, 200_000], boundaryLoops: 0, variables: 7 },
  'impact-fine': { triangles: [100_000, 200_000], boundaryLoops: 2, variables: 6 },
};

it('lists every sample', () => {
  const list = JSON.parse(readFileSync(new URL('samples.json', folder), 'utf8')) as ListedSample[];
  expect(list.map(({ name }) => name)).toEqual(Object.keys(promised));
  expect(samples.map(({ name }) => name)).toEqual(Object.keys(promised));
});

describe.each(samples)('$name', { timeout: reading }, ({ name, variables }) => {
  const { triangles, boundaryLoops, variables: count } = promised[name as keyof typeof promised];
  let surface: Surface;
  let entry: ListedSample;

  beforeAll(() => {
    surface = read(name, variables);
    const list = JSON.parse(readFileSync(new URL('samples.json', folder), 'utf8')) as ListedSample[];
    entry = list.find((listed) => listed.name === name) as ListedSample;
  });

  it('has as many triangles as promised', () => {
    expect(surface.triangles.length / 3).toBeGreaterThanOrEqual(triangles[0]);
    expect(surface.triangles.length / 3).toBeLessThanOrEqual(triangles[1]);
    expect(entry).toMatchObject({
      file: `${name}.ply`,
      triangles: surface.triangles.length / 3,
      vertices: surface.position.length / 3,
    });
  });

  it('is an oriented manifold', () => {
    const shape = topology(surface.triangles, surface.position.length / 3);
    expect(shape).toMatchObject({ badEdges: 0, badVertices: 0, boundaryLoops });
    expect(entry).toMatchObject({ boundaryLoops: shape.boundaryLoops, components: shape.components });
  });

  it('has no triangle without area and no point twice', () => {
    const points = new Set<string>();
    for (let vertex = 0; vertex < surface.position.length; vertex += 3) {
      points.add(surface.position.subarray(vertex, vertex + 3).join());
    }
    expect(points.size).toBe(surface.position.length / 3);
    let smallest = Number.POSITIVE_INFINITY;
    for (let corner = 0; corner < surface.triangles.length; corner += 3) {
      const [a, b, c] = [0, 1, 2].map((i) => surface.position.subarray(3 * surface.triangles[corner + i]));
      const [u, v] = [b, c].map((end) => [end[0] - a[0], end[1] - a[1], end[2] - a[2]]);
      const doubleArea = Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
      smallest = Math.min(smallest, doubleArea);
    }
    expect(smallest).toBeGreaterThan(0);
  });

  it('carries its variables with their units, finite, and none constant but the density', () => {
    expect(variables).toHaveLength(count);
    expect(Object.keys(entry.units)).toEqual(['position', ...variables]);
    for (const [variable, values] of Object.entries(surface.variables)) {
      expect(surface.header).toContain(`property float ${variable}\n`);
      expect(surface.header).toContain(`comment unit ${variable} ${entry.units[variable]}\n`);
      expect(values.every(Number.isFinite)).toBe(true);
      const sorted = values.slice().sort();
      const [lowest, highest] = [sorted[0], sorted[sorted.length - 1]];
      if (variable === 'density') {
        expect(highest - lowest).toBeLessThan(1e-6 * highest);
        continue;
      }
      // Spread over the surface, not only at a few points: the middle half spans a part of the whole.
      const middleHalf = sorted[Math.floor(0.75 * sorted.length)] - sorted[Math.floor(0.25 * sorted.length)];
      expect(middleHalf).toBeGreaterThan(0.005 * (highest - lowest));
    }
  });
});

describe('fireballs', { timeout: reading }, () => {
  it.each(['pressure', 'energy', 'temperature'])('%s is positive', (variable) => {
    const { variables } = read('fireballs-fine', [variable]);
    expect(variables[variable].every((value) => value > 0)).toBe(true);
  });
});
