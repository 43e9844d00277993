import { beforeAll, describe, expect, test } from 'vitest';
import { levelPaths, parseLevels } from '../../web/node-cli/options/level-arguments.ts';
import { Folder } from './command.ts';
import { engine } from './engine.ts';

const folder = new Folder();
const original = engine();

beforeAll(() => folder.save('engine.vtp', original));

/** Reduces the engine to levels, and reads the report. */
async function reduce(output: string, ...args: string[]) {
  const outcome = await folder.run('reduce', 'engine.vtp', '-o', output, '--report', 'report.json', ...args);
  expect(outcome.stderr).not.toContain('meshbound:');
  expect(outcome.status).toBe(0);
  return { ...outcome, report: JSON.parse(folder.text('report.json')) };
}

/** Places in space as text, to be compared in any order. */
async function placesIn(name: string): Promise<Set<string>> {
  const { position } = (await folder.read(name)).mesh;
  return new Set(Array.from({ length: position.length / 3 }, (_, v) => position.slice(3 * v, 3 * v + 3).join(' ')));
}

test('writes nested levels to numbered files, finest first, and says so', async () => {
  const { stdout, stderr, report } = await reduce('small.vtp', '--levels', '1%,3%,9%');
  const files = ['small-1.vtp', 'small-2.vtp', 'small-3.vtp'];
  expect(report.levels.map(({ file }: { file: string }) => file)).toEqual(files);
  for (const [i, file] of files.entries()) {
    const { mesh } = await folder.read(file);
    expect(mesh.variables.map(({ name }) => name)).toEqual(['pressure', 'velocity', 'temperature']);
    expect(report.levels[i].triangles).toEqual({ before: 512, after: mesh.triangles.length / 3 });
    expect(stdout).toContain(file);
    if (i === 0) continue;
    const finer = await placesIn(files[i - 1]);
    const here = await placesIn(file);
    expect(here.size).toBeLessThan(finer.size);
    expect([...here].filter((place) => !finer.has(place))).toEqual([]);
  }
  expect(folder.files()).not.toContain('small.vtp');
  expect(stdout).toContain('512 triangles -> 3 levels');
  expect(stderr).toBe('');
});

test('every level keeps its bounds, as verify finds', async () => {
  await reduce('check-#.ply', '--levels', '2%,6%', '-b', 'position=0.5%,2%');
  for (const [file, bounds] of [
    ['check-1.ply', ['-b', '*=2%', '-b', 'position=0.5%']],
    ['check-2.ply', ['-b', '*=6%', '-b', 'position=2%']],
  ] as const) {
    const { status, stderr } = await folder.run('verify', 'engine.vtp', file, ...bounds);
    expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  }
});

test('the report has an entry of the usual shape for each level', async () => {
  const { report } = await reduce('out.ply', '--levels', '1%,3%', '-b', 'temperature=free', '-b', 'pressure=2%');
  expect(Object.keys(report)).toEqual(['levels']);
  expect(report.levels[1].options).toEqual({
    bounds: { '*': { relative: 0.03 }, temperature: 'free', pressure: { relative: 0.02 } },
    errors: 'tracked',
    cost: 'introduced',
    refusePiercing: false,
    limitToFeatureSize: false,
    dropSmallComponents: false,
    boundMultiplier: null,
    region: null,
    lockPoints: [],
    lockRegions: [],
    lockBoxes: [],
  });
  for (const level of report.levels) {
    expect(Object.keys(level)).toEqual([
      'file',
      'triangles',
      'defects',
      'nonManifoldVertices',
      'seams',
      'map',
      'flippedNormals',
      'dropped',
      'featureSize',
      'unusedLockedBoxes',
      'variables',
      'refused',
      'regions',
      'vanishedRegions',
      'seconds',
      'options',
      'termination',
    ]);
    expect(level.variables.map(({ name }: { name: string }) => name)).toEqual([
      'position',
      'pressure',
      'velocity',
      'temperature',
    ]);
    expect(level.variables[3].bound).toBeNull();
  }
});

test('writes one GLB of all levels, which others read as the finest', async () => {
  const { stdout, stderr, report } = await reduce('levels.glb', '--levels', '1%,3%,9%');
  expect(folder.files().filter((name) => name.startsWith('levels'))).toEqual(['levels.glb']);
  const { mesh } = await folder.read('levels.glb');
  expect(mesh.triangles.length / 3).toBe(report.levels[0].triangles.after);
  expect(report.levels.map(({ file }: { file: string }) => file)).toEqual(['levels.glb', 'levels.glb', 'levels.glb']);
  expect(stdout).toContain('3 levels');
  expect(stderr).toContain('levels.glb: GLB knows single precision only; rounded: “pressure” (by up to ');
  await reduce('part-#.glb', '--levels', '1%,3%');
  expect(folder.files().filter((name) => name.startsWith('part'))).toEqual(['part-1.glb', 'part-2.glb']);
});

describe('the bounds of levels', () => {
  const relative = (percent: number) => ({ relative: percent / 100 });

  test('are the list for all variables not named', () => {
    expect(parseLevels('1%,3%', [])).toEqual([{ '*': relative(1) }, { '*': relative(3) }]);
    expect(parseLevels('0.5', [])).toEqual([{ '*': { absolute: 0.5 } }]);
  });

  test('are one for each level, or one for all, where a variable is named', () => {
    expect(parseLevels('1%,3%', ['position=1%,2%', 'p=0.1', 'q=free'])).toEqual([
      { '*': relative(1), position: relative(1), p: { absolute: 0.1 }, q: 'free' },
      { '*': relative(3), position: relative(2), p: { absolute: 0.1 }, q: 'free' },
    ]);
  });
});

test('files are numbered before the ending, or where # stands', () => {
  expect(levelPaths('a/small.vtp', 2)).toEqual(['a/small-1.vtp', 'a/small-2.vtp']);
  expect(levelPaths('small.ply.gz', 2)).toEqual(['small-1.ply.gz', 'small-2.ply.gz']);
  expect(levelPaths('lod#/x.glb', 2)).toEqual(['lod1/x.glb', 'lod2/x.glb']);
  expect(levelPaths('x.glb', 2)).toEqual(['x.glb']);
  expect(levelPaths('x.stl', 10)[0]).toBe('x-01.stl');
});
