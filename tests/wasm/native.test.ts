import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { reduce, reduceLevels, resumeReduction } from '../../wasm/index.ts';
import type { Checkpoint, Levels, Mesh, MorphEnd, ReduceOptions, Reduction, SurfaceMap } from '../../wasm/types.ts';
import { mustSkip } from '../skipping.ts';
import { differences, type LabelledArrays, type NumberArray, readLabelledArrays } from './labelled-arrays.ts';

const program = 'build/native/tests/native_reduction';
const bounds = { position: { relative: 0.01 }, '*': { relative: 0.03 } };

/** As native_reduction.cpp has them. */
const settings: { setting: string; options: (mesh: Mesh) => Omit<ReduceOptions, 'errors' | 'cost'> }[] = [
  { setting: 'usual', options: () => ({ bounds }) },
  { setting: 'fine', options: () => ({ bounds: fractions(0.002, 0.006) }) },
  { setting: 'coarse', options: () => ({ bounds: fractions(0.06, 0.2) }) },
  {
    setting: 'apart',
    options: () => ({ bounds: fractions(0.02, 0.06), refusePiercing: true, limitToFeatureSize: true }),
  },
  { setting: 'kept', options: keptOf },
];

function fractions(geometry: number, variables: number): ReduceOptions['bounds'] {
  return { position: { relative: geometry }, '*': { relative: variables } };
}

function keptOf({ position }: Mesh): Omit<ReduceOptions, 'errors' | 'cost'> {
  const middle = 3 * Math.floor(position.length / 3 / 2);
  const corner: [number, number, number] = [position[middle], position[middle + 1], position[middle + 2]];
  return {
    bounds: fractions(0.03, 0.1),
    boundMultiplier: 'multiplier',
    dropSmallComponents: true,
    locked: Uint32Array.of(1),
    lockedRegions: Int32Array.of(2),
    lockedBoxes: [{ lowest: corner, highest: corner }],
  };
}

const modes = [
  { mode: 'tracked', errors: 'tracked', cost: 'introduced' },
  { mode: 'propagated-maximum', errors: 'propagated', cost: 'maximum' },
  { mode: 'propagated-introduced', errors: 'propagated', cost: 'introduced' },
] as const;

function meshOf(arrays: LabelledArrays): Mesh {
  const position = arrays.get('position') as Float64Array;
  const variables = [...arrays].filter(([name]) => name.startsWith('variable:'));
  const regions = arrays.get('regions') as Int32Array | undefined;
  return {
    ...(regions ? { regions } : {}),
    position,
    triangles: arrays.get('triangles') as Uint32Array,
    variables: variables.map(([name, values]) => ({
      name: name.slice('variable:'.length),
      components: values.length / (position.length / 3),
      values: values as Float64Array,
      ...(name === 'variable:ids' ? { kind: 'identifier' as const } : {}),
    })),
  };
}

/** Everything that a reduction holds but its time, named as in native_reduction.cpp. */
function arraysOf(reduction: Reduction): LabelledArrays {
  const { mesh, vertices, triangleErrors, vertexErrors = [], map, report } = reduction;
  const names = report.variables.map(({ name }) => name);
  return new Map<string, NumberArray>([
    ['position', mesh.position],
    ['triangles', mesh.triangles],
    ...mesh.variables.map(({ name, values }) => [`variable:${name}`, values] as const),
    ...(mesh.regions ? [['regions', mesh.regions] as const] : []),
    ['vertices', vertices],
    ...triangleErrors.flatMap(({ largest, lowest, highest, ratio }, i) => [
      [`largest:${names[i]}`, largest] as const,
      [`lowest:${names[i]}`, lowest] as const,
      [`highest:${names[i]}`, highest] as const,
      [`ratio:${names[i]}`, ratio] as const,
    ]),
    ...vertexErrors.flatMap(({ error, signedError }, i) => [
      [`vertexError:${names[i]}`, error] as const,
      [`vertexSignedError:${names[i]}`, signedError] as const,
    ]),
    ...(map ? mapArrays(map) : []),
    ...reportArrays(reduction),
  ]);
}

function mapArrays(map: SurfaceMap): [string, NumberArray][] {
  return Object.entries(map).map(([name, values]) => [`map:${name}`, values]);
}

function reportArrays({ report }: Reduction): [string, NumberArray][] {
  const { triangles, vertices, refused, defects, flippedNormals, nonManifoldVertices, cells, foldedCells } = report;
  const regions = report.regions.flatMap(({ label, triangles: count, area }) => {
    return [label, count.before, count.after, area.before, area.after];
  });
  const counts = [
    [triangles.before, triangles.after, vertices.before, vertices.after],
    [
      report.candidates,
      refused.nonManifold,
      refused.locked,
      refused.ring,
      refused.topology,
      refused.fold,
      refused.piercing,
    ],
    [flippedNormals.before, flippedNormals.after],
    [defects.repeatedVertexTriangles, defects.zeroAreaTriangles, defects.unusedVertices],
    [nonManifoldVertices, cells, foldedCells],
    [report.dropped.components, report.dropped.triangles, report.featureSize ?? 0],
  ];
  const variables = report.variables.map(
    ({ name, extent, magnitude, constant, bound, error, ratio, refused: held }): [string, NumberArray] => [
      `report:${name}`,
      Float64Array.of(extent, magnitude, Number(constant), bound, error, ratio, held),
    ],
  );
  return [
    ['report:counts', Float64Array.from(counts.flat())],
    ['report:regions', Float64Array.from(regions)],
    ...variables,
  ];
}

function cornerArrays(end: string, { position, variables }: MorphEnd): [string, NumberArray][] {
  return [
    [`${end}:position`, position],
    ...variables.map(({ name, values }): [string, NumberArray] => [`${end}:${name}`, values]),
  ];
}

/** Of levels what `reduce` has not, named as in native_reduction.cpp. */
function levelArrays({ levels, morphs }: Levels): LabelledArrays {
  return new Map<string, NumberArray>([
    ...levels.flatMap(({ mesh, vertices }, i): [string, NumberArray][] => [
      [`level${i}`, mesh.triangles],
      [`vertices${i}`, vertices],
    ]),
    ...morphs.flatMap(({ triangles, finer, coarser }, i): [string, NumberArray][] => [
      [`morph${i}`, triangles],
      ...cornerArrays(`finer${i}`, finer),
      ...cornerArrays(`coarser${i}`, coarser),
    ]),
  ]);
}

const missing = existsSync(program) ? undefined : 'the native build is missing';

describe.skipIf(mustSkip(missing))('the native and the WebAssembly build give the same bytes', () => {
  const folder = mkdtempSync(join(tmpdir(), 'meshbound-'));
  const read = (file: string) => readLabelledArrays(readFileSync(join(folder, file)));
  beforeAll(() => execFileSync(program, [folder]));
  afterAll(() => rmSync(folder, { recursive: true }));

  describe.each(settings)('$setting', ({ setting, options }) => {
    test.each(modes)('errors $errors, cost $cost', async ({ mode, errors, cost }) => {
      const names = readdirSync(folder).filter((file) => /^[^.]+\.mesh$/.test(file));
      expect(names.length).toBeGreaterThan(15);
      const found: string[] = [];
      let [before, after] = [0, 0];
      for (const name of names.map((file) => basename(file, '.mesh'))) {
        const mesh = meshOf(read(setting === 'kept' ? `${name}.kept.mesh` : `${name}.mesh`));
        const reduction = await reduce(mesh, { ...options(mesh), errors, cost });
        const { triangles } = reduction.report;
        if (setting === 'usual') expect(triangles.after, name).toBeLessThan(triangles.before);
        before += triangles.before;
        after += triangles.after;
        expect(reduction.map === undefined, name).toBe(errors === 'propagated');
        const different = differences(arraysOf(reduction), read(`${name}.${setting}.${mode}`));
        found.push(...different.map((array) => `${name}: ${array}`));
      }
      expect(found).toEqual([]);
      expect(after).toBeLessThan(before);
    });
  });

  test('levels and morphs', async () => {
    const levels = [bounds, { position: { relative: 0.03 }, '*': { relative: 0.06 } }];
    const names = readdirSync(folder).filter((file) => file.endsWith('.levels'));
    expect(names.length).toBeGreaterThan(15);
    const found: string[] = [];
    for (const name of names.map((file) => basename(file, '.levels'))) {
      const nested = await reduceLevels(meshOf(read(`${name}.mesh`)), { levels, morphs: true });
      const different = differences(levelArrays(nested), read(`${name}.levels`));
      found.push(...different.map((array) => `${name}: ${array}`));
    }
    expect(found).toEqual([]);
  });

  test('onward from a checkpoint', async () => {
    const names = readdirSync(folder).filter((file) => file.endsWith('.onward'));
    expect(names.length).toBeGreaterThan(15);
    const found: string[] = [];
    for (const name of names.map((file) => basename(file, '.onward'))) {
      const { checkpoint } = await reduce(meshOf(read(`${name}.kept.mesh`)), { bounds, checkpoint: true });
      const onward = await resumeReduction(checkpoint as Checkpoint, { bounds: fractions(0.03, 0.06) });
      found.push(...differences(arraysOf(onward), read(`${name}.onward`)).map((array) => `${name}: ${array}`));
    }
    expect(found).toEqual([]);
  });
});
