import { describe, expect, test } from 'vitest';
import { reduceLevels } from '../../wasm/index.ts';
import type { Bound, Mesh, Morph, MorphEnd, Variable } from '../../wasm/types.ts';
import { bumpyPlate } from './bumpy-plate.ts';

const percent = (share: number): Record<string, Bound> => ({
  position: { relative: share / 100 },
  '*': { relative: (3 * share) / 100 },
});
const levels = [percent(0.5), percent(1), percent(4)];

function expectVertices(corners: MorphEnd, mesh: Mesh): void {
  const expectFirst = (found: Variable['values'], expected: Variable['values']) => {
    expect(found.constructor).toBe(expected.constructor);
    expect(found.subarray(0, expected.length)).toEqual(expected);
  };
  expectFirst(corners.position, mesh.position);
  corners.variables.forEach(({ name, components, values }, i) => {
    const expected = mesh.variables[i] as Variable;
    expect({ name, components }).toEqual({ name: expected.name, components: expected.components });
    expectFirst(values, expected.values);
  });
}

/** Area of the triangles in space. */
function area(triangles: Uint32Array, position: ArrayLike<number>): number {
  const at = (corner: number, axis: number) => position[3 * (triangles[corner] as number) + axis] as number;
  let sum = 0;
  for (let corner = 0; corner < triangles.length; corner += 3) {
    const edge = (to: number, axis: number) => at(corner + to, axis) - at(corner, axis);
    const part = (i: number, j: number) => edge(1, i) * edge(2, j) - edge(1, j) * edge(2, i);
    sum += Math.hypot(part(1, 2), part(2, 0), part(0, 1)) / 2;
  }
  return sum;
}

describe('reduceLevels', () => {
  test('gives nested levels, each with its report against the original', async () => {
    const mesh = bumpyPlate(40);
    const { levels: nested, morphs } = await reduceLevels(mesh, { levels });
    expect(morphs).toEqual([]);
    expect(nested).toHaveLength(3);
    nested.forEach(({ mesh: reduced, vertices, report, triangleErrors, map }, i) => {
      expect(report.triangles).toEqual({ before: 3200, after: reduced.triangles.length / 3 });
      expect(report.variables[0]?.bound).toBeGreaterThan(nested[i - 1]?.report.variables[0]?.bound ?? 0);
      for (const { ratio } of report.variables) expect(ratio).toBeLessThanOrEqual(1);
      expect(triangleErrors[0]?.largest).toHaveLength(reduced.triangles.length / 3);
      expect(map?.triangle).toHaveLength(mesh.position.length / 3);
      if (i === 0) return;
      const finer = new Set(nested[i - 1]?.vertices);
      expect(vertices.every((vertex) => finer.has(vertex))).toBe(true);
      expect(vertices.length).toBeLessThan(finer.size);
    });
  });

  test('gives the morphs between neighbours, from the original on', async () => {
    const mesh = bumpyPlate(30);
    const { levels: nested, morphs } = await reduceLevels(mesh, { levels, morphs: true });
    expect(morphs).toHaveLength(3);
    morphs.forEach((morph: Morph, i) => {
      const finer = nested[i - 1]?.mesh ?? mesh;
      const coarser = nested[i]?.mesh as Mesh;
      expectVertices(morph.finer, finer);
      expect(morph.coarser.position).toHaveLength(morph.finer.position.length);
      expect(area(morph.triangles, morph.finer.position)).toBeCloseTo(area(finer.triangles, finer.position), 4);
      expect(area(morph.triangles, morph.coarser.position)).toBeGreaterThan(
        area(coarser.triangles, coarser.position) - 1e-4,
      );
      expect(morph.triangles.length).toBeLessThan(4 * finer.triangles.length);
      expect(morph.foldedTriangles).toBeLessThan(morph.triangles.length / 30);
      expect(morph.foldedShare).toBeLessThan(0.01);
    });
  });

  test('makes no morphs where errors are propagated', async () => {
    const { levels: nested, morphs } = await reduceLevels(bumpyPlate(10), {
      levels,
      morphs: true,
      errors: 'propagated',
    });
    expect(nested).toHaveLength(3);
    expect(nested[0]?.map).toBeUndefined();
    expect(morphs).toEqual([]);
  });

  test('tells the side from which edges are crossed', async () => {
    const { levels: nested } = await reduceLevels(bumpyPlate(20), { levels });
    const map = nested[0]?.map;
    expect(map?.crossingRightward).toHaveLength((map?.crossingShares.length as number) / 2);
    expect(new Set(map?.crossingRightward)).toEqual(new Set([0, 1]));
  });

  test.each([
    { what: 'no levels', given: [], message: /at least one/, fault: { code: 'bad_levels' } },
    {
      what: 'a bound that falls',
      given: [percent(2), percent(1)],
      message: /“position” falls.*level 1.*level 2/,
      fault: { code: 'bad_levels', variable: 'position', index: 1 },
    },
    {
      what: 'the same bounds twice',
      given: [percent(1), percent(1)],
      message: /level 2/,
      fault: { code: 'bad_levels' },
    },
    {
      what: 'an unknown variable',
      given: [percent(1), { presure: { relative: 1 } }],
      message: /presure/,
      fault: { code: 'unknown_variable', variable: 'presure' },
    },
  ])('refuses $what', async ({ given, message, fault }) => {
    const failure = await reduceLevels(bumpyPlate(6), { levels: given as Record<string, Bound>[] }).catch(
      (error) => error,
    );
    expect(failure).toMatchObject(fault);
    expect(failure.message).toMatch(message);
  });

  test('rises in progress and can be aborted', async () => {
    const seen: number[] = [];
    await reduceLevels(bumpyPlate(60), { levels, morphs: true, onProgress: (progress) => seen.push(progress) });
    expect(seen).toEqual(seen.toSorted((a, b) => a - b));
    expect(seen.at(-1)).toBe(1);
    const controller = new AbortController();
    const running = reduceLevels(bumpyPlate(100), {
      levels,
      signal: controller.signal,
      onProgress: () => controller.abort(),
    });
    await expect(running).rejects.toMatchObject({ name: 'AbortError' });
  });
});
