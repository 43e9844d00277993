import { readdirSync, readFileSync } from 'node:fs';
import { zlibSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { readSurface } from '../../web/formats/read.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { expectFault } from './faults.ts';
import { bits, bytesOf, fingerprint, smallMesh } from './sample-mesh.ts';

const fixtures = new URL('fixtures/', import.meta.url);
const fixture = (name: string) => new Uint8Array(readFileSync(new URL(name, fixtures)));
const vtkFiles = readdirSync(fixtures).filter((name) => name.endsWith('.vtp') && !name.includes('lz4'));

describe.each(vtkFiles)('VTP by VTK, %s', (name) => {
  it('is read with every array as VTK had it', async () => {
    const { mesh, units, componentNames } = await readSurface(name, fixture(name));
    const third = Math.fround(1 / 7);
    const velocity = Float32Array.from({ length: 15 }, (_, i) => Math.fround(i / 7));
    expect(velocity[1]).toBe(third);
    expect(bits(mesh.position)).toBe(bits(Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.1, 0.5, 0.5, 1)));
    expect(Array.from(mesh.triangles)).toEqual([3, 2, 1, 3, 1, 0, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4]);
    expect(fingerprint(mesh).slice(2)).toEqual([
      `pressure 1 ${bits(Float32Array.of(1.1, 2.2, 3.3, 4.4, 5.5))}`,
      `temperature 1 ${bits(Float64Array.of(0.1, 0.2, 1 / 3, 1e-300, 0.7))}`,
      `velocity 3 ${bits(velocity)}`,
      `id 1 ${bits(Float32Array.of(0, -1, 2, 2 ** 40, 4))}`,
      `flag 1 ${bits(Float32Array.of(0, 1, 2, 3, 255))}`,
    ]);
    expect({ ...units }).toEqual({ pressure: 'kg/(m s²)' });
    expect({ ...componentNames }).toEqual({ velocity: ['u', 'v', 'w'] });
  });

  it('has its losses and changes named', async () => {
    const { notes, wholeTypes } = await readSurface(name, fixture(name));
    expect({ ...wholeTypes }).toEqual({ id: 'int64', flag: 'uint8' });
    expect(notes).toEqual([
      'Not carried: cell data “region”; field data “TimeValue”; 1 vertex cell; 1 line.',
      expect.stringContaining('Cell Data to Point Data'),
      '1 polygon with more than three corners split into triangles.',
      '1 triangle strip taken apart into triangles.',
      expect.stringContaining('Taken for identifiers, which “*” does not bound: “id”;'),
    ]);
  });
});

/** A piece of one triangle with one array `p`; any part can be replaced. */
function piece(parts: { points?: string; p?: string; polys?: string; counts?: string } = {}): string {
  const counts = parts.counts ?? 'NumberOfPoints="3" NumberOfPolys="1"';
  const points =
    parts.points ?? '<DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray>';
  const p = parts.p ?? '<DataArray type="Float32" Name="p" format="ascii">1 2 3</DataArray>';
  const polys = parts.polys ?? cells('0 1 2', '3');
  return `<Piece ${counts}><PointData>${p}</PointData><Points>${points}</Points><Polys>${polys}</Polys></Piece>`;
}

function cells(connectivity: string, offsets: string): string {
  const array = (name: string, text: string) =>
    `<DataArray type="Int64" Name="${name}" format="ascii">${text}</DataArray>`;
  return array('connectivity', connectivity) + array('offsets', offsets);
}

function vtp(pieces: string, attributes = 'type="PolyData"', rest = ''): string {
  return `<?xml version="1.0"?>\n<VTKFile ${attributes}><PolyData>${pieces}</PolyData>${rest}</VTKFile>\n`;
}

const read = (file: string) => readSurface('', bytesOf(file));

describe('VTP pieces', () => {
  it('are joined', async () => {
    const second = piece({
      p: '<DataArray type="Float64" Name="p" format="ascii">4 5 0.1</DataArray>',
      points: '<DataArray type="Float32" NumberOfComponents="3" format="ascii">5 0 0 6 0 0 5 1 0</DataArray>',
    });
    const empty = '<Piece NumberOfPoints="0" NumberOfPolys="0"><Points/></Piece>';
    const { mesh, notes } = await read(vtp(piece() + empty + second));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 3, 4, 5]);
    expect(mesh.position.length).toBe(18);
    expect(bits(mesh.variables[0].values)).toBe(bits(Float64Array.of(1, 2, 3, 4, 5, 0.1)));
    expect(notes).toEqual(['2 pieces joined.']);
  });

  it('are welded where they meet, and left apart where their values differ', async () => {
    const points = '<DataArray type="Float32" NumberOfComponents="3" format="ascii">1 0 0 0 1 0 1 1 0</DataArray>';
    const second = piece({ points, p: '<DataArray type="Float32" Name="p" format="ascii">2 9 4</DataArray>' });
    const { mesh, notes, locked } = await read(vtp(piece() + second));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 1, 3, 4]);
    expect(Array.from(mesh.variables[0].values)).toEqual([1, 2, 3, 9, 4]);
    expect(locked).toBeUndefined();
    expect(notes).toEqual([
      '2 pieces joined.',
      '1 repeated point welded.',
      expect.stringMatching(/^2 points on seams/),
    ]);
  });

  it('lose the arrays that not all have, and say so', async () => {
    const vector =
      '<DataArray type="Float32" Name="p" NumberOfComponents="3" format="ascii">1 2 3 4 5 6 7 8 9</DataArray>';
    const extra = '<DataArray type="Float32" Name="q" format="ascii">1 2 3</DataArray>';
    const { mesh, summary } = await read(vtp(piece() + piece({ p: vector + extra })));
    expect(mesh.variables).toEqual([]);
    expect(summary).toContain('“p”, “q”');
  });
});

describe('VTP component names', () => {
  const namesOf = async (components: number, attributes: string) => {
    const values = Array(3 * components)
      .fill(0)
      .join(' ');
    const shape = `Name="v" NumberOfComponents="${components}" ${attributes}`;
    const { componentNames } = await read(
      vtp(piece({ p: `<DataArray type="Float32" ${shape} format="ascii">${values}</DataArray>` })),
    );
    return { ...componentNames };
  };

  it('are as many as there are components; one that is missing or empty is its number', async () => {
    expect(await namesOf(3, 'ComponentName0="" ComponentName1="θ"')).toEqual({ v: ['0', 'θ', '2'] });
    expect(await namesOf(2, 'ComponentName0="" ComponentName1=""')).toEqual({});
    const many = Array.from({ length: 100 }, (_, i) => `c${i}`);
    expect(await namesOf(100, many.map((name, i) => `ComponentName${i}="${name}"`).join(' '))).toEqual({ v: many });
  });
});

describe('VTP types', () => {
  const arrayOf = async (type: string, text: string) =>
    (await read(vtp(piece({ p: `<DataArray type="${type}" Name="p" format="ascii">${text}</DataArray>` })))).mesh
      .variables[0].values;

  it('become single precision where every value survives it, else double', async () => {
    for (const type of ['Int8', 'UInt8', 'Int16', 'UInt16', 'Int32', 'UInt32', 'Int64', 'UInt64']) {
      expect(await arrayOf(type, '1 2 100')).toEqual(Float32Array.of(1, 2, 100));
    }
    expect(await arrayOf('Int32', '1 2 16777217')).toEqual(Float64Array.of(1, 2, 16777217));
    expect(await arrayOf('Float32', '0.1 nan -inf')).toEqual(Float32Array.of(0.1, Number.NaN, -Infinity));
    expect(await arrayOf('Float64', '0.1 2 3')).toEqual(Float64Array.of(0.1, 2, 3));
  });

  it('that are too long for doubles are said to be rounded', async () => {
    const file = vtp(piece({ p: '<DataArray type="Int64" Name="p" format="ascii">1 2 9007199254740993</DataArray>' }));
    expect((await read(file)).summary).toContain('Rounded, being beyond 2^53: values of “p”');
  });

  it('that are bits are read, packed or not', async () => {
    const asText = piece({ p: '<DataArray type="Bit" Name="p" format="ascii">1 0 1</DataArray>' });
    const packed = btoa(String.fromCharCode(1, 0, 0, 0, 0b10100000));
    const asBytes = piece({ p: `<DataArray type="Bit" Name="p" format="binary">${packed}</DataArray>` });
    for (const text of [asText, asBytes]) {
      expect((await read(vtp(text))).mesh.variables[0].values).toEqual(Float32Array.of(1, 0, 1));
    }
  });

  it('that are not numbers are left out by name, of points and of cells', async () => {
    for (const [array, words] of [
      ['<DataArray type="Float128" Name="q" format="ascii">1 0 1</DataArray>', 'arrays in a form that is not read “q”'],
      ['<DataArray type="Float32" Name="q" format="hex">00</DataArray>', 'arrays in a form that is not read “q”'],
      ['<Array type="String" Name="label" format="ascii">65 0</Array>', 'text arrays “label”'],
      ['<DataArray type="String" Name="label" format="ascii">65 0 66 0 67 0</DataArray>', 'text arrays “label”'],
    ]) {
      const p = '<DataArray type="Float32" Name="p" format="ascii">1 2 3</DataArray>';
      const { mesh, summary } = await read(vtp(piece({ p: array + p })));
      expect(mesh.variables.map(({ name }) => name)).toEqual(['p']);
      expect(summary).toContain(words);
      const ofCells = vtp(piece().replace('</Piece>', `<CellData>${array}</CellData></Piece>`));
      expect((await read(ofCells)).summary).toMatch(/cell data “(q|label)”/);
    }
    const points = vtp(piece({ points: '<DataArray type="String" NumberOfComponents="3" format="ascii"/>' }));
    await expectFault(points, 'unsupported_feature', '“String”');
  });
});

describe('ghosts in a VTP file', () => {
  const bits = (tag: string, values: string, name = 'vtkGhostType') =>
    `<${tag}><DataArray type="UInt8" Name="${name}" format="ascii">${values}</DataArray></${tag}>`;
  const grid = '0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0';
  const triangles = ['0 1 4', '0 4 3', '1 2 5', '1 5 4'];
  const half = (data: string, extra = '', places = grid) =>
    `<Piece NumberOfPoints="6" NumberOfPolys="4" ${extra}><Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">${places}</DataArray></Points>${data}<Polys>${cells(triangles.join(' '), '3 6 9 12')}</Polys></Piece>`;
  const pressure = '<DataArray type="Float32" Name="p" format="ascii">0 1 2 3 4 5</DataArray>';

  it.each([
    ['duplicates', 1],
    ['replaced by finer cells', 8],
    ['hidden', 32],
    ['more than one of it', 33],
  ])('are left out where they are %s, with their data and points', async (_, bit) => {
    const region = '<DataArray type="Int32" Name="part" format="ascii">7 8 9 10</DataArray></CellData>';
    const data = bits('CellData', `0 ${bit} 0 0`).replace('</CellData>', region);
    const { mesh, notes, regions } = await read(vtp(half(`<PointData>${pressure}</PointData>${data}`)));
    expect(mesh.triangles).toHaveLength(9);
    expect(Array.from(mesh.variables[0].values)).toEqual([0, 1, 2, 4, 5]);
    expect(Array.from(mesh.position.subarray(9, 12))).toEqual([1, 1, 0]);
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 3, 1, 2, 4, 1, 4, 3]);
    expect([...(regions ?? [])]).toEqual([['part', Int32Array.of(7, 9, 10)]]);
    expect(notes).toContainEqual(expect.stringContaining('1 ghost cell and 1 ghost point left out'));
    expect(mesh.variables.map(({ name }) => name)).toEqual(['p']);
  });

  it.each([0, 2, 4, 16])('are none with bit %i of cells', async (bit) => {
    const { mesh, notes } = await read(vtp(half(bits('CellData', `0 ${bit} 0 0`))));
    expect(mesh.triangles).toHaveLength(12);
    expect(notes).toEqual([]);
  });

  it('are cells at hidden points; points that another piece has stay where cells are', async () => {
    const hidden = await read(vtp(half(bits('PointData', '0 0 0 2 0 0'))));
    expect(Array.from(hidden.mesh.triangles)).toEqual([0, 1, 3, 1, 2, 4, 1, 4, 3]);
    expect(hidden.summary).toContain('1 ghost cell and 1 ghost point left out');
    const duplicate = await read(vtp(half(bits('PointData', '0 0 1 0 0 1'))));
    expect(duplicate.mesh.triangles).toHaveLength(12);
    expect(duplicate.mesh.position).toHaveLength(18);
    expect(duplicate.mesh.variables).toEqual([]);
  });

  it('of two pieces are left out of each, and counted together', async () => {
    const shifted = '1 0 0 2 0 0 3 0 0 1 1 0 2 1 0 3 1 0';
    const pieces = half(bits('CellData', '0 0 1 1')) + half(bits('CellData', '0 0 0 0'), '', shifted);
    const { mesh, summary } = await read(vtp(pieces));
    expect(mesh.triangles).toHaveLength(18);
    expect(mesh.position).toHaveLength(8 * 3);
    expect(summary).toContain('2 ghost cells and 2 ghost points left out');
  });

  it('are told by their levels in files of older versions', async () => {
    const { mesh, summary } = await read(vtp(half(bits('CellData', '0 2 0 1', 'vtkGhostLevels'))));
    expect(mesh.triangles).toHaveLength(6);
    expect(summary).toContain('2 ghost cells');
  });

  it('behind vertices and lines, and among strips, are those that are meant', async () => {
    const lines = `<Lines>${cells('0 1', '2')}</Lines><Strips>${cells('0 1 3 4 1 2 4 5', '4 8')}</Strips>`;
    const data = bits('CellData', '1 0 0 1 0 1 0') + lines;
    const { mesh, notes } = await read(vtp(half(data, 'NumberOfLines="1" NumberOfStrips="2"')));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 4, 0, 4, 3, 1, 5, 4, 1, 2, 4, 2, 5, 4]);
    expect(notes).toContainEqual(expect.stringContaining('2 ghost cells left out'));
    expect(notes).toContain('1 triangle strip taken apart into triangles.');
  });

  it('alone are no surface', async () => {
    await expectFault(vtp(half(bits('CellData', '1 1 1 1'))), 'no_points');
  });
});

describe('an encoding that a VTP file declares', () => {
  const inEncoding = (encoding: string, name: number[]) => {
    const p = '<DataArray type="Float32" Name="#" format="ascii">1 2 3</DataArray>';
    const text = vtp(piece({ p })).replace('version="1.0"', `version="1.0" encoding="${encoding}"`);
    return Uint8Array.from([...bytesOf(text)].flatMap((byte) => (byte === 35 ? name : [byte])));
  };

  it.each([
    ['ISO-8859-1', [0xe9, 0xf1], 'éñ'],
    ['iso-8859-15', [0xa4], '€'],
    ['windows-1252', [0x80], '€'],
    ['Shift_JIS', [0x88, 0xb3, 0x97, 0xcd], '圧力'],
    ['UTF-8', [0xc3, 0xa9], 'é'],
  ])('is that of its names: %s', async (encoding, bytes, name) => {
    const { mesh } = await readSurface('', inEncoding(encoding, bytes));
    expect(mesh.variables.map((variable) => variable.name)).toEqual([name]);
  });

  it('is named where it cannot be read, or is another one', async () => {
    await expectFault(inEncoding('EBCDIC-FR', [65]), 'unsupported_feature', '“ebcdic-fr”');
    await expectFault(inEncoding('UTF-8', [0xe9]), 'bad_encoding', 'UTF-8');
    const wide = Uint8Array.from([0xff, 0xfe, ...bytesOf(vtp(piece()))].flatMap((b, i) => (i < 2 ? [b] : [b, 0])));
    await expectFault(wide, 'unsupported_format', 'UTF-16');
  });
});

describe('a VTP file', () => {
  it('with arrays that have no name of their own is read without them', async () => {
    const nameless = '<DataArray type="Float32" format="ascii">1 2 3</DataArray>';
    const p = (values: string) => `<DataArray type="Float32" Name="p" format="ascii">${values}</DataArray>`;
    const { mesh, summary } = await read(
      vtp(piece({ p: nameless + p('1 2 3') + nameless.replace('type', 'Name="" type') + p('4 5 6') })),
    );
    expect(mesh.variables.map(({ name, values }) => [name, ...values])).toEqual([['p', 1, 2, 3]]);
    expect(summary).toContain('Not carried: 2 arrays of the point data without a name.');
    expect(summary).toContain('Not carried: what is named “p” a second time in the point data.');
  });

  it('with damaged cell data is read without them', async () => {
    const data = '<CellData><DataArray type="Int32" Name="part" format="ascii">1 2 3</DataArray></CellData>';
    const { mesh, regions, unfitRegions, summary } = await read(vtp(piece().replace('</Piece>', `${data}</Piece>`)));
    expect(mesh.triangles).toHaveLength(3);
    expect(regions?.size).toBe(0);
    expect(unfitRegions?.get('part')).toContain('it is damaged');
    expect(summary).toContain('cell data “part”');
  });

  const array = (attributes: string, text: string) =>
    `<DataArray type="Float32" Name="p" ${attributes}>${text}</DataArray>`;
  const base64 = (...words: number[]) => btoa(String.fromCharCode(...new Uint8Array(Uint32Array.from(words).buffer)));
  const zlib = 'type="PolyData" compressor="vtkZLibDataCompressor"';

  it.each([
    ['with too few values', piece({ p: array('format="ascii"', '1 2') }), 'count_mismatch', '“p”', 'needs 3'],
    ['with too many values', piece({ p: array('format="ascii"', '1 2 3 4') }), 'count_mismatch', '“p”', 'more than 3'],
    [
      'with too few bytes',
      piece({ p: array('format="binary"', base64(8, 0, 0)) }),
      'count_mismatch',
      '“p”',
      '8 bytes',
      'needs 12',
    ],
    [
      'with too many bytes',
      piece({ p: array('format="binary"', base64(16, 0, 0, 0, 0)) }),
      'count_mismatch',
      '16 bytes',
    ],
    [
      'with less data than its length says',
      piece({ p: array('format="binary"', base64(12, 0, 0)) }),
      'truncated',
      '“p”',
    ],
    ['with an empty array', piece({ p: array('format="binary"', '') }), 'truncated', '“p”'],
    ['with garbage for base64', piece({ p: array('format="binary"', 'DAAA*AAA') }), 'corrupt', '“p”', '“*”'],
    [
      'with padding in the wrong place',
      piece({ p: array('format="binary"', 'D=AAAAAAAAAAAAAAAAAAAAAA') }),
      'corrupt',
      '“p”',
    ],
    ['with garbage for a number', piece({ p: array('format="ascii"', '1 two 3') }), 'bad_number', '“p”', '“two”'],
    ['with an array nowhere', piece({ p: array('format="appended" offset="0"', '') }), 'truncated', 'AppendedData'],
    ['with two PolyData', `${piece()}</PolyData><PolyData>${piece()}`, 'duplicate_name', 'PolyData', '2 times'],
    [
      'with two arrays of points',
      piece({ points: array('NumberOfComponents="3" format="ascii"', '0 0 0 1 0 0 0 1 0').repeat(2) }),
      'duplicate_name',
      '“Points”',
    ],
    ['with corners twice', piece({ polys: cells('0 1 2', '3').repeat(2) }), 'duplicate_name', 'Polys offsets'],
    [
      'with flat points',
      piece({ points: array('NumberOfComponents="2" format="ascii"', '0 0 1 0 1 1') }),
      'count_mismatch',
      '2 components',
    ],
    ['without points', piece({ points: '' }), 'no_points', '“Points”'],
    ['with no point', '<Piece NumberOfPoints="0" NumberOfPolys="0"/>', 'no_points'],
    ['without a piece', '', 'no_points'],
    ['without polygons', piece({ counts: 'NumberOfPoints="3" NumberOfPolys="0"' }), 'no_triangles', '3 points'],
    [
      'with an index beyond the points',
      piece({ polys: cells('0 1 3', '3') }),
      'bad_index',
      'Polygon 0',
      'point 3',
      '(0 to 2)',
    ],
    ['with a negative index', piece({ polys: cells('0 -1 2', '3') }), 'bad_index', 'connectivity', '-1'],
    ['with a fractional index', piece({ polys: cells('0 1.5 2', '3') }), 'bad_index', '1.5'],
    ['with an index beyond 32 bits', piece({ polys: cells('0 4294967297 2', '3') }), 'bad_index', '4294967297'],
    ['with a polygon of two corners alone', piece({ polys: cells('0 1', '2') }), 'no_triangles', 'no polygons'],
    [
      'with falling offsets',
      piece({ polys: cells('0 1 2', '3 0'), counts: 'NumberOfPoints="3" NumberOfPolys="2"' }),
      'bad_polygon',
      'Polys',
    ],
    [
      'without connectivity',
      piece({ polys: cells('0 1 2', '3').replace('connectivity', 'c') }),
      'count_mismatch',
      'connectivity',
      'missing',
    ],
    [
      'with a negative count',
      piece({ counts: 'NumberOfPoints="-3" NumberOfPolys="1"' }),
      'bad_header',
      'NumberOfPoints',
      '-3',
    ],
    [
      'with 2^32 − 1 points',
      piece({ counts: 'NumberOfPoints="4294967295" NumberOfPolys="1"' }),
      'count_mismatch',
      '“Points”',
    ],
    [
      'with 2^32 − 1 polygons',
      piece({ counts: 'NumberOfPoints="3" NumberOfPolys="4294967295"' }),
      'count_mismatch',
      'offsets',
    ],
    ['with offsets beyond the file', piece({ polys: cells('0 1 2', '4294967295') }), 'count_mismatch', 'connectivity'],
    [
      'with huge components',
      piece({ p: array('NumberOfComponents="999999999999" format="ascii"', '1 2 3') }),
      'count_mismatch',
      '“p”',
    ],
    ['without its closing tags', `${piece().slice(0, -20)}`, 'bad_xml', 'not well-formed'],
  ] as const)('%s is refused', async (_, content, code, ...words) => {
    await expectFault(vtp(content), code, ...words);
  });

  it.each([
    [
      'of another kind',
      vtp('', 'type="UnstructuredGrid"'),
      'unsupported_format',
      'UnstructuredGrid',
      'Extract Surface',
    ],
    ['that refers to others', vtp('', 'type="PPolyData"'), 'unsupported_format', 'refers to other files'],
    [
      'packed by LZ4',
      vtp(
        piece({ p: '<DataArray type="Float32" Name="p" format="binary">AAAA</DataArray>' }),
        'type="PolyData" compressor="vtkLZ4DataCompressor"',
      ),
      'unsupported_feature',
      'LZ4',
    ],
    ['of unknown header type', vtp(piece(), 'type="PolyData" header_type="UInt16"'), 'bad_header', 'UInt16'],
    ['of unknown byte order', vtp(piece(), 'type="PolyData" byte_order="Middle"'), 'bad_header', 'Middle'],
    [
      'with a DOCTYPE',
      `<!DOCTYPE VTKFile [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]>${vtp(piece()).slice(22)}`,
      'bad_xml',
      'DOCTYPE',
    ],
    ['with an unknown entity', vtp(piece({ p: '<DataArray Name="&lol;"/>' })), 'bad_xml', 'line 2'],
    ['nested without end', vtp('<a>'.repeat(100)), 'bad_xml', 'nested'],
    ['of elements without end', vtp('<a/>'.repeat(300_000)), 'bad_xml', 'too many'],
    [
      'with a DOCTYPE that names another file',
      `<!DOCTYPE VTKFile SYSTEM "file:///etc/passwd">${vtp(piece()).slice(22)}`,
      'bad_xml',
      'DOCTYPE',
    ],
  ] as const)('%s is refused', async (_, file, code, ...words) => {
    await expectFault(file, code, ...words);
  });

  it('with a name that is not UTF-8 is refused', async () => {
    const bytes = bytesOf(vtp(piece()).replace('Name="p"', 'Name="#"'));
    await expectFault(
      bytes.map((byte) => (byte === 35 ? 0xff : byte)),
      'bad_encoding',
      'UTF-8',
    );
  });

  it('reads zlib, and refuses it damaged', async () => {
    const packed = zlibSync(new Uint8Array(Float32Array.of(1, 2, 3).buffer));
    const file = (blocks: number[], bytes: Uint8Array) =>
      vtp(piece({ p: array('format="binary"', base64(...blocks) + btoa(String.fromCharCode(...bytes))) }), zlib);
    const good = file([1, 12, 0, packed.length], packed);
    expect((await read(good)).mesh.variables[0].values).toEqual(Float32Array.of(1, 2, 3));
    const flipped = packed.map((byte, index) => (index === packed.length - 1 ? byte ^ 1 : byte));
    await expectFault(file([1, 12, 0, packed.length], flipped), 'corrupt', '“p”');
    await expectFault(file([1, 12, 0, packed.length - 6], packed.subarray(0, -6)), 'corrupt', '“p”');
    await expectFault(file([1, 12, 0, 4], Uint8Array.of(1, 2, 3, 4)), 'corrupt', '“p”');
    await expectFault(file([1, 12, 0, 0], packed), 'corrupt', '“p”');
    await expectFault(file([0, 0, 12], packed), 'count_mismatch', '“p”');
    await expectFault(file([2 ** 32 - 1, 0, 12], packed), 'truncated', '“p”');
    await expectFault(file([1, 8, 0, packed.length], packed), 'count_mismatch', '8 bytes', 'needs 12');
    const longer = zlibSync(new Uint8Array(1000));
    await expectFault(file([1, 12, 0, longer.length], longer), 'corrupt', 'size');
  });

  it('refuses a zlib bomb before it unpacks it', async () => {
    const points = 2 ** 30;
    const block = zlibSync(new Uint8Array(1 << 20));
    const blocks = (12 * points) / (1 << 20);
    const words = [blocks, 1 << 20, 0, ...Array(100).fill(block.length)];
    const data = base64(...words) + btoa(String.fromCharCode(...block));
    const bomb = piece({
      counts: `NumberOfPoints="${points}" NumberOfPolys="1"`,
      points: `<DataArray type="Float32" NumberOfComponents="3" format="binary">${data}</DataArray>`,
    });
    await expectFault(vtp(bomb, zlib), 'too_large', '“Points”', '12 884 901 888 bytes');
  });

  it('in text is not compressed, whatever its head says', async () => {
    const file = vtp(piece(), 'type="PolyData" compressor="vtkLZMADataCompressor"');
    expect((await read(file)).mesh.variables[0].values).toEqual(Float32Array.of(1, 2, 3));
  });

  it('reads appended base64, and refuses offsets beyond it', async () => {
    const file = (offset: string) =>
      vtp(
        piece({ p: array(`format="appended" offset="${offset}"`, '') }),
        'type="PolyData"',
        `<AppendedData encoding="base64">\n _${base64(12)}${base64(0, 0, 0)}\n</AppendedData>`,
      );
    expect((await read(file('0'))).mesh.variables[0].values).toEqual(Float32Array.of(0, 0, 0));
    await expectFault(file('1000'), 'truncated', '“p”');
    await expectFault(file('-1'), 'bad_header', 'offset');
    await expectFault(file('0').replace('_', ''), 'corrupt', 'underscore');
  });

  it('that lost its end is refused although its arrays are whole', async () => {
    const whole = await writeSurface('vtp', smallMesh());
    await expectFault(whole.subarray(0, -4), 'truncated', '</VTKFile>');
  });

  it('cannot be written with names that XML cannot hold', async () => {
    const mesh = smallMesh([{ name: 'a\u0000b', components: 1, values: new Float32Array(4) }]);
    await expect(writeSurface('vtp', mesh)).rejects.toMatchObject({ code: 'bad_name' });
  });
});
