import { describe, expect, it } from 'vitest';
import { readSurface } from '../../web/formats/read.ts';
import { lossesOf, writeSurface } from '../../web/formats/write.ts';
import { expectFault } from './faults.ts';
import { awkwardDoubles, bits, bytesOf, fingerprint, mixedVariables, smallMesh } from './sample-mesh.ts';

const points = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n';
const read = (text: string) => readSurface('mesh.obj', bytesOf(text));

describe('OBJ', () => {
  it('gives points, triangles and what it has a place for back, in double precision', async () => {
    const ramp = (length: number) => Float64Array.from({ length }, (_, i) => awkwardDoubles[i % 4] + (i % 5) / 7);
    const variables = [
      { name: 'color', components: 3, values: ramp(12) },
      { name: 'uv', components: 2, values: ramp(8) },
      { name: 'normal', components: 3, values: ramp(12) },
    ];
    const mesh = { ...smallMesh(variables), position: ramp(12) };
    const { mesh: back, summary } = await readSurface('mesh.obj', await writeSurface('obj', mesh));
    expect(fingerprint(back)).toEqual(fingerprint(mesh));
    expect(summary).toBe('');
    expect(await lossesOf('obj', mesh)).toEqual([]);
    const [losses] = await lossesOf('obj', smallMesh(mixedVariables()));
    expect(losses).toMatch(/^OBJ has no place for the variables “pressure”.*“color”/);
  });

  it('says that units and names of components have no place', async () => {
    const uv = { name: 'uv', components: 2, values: new Float32Array(8) };
    const labels = { units: { position: 'mm', p: 'Pa' }, componentNames: { uv: ['u', 'v'] } };
    expect(await lossesOf('obj', smallMesh([uv]), labels)).toEqual([
      'OBJ has no place for the units of “position”.',
      'OBJ has no place for the component names of “uv”.',
    ]);
    for (const format of ['ply', 'vtp', 'vtk', 'glb'] as const) {
      expect(await lossesOf(format, smallMesh([uv]), labels)).toEqual([]);
    }
  });

  it('reads polygons, indices from the end, lines that go on, comments', async () => {
    const { mesh, notes } = await read(`# by hand\n${points}f 1 2 3 4\nf -4 -3 \\\n -1\n`);
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3, 0, 1, 3]);
    expect(notes).toEqual(['1 face with more than three corners split into triangles.']);
  });

  it('counts lines alike whatever the system that wrote them', async () => {
    const text = `${points}${'f 1 2 3\n'.repeat(150_000)}f 1 2 x\n`;
    for (const lineBreak of ['\n', '\r\n', '\r']) {
      await expect(read(text.replaceAll('\n', lineBreak))).rejects.toMatchObject({ where: 'line 150005' });
    }
  });

  it('joins lines of numbers at a backslash, and no others', async () => {
    const path = 'C:\\meshes\\';
    for (const line of [`# ${path}`, `#${path}`, `g ${path}`, `o ${path}`, `mtllib ${path}`, `s ${path}`, '$ \\']) {
      const { mesh, summary } = await read(`${line}\nv 0 0 0\n${line}\nv 1 0 0\nv 1 1 0\n${line}\nf 1 2 3\n`);
      expect(Array.from(mesh.triangles), line).toEqual([0, 1, 2]);
      expect(summary, line).not.toContain('goes on');
    }
    const { mesh, regionNames } = await read(`${points}usemtl a\\\nf 1 2 3 # ${path}\nusemtl b\nf 1 3 4#\\\n`);
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3]);
    expect([...(regionNames?.get('material')?.values() ?? [])]).toEqual(['a\\', 'b']);
    const split = await read('v 0 \\\n 0 0\nv 1\\\n0 0\nv 1 1 \\ \n\t0 # end\nvt 0 \\\n0\nf 1/1 2/1 \\\r\n3/1\n');
    expect(Array.from(split.mesh.position)).toEqual([0, 0, 0, 1, 0, 0, 1, 1, 0]);
    expect(Array.from(split.mesh.variables[0].values)).toEqual([0, 0, 0, 0, 0, 0]);
    const dangling = await read(`${points}f 1 2 3 \\\nf 1 3 4 \\\n\nv 9 9 9\n`);
    expect(Array.from(dangling.mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3]);
  });

  it('reads tabs, exponents, and comments anywhere', async () => {
    const { mesh, notes } = await read('v\t0 0  0#a\nv 1E0 0 0 # b\nv +1. 10e-1 .0\n #c\n\nf\t1// 2//  3\n');
    expect(Array.from(mesh.position)).toEqual([0, 0, 0, 1, 0, 0, 1, 1, 0]);
    expect(notes).toEqual([]);
  });

  it('passes over lines that no OBJ file has, and names them with their number', async () => {
    const { mesh, notes } = await read(`$ by another\n${points}spam 1\nspam 2\n!x\nf 1 2 3\n`);
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2]);
    expect(notes).toEqual(['4 lines passed over that no OBJ file has, beginning with “$”, “spam”, “!x”.']);
  });

  it('leaves faces of fewer than three corners out, of every material', async () => {
    const faces = 'usemtl a\nf 1 2 3\nf 1 2\nusemtl b\nf\nf 7\nf 1 3 4\n';
    const { mesh, notes, regions } = await read(points + faces);
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3]);
    expect(notes).toContain('3 faces with fewer than three corners left out.');
    expect(Array.from(regions?.get('material') ?? [])).toEqual([1, 2]);
  });

  it.each([
    ['there is none', '', 'f 1/1/1 2/2/1 3/3/1', ['uv', 'normal'], 3],
    ['one is missing', 'vt 0 0\nvt 1 0\nvn 0 0 1\n', 'f 1/1/1 2/2/1 3/3/1', ['uv'], 1],
    ['one is before the first', 'vt 0 0\nvn 0 0 1\n', 'f 1/1/1 2/-2/1 3/1/1', ['uv'], 1],
    ['one is no index', 'vt 0 0\nvn 0 0 1\n', 'f 1/1/1 2/1/1 3/1/x', ['normal'], 1],
    ['one is not given', 'vt 0 0\nvn 0 0 1\n', 'f 1/1/1 2//1 3/1/1', ['uv'], 0],
    ['one is no numbers', 'vt a\nvt 1 1\nvn 0 0\nvn 0 0 1\n', 'f 1/1/1 2/2/2 3/2/2', ['uv', 'normal'], 1],
  ] as const)('leaves corners without what they name where %s', async (_, data, face, lost, corners) => {
    const { mesh, notes } = await read(`${points}${data}${face}\n`);
    expect(mesh.triangles).toHaveLength(3);
    for (const name of ['uv', 'normal']) {
      const note = notes.find((each) => each.includes(`Not carried: ${name}, since`));
      const isLost = (lost as readonly string[]).includes(name);
      expect(mesh.variables.some((variable) => variable.name === name)).toBe(!isLost);
      expect(note !== undefined).toBe(isLost);
      if (isLost && corners > 0) expect(note).toContain(`${corners} corner`);
    }
  });

  it('reads a line that goes on a hundred thousand times', async () => {
    const { mesh } = await read(`${points}f 1 \\\n${'\\\n'.repeat(100_000)}2 3\n`);
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2]);
  });

  it('keeps the order of the points, and colours as they are', async () => {
    const { mesh } = await read('v 0 0 0 0.5 0.25 1\nv 1 0 0 1 1 1\nv 1 1 0 0 0 0\nvt 0 0\nvt 1 1\nf 3/1 1/2 2/1\n');
    expect(mesh.position).toEqual(Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0));
    expect(mesh.variables.map(({ name, values }) => `${name} ${Array.from(values).join(' ')}`)).toEqual([
      'color 0.5 0.25 1 1 1 1 0 0 0',
      'uv 1 1 0 0 0 0',
    ]);
    expect(Array.from(mesh.triangles)).toEqual([2, 0, 1]);
  });

  it('leaves the points of texture seams apart, free to be reduced together', async () => {
    const { mesh, locked, notes } = await read(`${points}vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/1 3/2 4/2\n`);
    expect(mesh.position.length / 3).toBe(5);
    expect(locked).toBeUndefined();
    expect(mesh.position.subarray(6, 9)).toEqual(mesh.position.subarray(9, 12));
    expect(notes).toEqual([expect.stringMatching(/^2 points on seams/)]);
  });

  it('keeps normals that agree, and lets those go that draw creases', async () => {
    const smooth = await read(`${points}vn 0 0 1\nvn 0 0 1\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n`);
    expect(smooth.mesh.variables.map(({ name }) => name)).toEqual(['normal']);
    const creased = await read(`${points}vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n`);
    expect(creased.mesh.variables).toEqual([]);
    expect(creased.mesh.position.length / 3).toBe(4);
    expect(creased.locked).toBeUndefined();
    expect(creased.notes).toEqual([expect.stringContaining('creases')]);
  });

  it('welds repeated points', async () => {
    const { mesh, notes } = await read(`${points}v 0 0 0\nv 1 1 0\nf 1 2 3\nf 5 6 4\n`);
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3]);
    expect(bits(mesh.position)).toBe(bits(Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0)));
    expect(notes).toEqual(['2 repeated points welded.']);
  });

  it('takes materials for labels of the triangles, by their names, and writes them', async () => {
    const text = `mtllib a.mtl\n${points}usemtl unused\nusemtl dark red\nf 1 2 3 4\nusemtl blue\nf 1 3 4\nusemtl dark red\nf 1 2 3\n`;
    const { mesh, regions, regionNames, summary } = await read(text);
    expect(regions).toEqual(new Map([['material', Int32Array.of(1, 1, 2, 1)]]));
    expect(regionNames?.get('material')).toEqual(
      new Map([
        [1, 'dark red'],
        [2, 'blue'],
      ]),
    );
    expect(summary).toContain('Not carried: what materials look like.');
    expect(summary).toContain('Not carried: cell data “material”.');
    const asRegions = { ...mesh, regions: Int32Array.of(2, 1, 1, 2) };
    for (const [written, options, labels] of [
      [asRegions, { regionName: 'material', regionNames }, [1, 2, 2, 1]],
      [mesh, { cellData: regions, regionNames }, [1, 1, 2, 1]],
    ] as const) {
      expect(await lossesOf('obj', written, options)).toEqual([]);
      const back = await readSurface('mesh.obj', await writeSurface('obj', written, options));
      expect(back.mesh.triangles).toEqual(mesh.triangles);
      expect(back.regions).toEqual(new Map([['material', Int32Array.from(labels)]]));
      expect([...(back.regionNames?.get('material')?.values() ?? [])]).toEqual(
        labels[0] === labels[1] ? ['dark red', 'blue'] : ['blue', 'dark red'],
      );
      expect((await lossesOf('vtp', written, options)).join()).toBe(
        'VTP has no place for the names of what is in the cell data “material”.',
      );
    }
    const [loss] = await lossesOf('glb', mesh, { cellData: regions, regionNames });
    expect(loss).toBe('GLB has no place for the cell data “material”.');
  });

  it('labels faces before the first material, too; one material parts nothing', async () => {
    const { regions, regionNames } = await read(`${points}f 1 2 3\nusemtl none\nf 1 3 4\n`);
    expect(regions?.get('material')).toEqual(Int32Array.of(0, 1));
    expect(regionNames?.get('material')).toEqual(
      new Map([
        [0, 'none_'],
        [1, 'none'],
      ]),
    );
    const one = await read(`usemtl red\n${points}f 1 2 3\nf 1 3 4\n`);
    expect(one.regions).toBeUndefined();
    expect(one.summary).toBe('Not carried: the material.');
    expect((await read(`${points}f 1 2 3\nf 1 3 4\nusemtl red\n`)).summary).toBe('');
  });

  it('names what it does not carry', async () => {
    const text = `mtllib a.mtl\no thing\n${points}v 2 2 2 1 1 1\nvt 0 0\nusemtl red\ng group\ns off\nl 1 2\nf 1/1 2/1 3/1\nf 1 3 4\n`;
    const { summary } = await read(text);
    for (const lost of [
      'materials',
      'object names',
      'groups',
      'lines',
      'uv, since not every corner',
      'colours, since not every point',
    ]) {
      expect(summary).toContain(lost);
    }
    expect((await read(`${points}vt 0 0\nf 1/1 2/1 3/1\n`)).summary).toBe('1 point that no face uses left out.');
  });

  it('reads texture coordinates of one to three numbers, and names what it does not carry of these and of points', async () => {
    const textured = (...rows: string[]) =>
      read(`${points}${rows.map((row) => `vt ${row}\n`).join('')}f 1/1 2/2 3/3\n`);
    const { mesh, summary } = await textured('0.5', '1 0.25', '0 1 0');
    expect(mesh.variables[0].values).toEqual(Float64Array.of(0.5, 0, 1, 0.25, 0, 1));
    expect(summary).toBe('1 point that no face uses left out.');
    expect((await textured('0 0', '1 0', '0 1 7')).summary).toContain('Not carried: third texture coordinates.');
    const last = (row: string) => read(`v 0 0 0 1\nv 1 0 0\nv 0 1 ${row}\nf 1 2 3\n`);
    expect((await last('0 1')).summary).toBe('');
    for (const row of ['0 0.5', '0 1 1', '0 1 1 1 1']) {
      expect((await last(row)).summary).toContain('numbers of points beyond places and colours');
    }
    expect((await last('0 one')).summary).toContain('numbers of points beyond places and colours');
  });

  it.each([
    ['an index beyond the points', `${points}f 1 2 5\n`, 'bad_index', 'Face 0', 'point 4', '4 points'],
    ['an index before the first', `${points}f 1 2 -5\n`, 'bad_index', '“-5”', 'line 5'],
    ['index 0', `${points}f 0 1 2\n`, 'bad_index', '“0”', 'line 5'],
    ['an index that is none', `${points}f 1 2 x\n`, 'bad_index', '“x”', 'line 5'],
    ['a huge index', `${points}f 1 2 99999999999\n`, 'bad_index', 'line 5'],
    ['a face of two corners alone', `${points}f 1 2\n`, 'no_triangles', 'no faces of three corners'],
    ['a face of no corners alone', `${points}f\n`, 'no_triangles', 'no faces of three corners'],
    ['a face that goes on in a name', `${points}f 1 2 \\\ng 4\n`, 'no_triangles', 'no faces of three'],
    ['a word for a number', 'v 0 0 zero\n', 'bad_number', '“zero”', 'line 1'],
    ['a word of a million digits for a number', `v ${'1'.repeat(1_000_000)}x 0 0\n`, 'bad_number', 'line 1'],
    ['two coordinates', 'v 0 0\n', 'bad_number', '3 numbers', 'line 1'],
    ['a line that never ends', `${points}f 1 2 \\\n`, 'truncated', 'go on'],
    ['a line without end', `${points}f ${'1 '.repeat(10_000_000)}`, 'bad_header', 'line break', 'line 5'],
    ['no faces', points, 'no_triangles', '4 points'],
  ] as const)('with %s is refused', async (_, text, code, ...words) => {
    await expectFault(text, code, ...words);
  });

  it('is read by its name where its content has no mark', async () => {
    await expect(read('g nothing\n')).rejects.toMatchObject({ code: 'no_points' });
    expect((await readSurface('', bytesOf(`# by\n# someone\nmtllib a.mtl\no a\n${points}f 1 2 3\n`))).format).toBe(
      'obj',
    );
  });
});
