import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { readSurface } from '../../web/formats/read.ts';
import { expectFault } from './faults.ts';
import { bits, bytesOf, fingerprint } from './sample-mesh.ts';

const fixtures = new URL('fixtures/', import.meta.url);
const vtkFiles = readdirSync(fixtures).filter((name) => name.endsWith('.vtk'));

describe.each(vtkFiles)('legacy VTK by VTK, %s', (name) => {
  it('is read with every array as VTK had it', async () => {
    const bytes = new Uint8Array(readFileSync(new URL(name, fixtures)));
    const { mesh, notes, units, componentNames } = await readSurface(name, bytes);
    // As text VTK writes six digits of a float and eleven of a double.
    const short = (value: number, digits: number) =>
      name.includes('ascii') ? Number(value.toPrecision(digits)) : value;
    expect(bits(mesh.position)).toBe(bits(Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.1, 0.5, 0.5, 1)));
    expect(Array.from(mesh.triangles)).toEqual([3, 2, 1, 3, 1, 0, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4]);
    const repeated = (...values: number[]) => Array(5).fill(values).flat();
    expect(fingerprint(mesh).slice(2)).toEqual([
      `pressure 1 ${bits(Float32Array.of(1.1, 2.2, 3.3, 4.4, 5.5))}`,
      `wind speed 3 ${bits(Float64Array.from(repeated(0, 0.1, 1)))}`,
      `normal 3 ${bits(Float32Array.from(repeated(0, 0, 1)))}`,
      `uv 2 ${bits(Float32Array.from(repeated(0, 0.5)))}`,
      `stress 9 ${bits(Float32Array.from(repeated(0, 1, 2, 3, 4, 5, 6, 7, 8)))}`,
      `gid 1 ${bits(Float32Array.of(0, 1, 2, 3, 4))}`,
      `temperature 1 ${bits(Float64Array.of(0.1, 0.2, short(1 / 3, 11), 1e-300, 0.7))}`,
      `velocity 3 ${bits(Float32Array.from({ length: 15 }, (_, i) => short(Math.fround(i / 7), 6)))}`,
      `flag 1 ${bits(Float32Array.of(0, 1, 2, 3, 255))}`,
      `bits 1 ${bits(Float32Array.of(0, 1, 0, 1, 0))}`,
    ]);
    expect({ ...units }).toEqual({ pressure: 'kg/(m s²)' });
    expect({ ...componentNames }).toEqual({ velocity: ['u', 'v', 'w'] });
    expect(notes).toEqual([
      'Not carried: point data “label”; cell data “region”; field data “TimeValue”; 1 vertex cell; 1 line.',
      expect.stringContaining('Cell Data to Point Data'),
      '1 polygon with more than three corners split into triangles.',
      '1 triangle strip taken apart into triangles.',
      expect.stringContaining('Taken for identifiers, which “*” does not bound: “gid”, “bits”;'),
    ]);
  });
});

const head = '# vtk DataFile Version 2.0\ntitle\nASCII\nDATASET POLYDATA\n';
const points = 'POINTS 3 float\n0 0 0 1 0 0 0 1 0\n';
const triangle = 'POLYGONS 1 4\n3 0 1 2\n';
const geometry = head + points + triangle;

describe('legacy VTK attributes', () => {
  const read = async (text: string) => {
    const { mesh, summary } = await readSurface('', bytesOf(`${geometry}POINT_DATA 3\n${text}`));
    return { variables: mesh.variables.map(({ name, values }) => `${name} ${Array.from(values).join(' ')}`), summary };
  };

  it('are read without LOOKUP_TABLE, in any case, with several components', async () => {
    const text = 'Scalars a float 2\n1 2 3 4 5 6\nscalars b int\nlookup_table default\n7 8 9\n';
    expect((await read(text)).variables).toEqual(['a 1 2 3 4 5 6', 'b 7 8 9']);
  });

  it('are read past colour maps and colours', async () => {
    const text =
      'SCALARS a float 1\nLOOKUP_TABLE map\n1 2 3\nLOOKUP_TABLE map 2\n0 0 0 1\n1 1 1 1\nCOLOR_SCALARS c 2\n0 .5 1 0 0 1\n';
    const { variables, summary } = await read(text);
    // Colours as VTK holds them.
    expect(variables).toEqual(['a 1 2 3', 'c 0 128 255 0 0 255']);
    expect(summary).toContain('Not carried: colour maps “map”.');
  });

  it('are left out by name if they belong to cells or are text', async () => {
    const text =
      'FIELD f 2\nlabel 1 3 string\na\n\nb\nq 1 3 int\n1 2 3\nCELL_DATA 1\nSCALARS c float\nLOOKUP_TABLE default\n1.5\nPOINT_DATA 3\nVECTORS v float\n0 0 0 0 0 0 0 0 0\n';
    const { variables, summary } = await read(text);
    expect(variables).toEqual(['q 1 2 3', 'v 0 0 0 0 0 0 0 0 0']);
    expect(summary).toContain('point data “label”; cell data “c”');
  });

  it('keep the names of their components, of which some may have none', async () => {
    const labels =
      'METADATA\nCOMPONENT_NAMES\nr\n\nz\nINFORMATION 1\nNAME UNITS_LABEL LOCATION vtkDataArray\nDATA m\n\n';
    const text = `${geometry}POINT_DATA 3\nFIELD f 2\na 3 3 int\n1 2 3 4 5 6 7 8 9\n${labels}b 1 3 int\n1 2 3\n`;
    const { mesh, units, componentNames } = await readSurface('', bytesOf(text));
    expect(mesh.variables.map(({ name }) => name)).toEqual(['a', 'b']);
    expect({ ...componentNames }).toEqual({ a: ['r', '1', 'z'] });
    expect({ ...units }).toEqual({ a: 'm' });
  });

  it('may be named like keywords', async () => {
    const text = 'FIELD f 3\nMETADATA 1 3 int\n1 2 3\nPOINTS 1 3 int\n1 2 3\n__proto__ 1 3 int\n1 2 3\n';
    expect((await read(text)).variables).toEqual(['METADATA 1 2 3', 'POINTS 1 2 3', '__proto__ 1 2 3']);
  });

  it('that are missing raise a suspicion', async () => {
    expect((await read('')).summary).toContain('may have been cut short');
  });
});

describe('a legacy VTK file', () => {
  it.each([
    ['before it', (text: string) => `\n \n${text}`],
    ['behind each line', (text: string) => text.replace(/^(#.*|title|.*SCII)$/gim, '$1\n\n')],
    ['behind each line, in Windows', (text: string) => text.replaceAll('\n', '\r\n\r\n')],
    ['in place of the title', (text: string) => text.replace(/\n.*\nASCII/, '\n\nASCII')],
    ['around a title that is an encoding', (text: string) => text.replace(/\n.*\nASCII/, '\n\nBINARY\n\nASCII')],
  ])('with empty lines %s is read', async (_, change) => {
    const { mesh } = await readSurface('', bytesOf(change(geometry)));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2]);
  });

  it('leaves ghosts out, of cells and points, and counts them', async () => {
    const two = `${head}POINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\nPOLYGONS 2 8\n3 0 1 2\n3 1 3 2\n`;
    const cells = 'CELL_DATA 2\nSCALARS part int\nLOOKUP_TABLE default\n5 6\n';
    for (const ghosts of [
      'FIELD f 1\nvtkGhostType 1 2 unsigned_char\n1 0\n',
      'SCALARS vtkGhostType unsigned_char 1\nLOOKUP_TABLE default\n32 0\n',
    ]) {
      const { mesh, regions, notes } = await readSurface('', bytesOf(two + cells + ghosts));
      expect(Array.from(mesh.triangles)).toEqual([0, 2, 1]);
      expect([...(regions ?? [])]).toEqual([['part', Int32Array.of(6)]]);
      expect(notes).toContainEqual(expect.stringContaining('1 ghost cell and 1 ghost point left out'));
      expect(notes.join(' ')).not.toContain('vtkGhost');
    }
    const points = 'POINT_DATA 4\nSCALARS vtkGhostType unsigned_char 1\nLOOKUP_TABLE default\n2 0 0 1\n';
    const { mesh } = await readSurface('', bytesOf(two + points));
    expect(Array.from(mesh.triangles)).toEqual([0, 2, 1]);
    expect(mesh.variables).toEqual([]);
  });

  it('reads the first of two arrays of one name, and says so', async () => {
    const twice = 'POINT_DATA 3\nSCALARS a int\n1 2 3\nSCALARS a int\n4 5 6\n';
    const { mesh, summary } = await readSurface('', bytesOf(geometry + twice));
    expect(mesh.variables.map(({ name, values }) => [name, ...values])).toEqual([['a', 1, 2, 3]]);
    expect(summary).toContain('what is named “a” a second time');
  });

  it.each([
    ['without an encoding', '# vtk DataFile Version 2.0\ntitle\nUTF8\n\n\n', 'bad_header', 'ASCII or BINARY'],
    [
      'without a data set',
      '# vtk DataFile Version 2.0\ntitle\nASCII\nPOINTS 1 float\n0 0 0\n',
      'bad_header',
      'DATASET',
    ],
    [
      'of another kind',
      '# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS',
      'unsupported_format',
      'Extract Surface',
    ],
    ['without points', head, 'no_points', 'POINTS'],
    ['with no points', `${head}POINTS 0 float\n${triangle}`, 'no_points', 'no points'],
    ['without polygons', head + points, 'no_triangles', '3 points'],
    ['with an unknown keyword', `${geometry}SPAM 3\n`, 'bad_header', '“SPAM”', 'line 9'],
    ['with attributes of nothing', `${geometry}SCALARS a float\n1 2 3\n`, 'bad_header', '“SCALARS”'],
    ['with an unknown type', `${head}POINTS 3 quad\n`, 'truncated', '“quad”'],
    ['with an unknown type', `${head}POINTS 3 quad\n0 0 0\n`, 'unsupported_feature', '“quad”', 'line 5'],
    ['with a negative count', `${head}POINTS -3 float\n0 0 0\n`, 'bad_header', '“-3”'],
    ['with 2^32 − 1 points', `${head}POINTS 4294967295 float\n0 0 0\n`, 'truncated', '12 884 901 885 numbers'],
    ['with 2^32 − 1 cells', `${head + points}POLYGONS 4294967295 4294967295\n3 0 1 2\n`, 'truncated', 'POLYGONS'],
    ['with more cells than numbers', `${head + points}POLYGONS 5 4\n3 0 1 2\n`, 'count_mismatch', 'POLYGONS'],
    ['with more numbers than cells', `${head + points}POLYGONS 1 5\n3 0 1 2 0\n`, 'count_mismatch', 'take 4'],
    ['with a huge cell', `${head + points}POLYGONS 1 4\n2000000000 0 1 2\n`, 'bad_polygon', '2000000000 corners'],
    ['with a negative cell', `${head + points}POLYGONS 1 4\n-1 0 1 2\n`, 'bad_polygon', '-1 corners'],
    ['with a cell of two corners alone', `${head + points}POLYGONS 1 3\n2 0 1\n`, 'no_triangles', 'no polygons'],
    ['with an index beyond the points', `${head + points}POLYGONS 1 4\n3 0 1 3\n`, 'bad_index', 'Polygon 0', 'point 3'],
    ['with a negative index', `${head + points}POLYGONS 1 4\n3 0 -1 2\n`, 'bad_index', '-1'],
    ['with other counts of data', `${geometry}POINT_DATA 4\n`, 'count_mismatch', '4 points'],
    [
      'with other counts of a field',
      `${geometry}POINT_DATA 3\nFIELD f 1\na 1 2 float\n1 2\n`,
      'count_mismatch',
      '“a”',
      '2 tuples',
    ],
    ['with too few values', `${geometry}POINT_DATA 3\nSCALARS a float\nLOOKUP_TABLE default\n1 2`, 'truncated', '“a”'],
    [
      'with too many values',
      `${geometry}POINT_DATA 3\nSCALARS a float\nLOOKUP_TABLE default\n1 2 3 4\n`,
      'bad_header',
      '“4”',
    ],
    [
      'with a word for a number',
      `${geometry}POINT_DATA 3\nSCALARS a float\nLOOKUP_TABLE default\n1 two 3\n`,
      'bad_number',
      '“two”',
    ],
    ['with a nameless array', `${geometry}POINT_DATA 3\nFIELD f 1\n`, 'truncated', 'count'],
    [
      'with too few field arrays',
      `${geometry}POINT_DATA 3\nFIELD f 4294967295\na 1 3 int\n1 2 3\n`,
      'truncated',
      'count',
    ],
    ['with endless texts', `${geometry}POINT_DATA 3\nFIELD f 1\na 999999999 3 string\nx\n`, 'truncated', '“a”'],
    ['with a name that is not UTF-8', `${geometry}POINT_DATA 3\nSCALARS %FF int\n1 2 3\n`, 'bad_encoding', '“%FF”'],
    [
      'with points twice',
      `${geometry}POINT_DATA 3\n${points.replace('3 float', '2 float')}`,
      'bad_header',
      'POINTS',
      'line 10',
    ],
    ['with polygons twice', geometry + triangle, 'bad_header', 'POLYGONS a second time', 'line 9'],
    [
      'with data before its points',
      `${head}POINT_DATA 0\nSCALARS a float\n${points}${triangle}`,
      'bad_header',
      'POINT_DATA stands before',
      'line 5',
    ],
  ] as const)('%s is refused', async (_, file, code, ...words) => {
    await expectFault(file, code, ...words);
  });

  it.each([
    ['an array', 'SCALARS @ float\n1 2 3\n'],
    ['a unit', 'FIELD f 1\na 1 3 int\n1 2 3\nMETADATA\nINFORMATION 1\nNAME UNITS_LABEL LOCATION x\nDATA @\n\n'],
    ['a component', 'FIELD f 1\na 1 3 int\n1 2 3\nMETADATA\nCOMPONENT_NAMES\n@\n\n'],
  ])('with the raw bytes of another encoding as the name of %s is refused', async (_, text) => {
    const latin1 = bytesOf(`${geometry}POINT_DATA 3\n${text}`).map((byte) => (byte === 64 ? 0xe4 : byte));
    await expectFault(latin1, 'bad_encoding', 'UTF-8', 'line');
  });

  it('of version 5 with contradicting offsets is refused', async () => {
    const file = (offsets: string, connectivity: string) =>
      `${(head + points).replace('2.0', '5.1')}POLYGONS 2 3\nOFFSETS vtktypeint64\n${offsets}\nCONNECTIVITY vtktypeint64\n${connectivity}\n`;
    const { mesh } = await readSurface('', bytesOf(file('0 3', '0 1 2')));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2]);
    await expectFault(file('0 2', '0 1 2'), 'count_mismatch', 'OFFSETS');
    await expectFault(file('1 3', '0 1 2'), 'count_mismatch', 'OFFSETS');
    await expectFault(file('3 0', '0 1 2'), 'bad_polygon', 'OFFSETS');
    await expectFault(file('0 3', '0 1 -2'), 'bad_index', '-2');
    await expectFault(file('0 3', '0 1 4294967298'), 'bad_index', '4294967298');
    await expectFault(file('0 3', '0 1 9223372036854775807'), 'bad_index', 'CONNECTIVITY');
    await expectFault(file('0 3', '0 1 2').replace('CONNECTIVITY', 'CONNECT'), 'bad_header', '“CONNECT”');
  });
});
