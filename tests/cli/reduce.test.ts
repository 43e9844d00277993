import { beforeAll, describe, expect, test } from 'vitest';
import type { Mesh, Report } from '../../wasm/types.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { reportText } from '../../web/node-cli/output/report.ts';
import { Folder } from './command.ts';
import { engine } from './engine.ts';

const folder = new Folder();
const original = engine();

beforeAll(() => folder.save('engine.vtp', original));

const all = ['-b', 'position=1%', '-b', '*=3%'];

/** Reduces the engine to out.vtp, and reads the report. */
async function reduce(...args: string[]) {
  const outcome = await folder.run('reduce', 'engine.vtp', '-o', 'out.vtp', '--report', 'report.json', ...args);
  expect(outcome.stderr).not.toContain('meshbound:');
  expect(outcome.status).toBe(0);
  return { ...outcome, report: JSON.parse(folder.text('report.json')) };
}

type VariableOfReport = {
  name: string;
  components: number;
  extent: number;
  bound: number | null;
  error: number;
  ratio: number;
};

function boundsIn({ variables }: { variables: VariableOfReport[] }) {
  return Object.fromEntries(variables.map(({ name, bound }) => [name, bound]));
}

/** Position and values of each vertex as one text, so that they can be compared bit for bit in any order. */
function vertices({ position, variables }: Mesh): Set<string> {
  const arrays = [{ components: 3, values: position }, ...variables];
  const row = (vertex: number) =>
    arrays.flatMap(({ components, values }) => [...values.slice(vertex * components, (vertex + 1) * components)]);
  return new Set(Array.from({ length: position.length / 3 }, (_, vertex) => row(vertex).join(' ')));
}

/** Name, components and precision of each variable. */
function kinds({ variables }: Mesh) {
  return variables.map(({ name, components, values }) => [name, components, values.constructor]);
}

test('writes fewer triangles, whose vertices are the original’s with their values, and says so', async () => {
  const { stdout, stderr } = await reduce(...all);
  const { mesh } = await folder.read('out.vtp');
  expect(mesh.triangles.length).toBeLessThan(original.triangles.length / 2);
  expect(kinds(mesh)).toEqual(kinds(original));
  const known = vertices(original);
  expect([...vertices(mesh)].filter((vertex) => !known.has(vertex))).toEqual([]);
  expect(stdout).toContain(`512 -> ${mesh.triangles.length / 3} triangles`);
  expect(stderr).toBe('');
});

test('the report has the documented shape', async () => {
  const { report } = await reduce(...all, '-b', 'temperature=free');
  const variable = (name: string, components: number, bound: unknown, ratio: unknown) => {
    const [extent, error, constant] = [expect.any(Number), expect.any(Number), false];
    return { name, components, kind: 'quantity', nonFinite: null, extent, constant, bound, error, ratio };
  };
  const number = expect.any(Number);
  expect(report).toEqual({
    triangles: { before: 512, after: (await folder.read('out.vtp')).mesh.triangles.length / 3 },
    defects: { flippedTriangles: 0, unorientableComponents: 0, copiedTriangles: 0, twoSidedTriangles: 0 },
    nonManifoldVertices: 0,
    seams: { points: 0, touching: 0 },
    map: { cells: number, foldedCells: number },
    flippedNormals: { before: number, after: number },
    dropped: { components: 0, triangles: 0 },
    featureSize: null,
    unusedLockedBoxes: [],
    refused: {
      candidates: number,
      bounds: { position: number, pressure: number, velocity: number, temperature: 0 },
      nonManifold: 0,
      locked: 0,
      ring: 0,
      topology: number,
      fold: number,
      piercing: 0,
      whyLittleWent: null,
    },
    regions: [],
    vanishedRegions: [],
    variables: [
      variable('position', 3, number, number),
      variable('pressure', 1, number, number),
      variable('velocity', 3, number, number),
      variable('temperature', 1, null, null),
    ],
    seconds: number,
    options: {
      bounds: { position: { relative: 0.01 }, '*': { relative: 0.03 }, temperature: 'free' },
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
    },
    termination: 'finished',
  });
});

test('errors and bounds of the report belong together', async () => {
  const { report } = await reduce(...all);
  for (const { name, extent, bound, error, ratio } of report.variables) {
    expect(bound / extent).toBeCloseTo(name === 'position' ? 0.01 : 0.03, 12);
    expect(ratio).toBeCloseTo(error / bound, 12);
    expect(ratio).toBeLessThanOrEqual(1);
  }
});

describe('bounds', () => {
  test('the later of two with one name holds; * reaches what is not named, wherever it stands', async () => {
    const { report } = await reduce('-b', 'pressure=9', '-b', '*=0.5', '-b', 'pressure=0.25', '-b', 'position=2');
    expect(boundsIn(report)).toEqual({ position: 2, pressure: 0.25, velocity: 0.5, temperature: 0.5 });
  });

  test('% is of the extent, also behind a space, and numbers may be written with exponents', async () => {
    const { report } = await reduce('-b', 'pressure=5 %', '-b', 'velocity=2e-1', '-b', '*=free');
    const [, pressure] = report.variables;
    expect(pressure.bound).toBeCloseTo(0.05 * pressure.extent, 12);
    expect(boundsIn(report)).toMatchObject({ position: null, velocity: 0.2, temperature: null });
  });

  test('a variable without a bound is free, and that is said', async () => {
    const { report, stdout, stderr } = await reduce('-b', 'position=1%', '-b', 'velocity=3%');
    expect(boundsIn(report)).toMatchObject({ pressure: null, temperature: null });
    expect(stderr).toContain('engine.vtp: No bound was given for “pressure”, “temperature”: free');
    expect(stdout).toMatch(/^ {2}pressure +free/m);
  });

  test('looser bounds leave fewer triangles', async () => {
    const tight = (await reduce('-b', '*=0.5%')).report.triangles.after;
    const loose = (await reduce('-b', '*=10%')).report.triangles.after;
    expect(loose).toBeLessThan(tight);
  });
});

describe('options', () => {
  test('--errors and --cost reach the reduction', async () => {
    const { report } = await reduce(...all, '--errors', 'propagated', '--cost', 'maximum');
    expect(report.options).toMatchObject({ errors: 'propagated', cost: 'maximum' });
    const introduced = await reduce(...all, '--errors', 'propagated');
    const tracked = await reduce(...all);
    const after = [report, introduced.report, tracked.report].map(({ triangles }) => triangles.after);
    expect(new Set(after).size).toBe(3);
    expect(Math.min(...after)).toBe(tracked.report.triangles.after);
  });

  test('a --cost without effect is said to have none', async () => {
    expect((await reduce(...all, '--cost', 'maximum')).stderr).toContain(
      '--cost has an effect with --errors propagated only',
    );
  });

  test('--quiet says nothing', async () => {
    expect(await reduce('-b', 'position=1%', '--quiet')).toMatchObject({ stdout: '', stderr: '' });
  });

  test('the ending gives the format; what it has no place for is said', async () => {
    const stl = await folder.run('reduce', 'engine.vtp', '-o', 'out.stl', ...all);
    expect(stl.stderr).toContain('out.stl: STL has no place for the variables “pressure”, “velocity”, “temperature”');
    expect((await folder.read('out.stl')).format).toBe('stl');
    await folder.run('reduce', 'engine.vtp', '-o', 'out.ply.gz', ...all);
    expect(kinds((await folder.read('out.ply.gz')).mesh)).toEqual(kinds(original));
  });
});

describe('--map', () => {
  test('stores with the original where each vertex went and what error it has there', async () => {
    const { report } = await reduce(...all, '--map', 'map.vtp');
    const [{ mesh }, { mesh: reduced }] = [await folder.read('map.vtp'), await folder.read('out.vtp')];
    const values = (name: string) => [...(mesh.variables.find((each) => each.name === name)?.values ?? [])];
    expect(mesh.triangles).toEqual(original.triangles);
    expect(kinds(mesh).slice(0, 3)).toEqual(kinds(original));
    const triangles = values('reduced_triangle');
    const weights = values('reduced_barycentric');
    const errors = values('pressure_error');
    const signed = values('pressure_signed_error');
    const [pressure, before] = [reduced.variables[0].values, original.variables[0].values];
    for (const [vertex, triangle] of triangles.entries()) {
      const corners = [0, 1, 2].map((corner) => pressure[reduced.triangles[3 * triangle + corner]]);
      const there = corners.reduce((sum, value, corner) => sum + value * weights[3 * vertex + corner], 0);
      expect(signed[vertex]).toBeCloseTo(before[vertex] - there, 6);
      expect(errors[vertex]).toBeCloseTo(Math.abs(before[vertex] - there), 6);
    }
    expect(Math.max(...errors)).toBeLessThanOrEqual(report.variables[1].error);
    expect(Math.max(...errors)).toBeGreaterThan(0);
  });

  test('keeps units, and gives errors those of their variables', async () => {
    const units = { position: 'mm', pressure: 'Pa' };
    folder.write('units.vtp', await writeSurface('vtp', original, { units }));
    await folder.run('reduce', 'units.vtp', '-o', 'out.ply', ...all, '--map', 'map.vtp');
    expect({ ...(await folder.read('out.ply')).units }).toEqual(units);
    expect({ ...(await folder.read('map.vtp')).units }).toEqual({
      ...units,
      position_error: 'mm',
      position_signed_error: 'mm',
      pressure_error: 'Pa',
      pressure_signed_error: 'Pa',
    });
  });

  test('tells vectors by the length of the error, and position by the distance along the normal too', async () => {
    await reduce(...all, '--map', 'map.vtp');
    const names = (await folder.read('map.vtp')).mesh.variables.map(({ name }) => name);
    expect(names).toContain('velocity_error');
    expect(names).not.toContain('velocity_signed_error');
    expect(names).toContain('position_signed_error');
  });
});

test('variables may be named like what JavaScript or the command line has already', async () => {
  const names = ['__proto__', 'constructor', 'a=b', 'x y', '-q'];
  const [pressure] = original.variables;
  await folder.save('names.vtp', { ...original, variables: names.map((name) => ({ ...pressure, name })) });
  const bounds = ['position=9', ...names.map((name, i) => `${name}=0.${i + 1}`)].map((text) => `--bound=${text}`);
  const files = ['-o', 'named.ply', '--report', 'names.json', '--map', 'names-map.vtp'];
  expect(await folder.run('reduce', 'names.vtp', ...files, ...bounds)).toMatchObject({ status: 0, stderr: '' });
  const report = JSON.parse(folder.text('names.json'));
  expect(report.variables.map(({ name, bound }: VariableOfReport) => [name, bound])).toEqual([
    ['position', 9],
    ...names.map((name, i) => [name, Number(`0.${i + 1}`)]),
  ]);
  expect(Object.keys(report.options.bounds)).toEqual(['position', ...names]);
  expect((await folder.read('named.ply')).mesh.variables.map(({ name }) => name)).toEqual(names);
  const { mesh } = await folder.read('names-map.vtp');
  expect(mesh.variables.map(({ name }) => name)).toContain('__proto___error');
  expect(await folder.run('verify', 'names.vtp', 'named.ply', ...bounds)).toMatchObject({ status: 0, stderr: '' });
});

test('variables from a CSV file are reduced like those of the surface', async () => {
  const vertices = original.position.length / 3;
  const heat = Array.from({ length: vertices }, (_, vertex) => (original.position[3 * vertex] > 0.5 ? 1 : 0));
  folder.write('heat.csv', ['heat', ...heat].join('\n'));
  const { report } = await reduce('--variables', 'heat.csv', '-b', 'heat=0.1', '-b', 'position=20%');
  expect(report.variables.at(-1)).toMatchObject({ name: 'heat', extent: 1, bound: 0.1 });
  const { mesh } = await folder.read('out.vtp');
  expect(mesh.variables.at(-1)?.name).toBe('heat');
  const without = await reduce('-b', 'position=20%');
  expect(without.report.triangles.after).toBeLessThan(report.triangles.after);
  expect(await folder.run('verify', 'engine.vtp', 'out.vtp', '-b', 'heat=0.1')).toMatchObject({ status: 2 });
});

/** Two plates of which the right one begins, with texture coordinates of its own, where the left one ends. */
function plateWithSeam(): { whole: Mesh; sides: Mesh[] } {
  const { position, triangles } = engine();
  const vertices = position.length / 3;
  const uv = (from: number) =>
    Float32Array.from({ length: 2 * vertices }, (_, i) => (i % 2 === 0 ? from : 0) + position[3 * (i >> 1) + (i % 2)]);
  const mirrored = position.map((value, i) => (i % 3 === 0 ? 2 - value : value));
  const side = (places: Mesh['position'], corners: Uint32Array, from: number): Mesh => ({
    position: Float32Array.from(places),
    triangles: corners,
    variables: [{ name: 'uv', components: 2, values: uv(from) }],
  });
  const [left, right] = [side(position, triangles, 0), side(mirrored, triangles.toReversed(), 5)];
  const values = Float32Array.from([left, right].flatMap(({ variables }) => [...variables[0].values]));
  const whole = {
    position: Float32Array.from([...left.position, ...right.position]),
    triangles: Uint32Array.from([...left.triangles, ...right.triangles.map((vertex) => vertex + vertices)]),
    variables: [{ name: 'uv', components: 2, values }],
  };
  return { whole, sides: [left, right] };
}

/** The triangles of a plate with a seam whose texture coordinates say that they are on this side of it. */
function sideOf({ position, triangles, variables }: Mesh, right: boolean): Mesh {
  const { values } = variables[0];
  const corners = triangles.filter((_, i) => values[2 * triangles[i - (i % 3)]] >= 5 === right);
  return { position, triangles: corners, variables };
}

/** The places of its vertices at x = 1, each edge there as the two that it joins. */
function seamOf({ position, triangles }: Mesh): string[] {
  const place = (corner: number) => [...position.slice(3 * corner, 3 * corner + 3)];
  const next = (i: number) => (i % 3 === 2 ? i - 2 : i + 1);
  const edges = [...triangles].map((corner, i) => [place(corner), place(triangles[next(i)])]);
  return edges
    .filter((ends) => ends.every(([x]) => x === 1))
    .map((ends) => ends.map(String).toSorted().join(' to '))
    .toSorted();
}

test.each(['glb', 'obj', 'vtp'])(
  'a seam of a .%s file gets shorter on both sides together, does not crack, and its bounds hold on either side',
  async (format) => {
    const { whole, sides } = plateWithSeam();
    await folder.save(`seam.${format}`, whole);
    const bounds = ['-b', 'position=0.05', '-b', 'uv=0.1'];
    const files = [`seam.${format}`, '-o', `less.${format}`, '--report', 'seam.json'];
    const outcome = await folder.run('reduce', ...files, ...bounds);
    expect(JSON.parse(folder.text('seam.json')).seams).toEqual({ points: 34, touching: 0 });
    expect(outcome.stderr).toContain('34 points on seams, where several lie in one place, will be reduced together.');
    expect(outcome.status).toBe(0);
    const { mesh } = await folder.read(`less.${format}`);
    const reduced = [sideOf(mesh, false), sideOf(mesh, true)];
    const [left, right] = reduced.map(seamOf);
    expect(left).toEqual(right);
    expect(left.length).toBeLessThan(seamOf(sides[0]).length / 2);
    for (const [i, side] of sides.entries()) {
      await folder.save('side.vtp', side);
      await folder.save('less-side.vtp', reduced[i]);
      const judged = await folder.run('verify', 'side.vtp', 'less-side.vtp', ...bounds);
      expect(judged.status).toBe(0);
    }
  },
);

test('what is written for people puts neither a bound nor an error below what it is, nor an error above its bound', () => {
  const reached = { name: 'p', components: 1, extent: 81246.7, magnitude: 1e5, constant: false, refused: 0 };
  const report = {
    triangles: { before: 9, after: 3 },
    variables: [{ ...reached, bound: 2437.401, error: 2437.4, ratio: 0.9999996 }],
    flippedNormals: { before: 0, after: 0 },
    cells: 40,
    foldedCells: 0,
    regions: [],
    seconds: 1,
  } as unknown as Report;
  const text = reportText(report, { bounds: { p: { relative: 0.03 } } });
  expect(text).toMatch(/p +2438 +3 % +2438 +1$/);
});

test('the summary says where the bounds are not those in the table, and powers of ten where digits would mean nothing', () => {
  const of = (name: string, bound: number, error: number) => ({ name, constant: false, bound, error, ratio: 0.5 });
  const report = {
    triangles: { before: 9, after: 3 },
    variables: [of('position', 0.4, 0.9), of('p', 1.4153e18, 2e6)],
    flippedNormals: { before: 0, after: 0 },
    regions: [],
    seconds: 1,
  } as unknown as Report;
  const bounds = { '*': { relative: 0.03 } };
  const plain = reportText(report, { bounds });
  expect(plain).toMatch(/position +0\.4 +3 % +0\.9 +0\.5$/m);
  expect(plain).toMatch(/p +1\.416e\+18 +3 % +2000000 +0\.5$/m);
  expect(plain).not.toContain('multiplied');
  const special = reportText({ ...report, featureSize: 0.8 }, { bounds, boundMultiplier: 'near' });
  expect(special).toMatch(/position +0\.4 +limited +0\.9 +0\.5$/m);
  expect(special).toMatch(/p +1\.416e\+18 +3 % /m);
  expect(special).toContain('bounds are multiplied by “near”');
});

test('the summary tells of triangles that turn away and of folds of the map where there are any', () => {
  const counts = { triangles: { before: 9, after: 3 }, variables: [], regions: [], seconds: 1, cells: 4000 };
  const text = (flippedNormals: Report['flippedNormals'], foldedCells: number) =>
    reportText({ ...counts, flippedNormals, foldedCells } as unknown as Report, { bounds: {} });
  expect(text({ before: 0, after: 0 }, 0)).not.toMatch(/turned|folded/);
  expect(text({ before: 2, after: 0 }, 0)).toMatch(/turned more than .*: 2 -> 0 triangles$/m);
  expect(text({ before: 0, after: 1 }, 0)).toMatch(/turned more than .*: 0 -> 1 triangle$/m);
  expect(text({ before: 0, after: 0 }, 7)).toMatch(/^folded by the map: 7 of 4 000 cells$/m);
});

test('the report counts what is not manifold, what was turned and parts without two sides, and folds where there is a map', async () => {
  const sheets = [0, 1, 2].flatMap((sheet) => [0, 1, 5 + sheet]); // all on the edge from 0 to 1
  const places = Array.from({ length: 10 }, (_, i) => 2 * Math.PI * (i / 10));
  const band = places.flatMap((angle) =>
    [-0.3, 0.3].flatMap((across) => {
      const radius = 1 + across * Math.cos(angle / 2);
      return [5 + radius * Math.cos(angle), radius * Math.sin(angle), across * Math.sin(angle / 2)];
    }),
  );
  const first = 8; // of the band, whose end is joined to its beginning the other way round
  const at = (column: number, side: number) => first + 2 * (column % 10) + (column < 10 ? side : 1 - side);
  const strip = places.flatMap((_, i) => [
    ...[at(i, 0), at(i + 1, 0), at(i, 1)],
    ...[at(i, 1), at(i + 1, 0), at(i + 1, 1)],
  ]);
  const edge = [0, 0, 0, 0, 0, 1, 0, 2, 0, 1, 2, 0, 0, 2, 1, 1, 0, 0.5, -1, 1, 0.5, -1, -1, 0.5];
  const triangles = Uint32Array.from([...sheets, 2, 3, 4, ...strip]);
  await folder.save('odd.ply', { position: Float64Array.from([...edge, ...band]), triangles, variables: [] });
  const reportOf = async (...args: string[]) => {
    const files = ['odd.ply', '-o', 'out.ply', '--report', 'odd.json'];
    expect(await folder.run('reduce', ...files, '-b', 'position=1%', ...args)).toMatchObject({ status: 0 });
    return JSON.parse(folder.text('odd.json'));
  };
  const tracked = await reportOf();
  expect(tracked.defects.unorientableComponents).toBe(1);
  expect(tracked.nonManifoldVertices).toBeGreaterThanOrEqual(2);
  expect(tracked.map.cells).toBeGreaterThan(0);
  expect(await reportOf('--errors', 'propagated')).toMatchObject({ defects: tracked.defects, map: null });
});

test('points and boxes that are locked stay, and bounds are finer where a variable is small', async () => {
  const near = Float32Array.from({ length: 17 * 17 }, (_, vertex) => (vertex % 17 < 8 ? 0.05 : 1));
  const variables = [...original.variables, { name: 'near', components: 1, values: near }];
  await folder.save('focus.vtp', { ...original, variables });
  const left = async (...args: string[]) => {
    const outcome = await folder.run('reduce', 'focus.vtp', '-o', 'out.vtp', ...all, '-b', 'near=free', ...args);
    expect(outcome.stderr).toBe('');
    expect(outcome.status).toBe(0);
    return (await folder.read('out.vtp')).mesh;
  };
  const count = ({ triangles }: Mesh) => triangles.length / 3;
  const plain = await left();
  expect(count(await left('--bound-multiplier', 'near'))).toBeGreaterThan(count(plain));
  expect(count(await left('--lock-box=-1,-1,-1,0.3,0.3,1'))).toBeGreaterThan(count(plain));

  const locked = vertices(await left('--lock-points', '40-42,77'));
  const places = [40, 41, 42, 77].map((point) =>
    Array.from(original.position.slice(3 * point, 3 * point + 3)).join(' '),
  );
  for (const place of places) expect([...locked].filter((row) => row.startsWith(`${place} `))).toHaveLength(1);
});

test('a box that meets no triangle is said to lock nothing; one that touches the surface does meet it', async () => {
  const boxes = ['--lock-box=-9,-9,-9,-8,-8,-8', '--lock-box=-1,-1,-1,0,0,1'];
  const report = ['--report', 'boxes.json'];
  const { status, stderr } = await folder.run('reduce', 'engine.vtp', '-o', 'out.vtp', ...all, ...boxes, ...report);
  expect({ status, stderr }).toEqual({
    status: 0,
    stderr: 'engine.vtp: --lock-box=-9,-9,-9,-8,-8,-8 meets no triangle: nothing stays because of it.\n',
  });
  expect(JSON.parse(folder.text('boxes.json')).unusedLockedBoxes).toEqual([0]);
});

test('a multiplier that the file has not is a fault', async () => {
  const outcome = await folder.run('reduce', 'engine.vtp', '-o', 'out.vtp', ...all, '--bound-multiplier', 'nearness');
  expect(outcome.status).not.toBe(0);
  expect(outcome.stderr).toContain('there is no variable “nearness” to multiply the bounds');
});

test('parts smaller than the bound go when asked for, and triangles that face the wrong side are turned; both are said', async () => {
  const { position, triangles, variables } = original;
  const points = position.length / 3;
  const crumb = Array.from({ length: 9 }, (_, i) => 2 + 0.0001 * (i % 4));
  const more = ({ components, values, ...rest }: Mesh['variables'][number]) => {
    const longer = values.constructor as Float32ArrayConstructor;
    return { ...rest, components, values: longer.from([...values, ...values.slice(0, 3 * components)]) };
  };
  const turned = triangles.slice();
  [turned[31], turned[32]] = [turned[32], turned[31]];
  await folder.save('crumb.vtp', {
    position: Float32Array.from([...position, ...crumb]),
    triangles: Uint32Array.from([...turned, points, points + 1, points + 2]),
    variables: variables.map(more),
  });
  const files = ['crumb.vtp', '-o', 'out.vtp', '--report', 'crumb.json'];
  const run = (...args: string[]) => folder.run('reduce', ...files, ...all, ...args);
  const kept = await run();
  expect(JSON.parse(folder.text('crumb.json')).defects).toMatchObject({
    flippedTriangles: 1,
    unorientableComponents: 0,
  });
  expect(kept.stderr).toContain('1 triangle faces the other side than most around them: turned round.');
  expect(kept.stderr).not.toContain('left out');
  expect((await run('--drop-small-components')).stderr).toContain(
    '1 part smaller than the bound of position, 1 triangle: left out',
  );
});

test('cell data part the surface into regions, which keep their borders and their numbers', async () => {
  const regions = Int32Array.from({ length: original.triangles.length / 3 }, (_, triangle) =>
    triangle % 32 < 16 ? 7 : -3,
  );
  await folder.save('regions.vtp', { ...original, regions });
  const run = (...args: string[]) => folder.run('reduce', 'regions.vtp', '-o', 'out.vtp', '-b', '*=8%', ...args);
  expect((await run()).stderr).toContain(
    'Not carried unless it parts the surface into regions (--region): cell data “regions”.',
  );
  expect(await run('--region', 'regions')).toMatchObject({ status: 0, stderr: '' });
  const labels = (await folder.read('out.vtp')).regions?.get('regions');
  const { mesh } = await folder.read('out.vtp');
  expect(labels).toHaveLength(mesh.triangles.length / 3);
  // The border is the line x = 1/2: each side lies on its own.
  labels?.forEach((label, triangle) => {
    for (const corner of mesh.triangles.slice(3 * triangle, 3 * triangle + 3)) {
      if (label === 7) expect(mesh.position[3 * corner]).toBeLessThanOrEqual(0.5);
      else expect(mesh.position[3 * corner]).toBeGreaterThanOrEqual(0.5);
    }
  });
  expect(labels?.length).toBeLessThan(regions.length / 2);
  // In other formats, and with the map, under the name that they came with.
  for (const name of ['out.vtk', 'out.ply']) {
    await folder.run('reduce', 'regions.vtp', '-o', name, '-b', '*=8%', '--region', 'regions');
    expect((await folder.read(name)).regions).toEqual(new Map([['regions', labels]]));
    const args = ['-b', '*=9%', '--region', 'regions', '--map', 'map.vtp'];
    expect(await folder.run('reduce', name, '-o', 'again.vtp', ...args)).toMatchObject({ status: 0, stderr: '' });
    expect((await folder.read('map.vtp')).regions).toEqual(new Map([['regions', labels]]));
  }
  const missing = await run('--region', 'part');
  expect(missing.stderr).toContain(
    'there is no cell data “part” to part it into regions; those of whole numbers are “regions”.',
  );
});

test('materials of an OBJ file part the surface into regions, are locked and written by their names', async () => {
  const { position, triangles } = original;
  const row = (values: ArrayLike<number>, at: number) => [0, 1, 2].map((i) => values[3 * at + i]);
  const lines = Array.from({ length: position.length / 3 }, (_, point) => `v ${row(position, point).join(' ')}`);
  for (let triangle = 0; triangle < triangles.length / 3; triangle++) {
    lines.push(`usemtl ${triangle % 32 < 16 ? 'left' : 'right side'}`);
    lines.push(
      `f ${row(triangles, triangle)
        .map((corner) => corner + 1)
        .join(' ')}`,
    );
  }
  folder.write('materials.obj', [...lines, ''].join('\n'));
  const run = (output: string, ...args: string[]) =>
    folder.run('reduce', 'materials.obj', '-o', output, '-b', '*=8%', '--region', 'material', ...args);
  const report = ['--report', 'report.json'];
  const { status, stdout, stderr } = await run('out.obj', '--lock-region', 'right side', ...report);
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  expect(stdout).toMatch(/^ {2}2 right side +256 +256 /m);
  const { regions, options } = JSON.parse(folder.text('report.json'));
  expect(regions).toMatchObject([
    { label: 1, name: 'left' },
    { label: 2, name: 'right side', triangles: { before: 256, after: 256 } },
  ]);
  expect(regions[0].triangles.after).toBeLessThan(128);
  expect(options.lockRegions).toEqual(['right side']);
  const { mesh, regions: labels, regionNames } = await folder.read('out.obj');
  expect(labels?.get('material')?.length).toBe(mesh.triangles.length / 3);
  const names = regionNames?.get('material');
  labels?.get('material')?.forEach((label, triangle) => {
    const across = row(mesh.triangles, triangle).map((corner) => mesh.position[3 * corner]);
    if (names?.get(label) === 'left') expect(Math.max(...across)).toBeLessThanOrEqual(0.5);
    else expect(Math.min(...across)).toBeGreaterThanOrEqual(0.5);
  });
  expect((await run('out.vtp', '--lock-region', '2')).stderr).toContain('out.vtp: VTP has no place for the names of');
  const missing = await run('out.obj', '--lock-region', 'middle');
  expect(missing.status).toBe(2);
  expect(missing.stderr).toContain('there is no region “middle” in “material”; they are “left”, “right side”.');
});

test('the report and the summary tell how much of each region is left', async () => {
  const half = original.triangles.length / 6;
  const regions = Int32Array.from({ length: 2 * half + 1 }, (_, triangle) =>
    triangle === 2 * half ? 12 : triangle % 32 < 16 ? 7 : -3,
  );
  const position = Float32Array.from([...original.position, 3, 0, 0, 3.001, 0, 0, 3, 0.001, 0]);
  const points = original.position.length / 3;
  const triangles = Uint32Array.from([...original.triangles, points, points + 1, points + 2]);
  await folder.save('parted.vtp', { position, triangles, variables: [], regions });
  const args = [
    '-b',
    'position=5%',
    '--region',
    'regions',
    '--drop-small-components',
    '--lock-box',
    '0,0,-1,0.1,0.1,1',
  ];
  const more = ['--lock-points', '3,9-11', '--lock-region=-3', '--report', 'report.json'];
  const { stdout, status } = await folder.run('reduce', 'parted.vtp', '-o', 'out.vtp', ...args, ...more);
  expect(status).toBe(0);
  const report = JSON.parse(folder.text('report.json'));
  expect(report.regions.map(({ label }: { label: number }) => label)).toEqual([-3, 7, 12]);
  const [locked, other, crumb] = report.regions;
  expect(locked).toEqual({
    label: -3,
    triangles: { before: half, after: half },
    area: { before: locked.area.before, after: locked.area.before },
  });
  expect(locked.area.before).toBeGreaterThan(0.5); // half of a plate with bumps
  expect(other.triangles.after).toBeLessThan(half / 2);
  expect(other.area.after).toBeGreaterThan(0.49);
  expect(other.area.after).toBeLessThan(other.area.before);
  expect(crumb).toEqual({
    label: 12,
    triangles: { before: 1, after: 0 },
    area: { before: expect.closeTo(5e-7, 9), after: 0 },
  });
  expect(report).toMatchObject({ vanishedRegions: [12], dropped: { components: 1, triangles: 1 } });
  expect(report.options).toMatchObject({
    dropSmallComponents: true,
    boundMultiplier: null,
    region: 'regions',
    lockPoints: ['3,9-11'],
    lockRegions: [-3],
    lockBoxes: [{ lowest: [0, 0, -1], highest: [0.1, 0.1, 1] }],
  });
  expect(stdout).toMatch(/^ {2}-3 +256 +256 +0\.\d+ +0\.\d+ +0 %$/m);
  expect(stdout).toMatch(/^ {2}12 +1 +0 +\S+ +0 +-100 %$/m);
  expect(stdout).toContain('1 region vanished: 12.');
});

test('cell data of a legacy VTK file part the surface into regions, too', async () => {
  const { position, triangles } = original;
  const cells = Array.from({ length: triangles.length / 3 }, (_, i) => triangles.slice(3 * i, 3 * i + 3).join(' '));
  folder.write(
    'regions.vtk',
    [
      ...['# vtk DataFile Version 3.0', 'plate', 'ASCII', 'DATASET POLYDATA'],
      ...[`POINTS ${position.length / 3} double`, position.join(' ')],
      ...['LINES 1 3', '2 0 1', `POLYGONS ${cells.length} ${4 * cells.length}`, ...cells.map((cell) => `3 ${cell}`)],
      ...[`CELL_DATA ${cells.length + 1}`, 'SCALARS part int', 'LOOKUP_TABLE default'],
      ...[99, ...cells.map((_, cell) => (cell % 32 < 16 ? 7 : -3))],
    ].join('\n'),
  );
  const run = (...args: string[]) => folder.run('reduce', 'regions.vtk', '-o', 'out.vtp', '-b', '*=8%', ...args);
  expect((await run()).stderr).toContain('(--region): cell data “part”.');
  expect(await run('--region', 'part')).toMatchObject({ status: 0 });
  const { mesh, regions } = await folder.read('out.vtp');
  const labels = [...(regions?.get('part') ?? [])];
  await run('--region', 'part', '--map', 'map.vtk');
  expect([...((await folder.read('map.vtk')).regions?.keys() ?? [])]).toEqual(['part']);
  expect(new Set(labels)).toEqual(new Set([7, -3]));
  expect(labels.length).toBeLessThan(cells.length / 2);
  for (const [triangle, label] of labels.entries()) {
    const across = [...mesh.triangles.slice(3 * triangle, 3 * triangle + 3)].map((corner) => mesh.position[3 * corner]);
    if (label === 7) expect(Math.max(...across)).toBeLessThanOrEqual(0.5);
    else expect(Math.min(...across)).toBeGreaterThanOrEqual(0.5);
  }
});

test('labels may be stored as doubles; the first value that is no label is named with its cell', async () => {
  const file = (last: number) =>
    [
      ...['# vtk DataFile Version 3.0', 'square', 'ASCII', 'DATASET POLYDATA', 'POINTS 4 double'],
      ...['0 0 0 1 0 0 1 1 0 0 1 0', 'POLYGONS 2 8', '3 0 1 2', '3 0 2 3'],
      ...['CELL_DATA 2', 'SCALARS part double', 'LOOKUP_TABLE default', `1 ${last}`],
    ].join('\n');
  const run = () => folder.run('reduce', 'doubles.vtk', '-o', 'out.vtp', '-b', '*=1%', '--region', 'part');
  folder.write('doubles.vtk', file(-2));
  expect(await run()).toMatchObject({ status: 0 });
  expect([...((await folder.read('out.vtp')).regions?.get('part') ?? [])].toSorted()).toEqual([-2, 1]);
  folder.write('doubles.vtk', file(2.5));
  const { status, stderr } = await run();
  expect(status).toBe(2);
  expect(stderr).toContain(
    'the cell data “part” cannot part the surface into regions: cell 1, counted from 0, has 2.5',
  );
});

test('no part pierces another where that is refused', async () => {
  const plate = [0, 0.5, 1].flatMap((y) => [0, 0.5, 1].flatMap((x) => [x, y, x === 0.5 && y === 0.5 ? 0.1 : 0]));
  const spike = [0.5, 0.5, 0.05, 0.48, 0.48, -0.1, 0.52, 0.48, -0.1, 0.5, 0.52, -0.1];
  const cells = [0, 1, 3, 4].flatMap((at) => [at, at + 1, at + 4, at, at + 4, at + 3]);
  const tetrahedron = [9, 11, 10, 9, 12, 11, 9, 10, 12, 10, 11, 12];
  await folder.save('spike.vtp', {
    position: Float64Array.from([...plate, ...spike]),
    triangles: Uint32Array.from([...cells, ...tetrahedron]),
    variables: [],
  });
  const heights = async (...args: string[]) => {
    const run = await folder.run('reduce', 'spike.vtp', '-o', 'out.vtp', '-b', 'position=0.2', ...args);
    expect(run.status).toBe(0);
    return (await folder.read('out.vtp')).mesh.position.filter((_, i) => i % 3 === 2);
  };
  expect(await heights()).not.toContain(0.1);
  expect(await heights('--refuse-piercing')).toContain(0.1);
  expect(await heights('--limit-to-feature-size')).toContain(0.1);
});

test('says how many triangles lie on one another, and reduces both sides of a sheet together', async () => {
  const at = (i: number) => [Math.floor(i / 3), i % 3, 0];
  const fronts = [0, 1, 3, 4].flatMap((i) => [i, i + 3, i + 4, i, i + 4, i + 1]);
  const backs = fronts.map((_, i) => fronts[i - (i % 3) + 2 - (i % 3)] as number);
  const position = Float64Array.from(Array.from({ length: 9 }, (_, i) => at(i)).flat());
  const triangles = Uint32Array.from([...fronts, ...backs, ...fronts.slice(0, 3)]);
  await folder.save('sheet.ply', { position, triangles, variables: [] });
  const run = await folder.run('reduce', 'sheet.ply', '-o', 'out.ply', '--report', 'sheet.json', '-b', 'position=1%');
  expect(run).toMatchObject({ status: 0 });
  const report = JSON.parse(folder.text('sheet.json'));
  expect(report.triangles).toEqual({ before: 17, after: 4 });
  expect(report.defects).toMatchObject({ copiedTriangles: 1, twoSidedTriangles: 8 });
  expect(run.stderr).toContain('8 pairs of triangles on the same three points, facing opposite ways');
  expect(run.stderr).toContain('1 triangle is a copy of another one');
  const inspected = await folder.run('inspect', 'sheet.ply');
  expect(inspected.stdout).toMatch(/pairs of triangles that are two sides +8\n +copies of other triangles +1\n/);
  const found = JSON.parse((await folder.run('inspect', 'sheet.ply', '--json')).stdout);
  expect(found.defects).toEqual({ copiedTriangles: 1, twoSidedTriangles: 8 });
});

test('says why little went where it is not the bounds', async () => {
  const files = ['engine.vtp', '-o', 'out.vtp', '--report', 'locked.json'];
  const run = await folder.run('reduce', ...files, ...all, '--lock-box=-1e9,-1e9,-1e9,1e9,1e9,1e9');
  expect(run.stdout).toContain('Why so little went: 100 % of the vertices left are locked.');
  expect(JSON.parse(folder.text('locked.json')).refused.whyLittleWent).toEqual({ reason: 'locked', share: 1 });
  const bounded = await folder.run('reduce', ...files, '-b', 'position=0.0001%', '-b', '*=0.0001%');
  expect(bounded.stdout).not.toContain('Why so little');
});

test('a variable that is no number somewhere: with a bound both ways out are named, without one it goes through', async () => {
  const [pressure, ...others] = original.variables;
  const holed = { ...pressure, values: pressure.values.with(3, Number.NaN) };
  await folder.save('holed.vtp', { ...original, variables: [holed, ...others] });
  const run = (...args: string[]) =>
    folder.run('reduce', 'holed.vtp', '-o', 'out.vtp', '--report', 'holed.json', ...args);
  const refused = await run(...all);
  expect(refused.status).not.toBe(0);
  expect(refused.stderr).toMatch(
    /“pressure” is not a number at vertex 3.*--bound "pressure=free".*--exclude "pressure"/s,
  );
  const free = await run(...all, '-b', 'pressure=free');
  expect(free.status).toBe(0);
  expect(free.stdout).toMatch(/pressure.*not known/);
  const { variables } = JSON.parse(folder.text('holed.json'));
  expect(variables[1]).toMatchObject({
    name: 'pressure',
    error: null,
    bound: null,
    nonFinite: { vertices: 1, first: 3 },
  });
  expect((await run(...all, '--exclude', 'pressure')).status).toBe(0);
});

test('points that no triangle uses count for nothing, and are counted', async () => {
  const far = Float64Array.from([...original.position, 0, 0, 1e9, Number.NaN, 0, 0]);
  const longer = original.variables.map((variable) => {
    const more = new Float64Array(variable.values.length + 2 * variable.components).fill(1e30);
    more.set(variable.values);
    return { ...variable, values: more };
  });
  await folder.save('stray.vtp', { ...original, position: far, variables: longer });
  const files = ['-o', 'stray-out.vtp', '--report', 'stray.json'];
  const strayed = await folder.run('reduce', 'stray.vtp', ...files, ...all);
  expect(strayed.stderr).toContain('2 vertices belong to no triangle: left out of the result.');
  const { report } = await reduce(...all);
  const found = JSON.parse(folder.text('stray.json'));
  expect(found.triangles).toEqual(report.triangles);
  expect(boundsIn(found)).toEqual(boundsIn(report));
  const verified = await folder.run('verify', 'stray.vtp', 'stray-out.vtp', ...all);
  expect(verified).toMatchObject({ status: 0 });
  expect(verified.stderr).toContain('2 vertices belong to no triangle');
  expect((await folder.run('inspect', 'stray.vtp')).stdout).toMatch(/that no triangle uses +2\n/);
});
