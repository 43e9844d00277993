import { beforeAll, expect, test } from 'vitest';
import { inspect } from '../../wasm/index.ts';
import { Folder } from './command.ts';
import { engine } from './engine.ts';

const folder = new Folder();
const mesh = engine();

beforeAll(() => folder.save('engine.vtp', mesh));

async function json(...args: string[]) {
  const outcome = await folder.run('inspect', '--json', ...args);
  expect(outcome).toMatchObject({ status: 0, stderr: '' });
  return JSON.parse(outcome.stdout);
}

test('--json tells counts, topology and variables', async () => {
  const found = await json('engine.vtp');
  expect(found).toMatchObject({
    file: 'engine.vtp',
    format: 'vtp',
    triangles: 512,
    vertices: 289,
    components: 1,
    boundaryLoops: 1,
    nonManifoldEdges: 0,
    discordantEdges: 0,
    nonManifoldVertices: 0,
    notes: [],
  });
  expect(
    found.variables.map(({ name, components, precision }: Record<string, unknown>) => [name, components, precision]),
  ).toEqual([
    ['position', 3, 'single'],
    ['pressure', 1, 'double'],
    ['velocity', 3, 'single'],
    ['temperature', 1, 'single'],
  ]);
  const [position, pressure] = found.variables;
  expect(position.range.slice(0, 2)).toEqual([
    [0, 1],
    [0, 1],
  ]);
  const values = [...mesh.variables[0].values];
  expect(pressure.range).toEqual([[Math.min(...values), Math.max(...values)]]);
  expect(pressure).toMatchObject({ unit: null, componentNames: null, constant: false, nan: 0, infinite: 0 });
});

test('extents are those that relative bounds are fractions of', async () => {
  const vertices = mesh.position.length / 3;
  const noise = Float64Array.from({ length: vertices }, (_, i) => 7 + 1e-9 * (i % 2));
  const variables = [...mesh.variables, { name: 'noise', components: 1, values: noise }];
  await folder.save('noise.vtp', { ...mesh, variables });
  const { variables: found } = await json('noise.vtp');
  const { variables: expected } = await inspect({ ...mesh, variables });
  for (const [i, { name, extent, magnitude, constant }] of expected.entries()) {
    expect(found[i]).toMatchObject({ name, magnitude, constant });
    expect(Math.abs(found[i].extent - extent)).toBeLessThanOrEqual(1e-15 * magnitude);
  }
  expect(found.at(-1).constant).toBe(true);
});

test('NaN and infinity are counted, and the range is that of the others', async () => {
  const [pressure] = mesh.variables;
  const values = pressure.values.with(0, Number.NaN).with(1, Number.NaN).with(2, Number.NEGATIVE_INFINITY);
  const nothing = { ...pressure, name: 'nothing', values: values.map(() => Number.NaN) };
  await folder.save('nan.vtp', { ...mesh, variables: [{ ...pressure, values }, nothing] });
  const { variables } = await json('nan.vtp');
  const finite = [...values].filter(Number.isFinite);
  expect(variables[1]).toMatchObject({ nan: 2, infinite: 1, range: [[Math.min(...finite), Math.max(...finite)]] });
  expect(variables[2]).toMatchObject({ nan: 289, range: [null] });
});

test('shows the same to people, a row for each component', async () => {
  const { status, stdout, stderr } = await folder.run('inspect', 'engine.vtp');
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  expect(stdout).toMatch(/^engine\.vtp \(VTP\)$/m);
  expect(stdout).toMatch(/^ {2}triangles +512$/m);
  expect(stdout).toMatch(/^ {2}boundary loops +1$/m);
  expect(stdout).toMatch(/^ {2}position +3 /m);
  expect(stdout).toMatch(/^ {4}x +0 +1$/m);
});

test('numbers far from the origin have the digits that tell them apart', async () => {
  const position = Float64Array.from(mesh.position, (value, i) => value + [500_000, 6_000_000, 12][i % 3]);
  const [pressure, ...others] = mesh.variables;
  const values = Float64Array.from(pressure.values, (_, i) => 101325 + 0.001 * (i % 7));
  await folder.save('far.vtp', { ...mesh, position, variables: [{ ...pressure, values }, ...others] });
  const { stdout } = await folder.run('inspect', 'far.vtp');
  expect(stdout).toMatch(/^ {4}x +500000 +500001$/m);
  expect(stdout).toMatch(/^ {4}y +6000000 +6000001$/m);
  expect(stdout).toMatch(/^ {2}pressure +1 +101325 +101325\.006 /m);
  expect(stdout).toMatch(/^ {2}temperature +1 +[\d.]{3,6} +[\d.]{3,6} /m);
});

test('cell data are said to be what --region takes, or why not', async () => {
  const cells = (numbers: string, name: string) => `SCALARS ${name} double\nLOOKUP_TABLE default\n${numbers}\n`;
  const geometry = 'DATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\nPOLYGONS 2 8\n3 0 1 2\n3 1 3 2\n';
  folder.write(
    'parts.vtk',
    `# vtk DataFile Version 3.0\nt\nASCII\n${geometry}CELL_DATA 2\n${cells('7 9', 'part')}${cells('0.5 1', 'load')}`,
  );
  const { stdout, stderr } = await folder.run('inspect', 'parts.vtk');
  expect(stdout).toContain('Cell data “part”, 2 labels: --region takes it');
  expect(stdout).toContain('Cell data “load” cannot part the surface into regions: cell 0, counted from 0, has 0.5');
  expect(stderr).not.toContain('“part”');
  expect((await json('parts.vtk')).cellData).toEqual([
    { name: 'part', labels: 2, unfit: null },
    { name: 'load', labels: null, unfit: expect.stringContaining('0.5') },
  ]);
  const args = ['-o', 'out.vtk', '-b', 'position=1%', '--region', 'part'];
  expect(await folder.run('reduce', 'parts.vtk', ...args)).toMatchObject({ status: 0 });
});

test('what the reader did is said, on standard error unless it is part of the JSON', async () => {
  folder.write(
    'wrong.ply',
    '# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n',
  );
  const { stderr } = await folder.run('inspect', 'wrong.ply');
  expect(stderr).toContain('wrong.ply: The name ends in .ply, but the content is legacy VTK');
  expect((await json('wrong.ply')).notes).toEqual([expect.stringContaining('The name ends in .ply')]);
  expect(await folder.run('inspect', '--quiet', 'wrong.ply')).toMatchObject({ status: 0, stderr: '' });
});

test('names from a file cannot command the terminal', async () => {
  const geometry = 'DATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\n';
  const array = (name: string, values: string) => `SCALARS ${name} double\nLOOKUP_TABLE default\n${values}\n`;
  const text = geometry + array('%1B[31mred', '1 1 1') + array('%1B[2J', '1 nan 2');
  folder.write('escape.vtk', `# vtk DataFile Version 3.0\nt\nASCII\n${text}`);
  for (const args of [['inspect'], ['reduce', '-o', 'out.vtp', '-b', '*=1%'], ['verify', 'escape.vtk', '-b', '*=1%']]) {
    const { stdout, stderr } = await folder.run(args[0], 'escape.vtk', ...args.slice(1));
    expect(stdout + stderr).toContain('\u{FFFD}[');
    expect(stdout + stderr).not.toContain('\u{1B}');
  }
});
