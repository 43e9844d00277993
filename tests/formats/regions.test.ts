import { describe, expect, it } from 'vitest';
import { readSurface } from '../../web/formats/read.ts';
import { lossesOf } from '../../web/formats/write.ts';
import { expectFault } from './faults.ts';
import { plyFile, plyOrders, square } from './ply-file.ts';
import { bytesOf, smallMesh } from './sample-mesh.ts';

const vtpTypes = { int: 'Int32', long: 'Int64', float: 'Float32', double: 'Float64' };

interface Cells {
  /** As legacy VTK has them, a cell a line: the number of corners, then the corners. */
  polygons?: string[];
  /** Values of a line, which is a cell too, then of the polygons. */
  values?: number[];
  type?: keyof typeof vtpTypes;
}

const both = ['4 0 1 2 3', '3 0 3 4'];

/** A line, a square and a triangle, in text. */
function legacyVtk({ polygons = both, values = [9, 1, -2], type = 'int' }: Cells): string {
  const numbers = polygons.reduce((sum, polygon) => sum + polygon.split(' ').length, 0);
  return [
    ...['# vtk DataFile Version 3.0', 'title', 'ASCII', 'DATASET POLYDATA'],
    ...['POINTS 5 float', '0 0 0 1 0 0 1 1 0 0 1 0 -1 1 0', 'LINES 1 3', '2 0 1'],
    ...[`POLYGONS ${polygons.length} ${numbers}`, ...polygons],
    ...[`CELL_DATA ${values.length}`, `SCALARS part ${type}`, 'LOOKUP_TABLE default', values.join(' ')],
  ].join('\n');
}

function vtp({ polygons = both, values = [9, 1, -2], type = 'int' }: Cells): string {
  const array = (kind: string, name: string, numbers: unknown[]) =>
    `<DataArray type="${kind}" Name="${name}" format="ascii">${numbers.join(' ')}</DataArray>`;
  const rows = polygons.map((polygon) => polygon.split(' ').slice(1));
  const ends = rows.map((_, i) => rows.slice(0, i + 1).flat().length);
  const cells = (tag: string, corners: unknown[], offsets: unknown[]) =>
    `<${tag}>${array('Int64', 'connectivity', corners)}${array('Int64', 'offsets', offsets)}</${tag}>`;
  const points =
    '<DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 1 1 0 0 1 0 -1 1 0</DataArray>';
  const labels = array(vtpTypes[type], 'part', values);
  const counts = `NumberOfPoints="5" NumberOfLines="1" NumberOfPolys="${rows.length}"`;
  return `<?xml version="1.0"?>\n<VTKFile type="PolyData"><PolyData><Piece ${counts}><Points>${points}</Points><CellData>${labels}</CellData>${cells('Lines', [0, 1], [2])}${cells('Polys', rows.flat(), ends)}</Piece></PolyData></VTKFile>`;
}

describe.each([
  ['vtk', legacyVtk],
  ['vtp', vtp],
] as const)('cell data of whole numbers, %s', (_, file) => {
  const read = (cells: Cells) => readSurface('', bytesOf(file(cells)));

  it('are labels of the triangles that the polygons are split into', async () => {
    const { mesh, regions } = await read({});
    expect(mesh.triangles).toHaveLength(9);
    expect(regions).toEqual(new Map([['part', Int32Array.of(1, 1, -2)]]));
  });

  it('are said to be lost in words that fit the page and every command', async () => {
    const { notes } = await read({});
    expect(notes).toContain('Not carried: cell data “part”.');
    expect(notes.join(' ')).not.toContain('--');
  });

  it.each(['long', 'float', 'double'] as const)('are labels of whatever type they are stored in, %s', async (type) => {
    const { regions, unfitRegions } = await read({ values: [9, 2 ** 24, -2], type });
    expect(regions).toEqual(new Map([['part', Int32Array.of(2 ** 24, 2 ** 24, -2)]]));
    expect(unfitRegions?.size).toBe(0);
  });

  it.each<[string, Cells, string]>([
    ['fractions', { values: [9, 1, 0.5], type: 'float' }, 'cell 2, counted from 0, has 0.5'],
    ['fractions of lines', { values: [0.25, 1, 0.5], type: 'double' }, 'cell 0, counted from 0, has 0.25'],
    ['no numbers', { values: [9, Number.NaN, 1], type: 'double' }, 'cell 1, counted from 0, has NaN'],
    [
      'numbers of more than 32 bits',
      { values: [9, 2 ** 31, 1], type: 'long' },
      'cell 1, counted from 0, has 2147483648',
    ],
  ])('are none where they are %s', async (_what, cells, misfit) => {
    const { regions, unfitRegions, summary } = await read(cells);
    expect([...(regions?.keys() ?? [])]).toEqual([]);
    expect([...(unfitRegions ?? [])]).toEqual([['part', `${misfit}, which is no whole number of 32 bits`]]);
    expect(summary).toMatch(/Not carried: cell data “part”; 1 line\..*Cell Data to Point Data/);
  });

  it('stay with their triangles where polygons have too few corners', async () => {
    const { mesh, regions, notes } = await read({
      polygons: ['1 0', '3 0 1 2', '2 0 1', '4 0 1 2 3', '0'],
      values: [9, 1, 2, 3, 4, 5],
    });
    expect(mesh.triangles).toHaveLength(9);
    expect(regions).toEqual(new Map([['part', Int32Array.of(2, 4, 4)]]));
    expect(notes).toContain('3 polygons with fewer than three corners left out.');
    await expectFault(file({ polygons: ['1 0', '1 1'] }), 'no_triangles', 'no polygons');
  });
});

it('cell data of a legacy VTK file for more cells than there are are no labels', async () => {
  const { regions, summary } = await readSurface('', bytesOf(legacyVtk({ values: [9, 1, -2, 4] })));
  expect(regions?.size).toBe(0);
  expect(summary).toContain('Not carried: cell data “part”; 1 line.');
});

describe.each(plyOrders)('face properties of whole numbers, PLY, %s', (order) => {
  const properties = [
    'char part',
    'list uchar int vertex_indices',
    'uchar red',
    'uchar green',
    'uchar blue',
    'float heat',
  ];
  const read = (heat: number, more: Parameters<typeof plyFile>[1] = []) => {
    const rows = [
      [-3, [0, 1, 2, 3], 1, 2, 3, heat],
      [5, [0, 1, 2], 4, 5, 6, 0],
    ];
    return readSurface('', plyFile(order, [square, { name: 'face', properties, rows }, ...more]));
  };

  it('are labels of the triangles that the faces are split into; colours and fractions are none', async () => {
    const { regions, unfitRegions, notes } = await read(0.5);
    expect(unfitRegions?.get('heat')).toBe('face 0, counted from 0, has 0.5, which is no whole number of 32 bits');
    expect(regions).toEqual(new Map([['part', Int32Array.of(-3, -3, 5)]]));
    expect(notes).toContain('Not carried: the face properties “red”, “green”, “blue”, “heat”.');
    expect(notes).toContain('Not carried: cell data “part”.');
    expect([...((await read(8)).regions?.keys() ?? [])]).toEqual(['part', 'heat']);
  });

  it('are none beside strips, whose triangles have no faces', async () => {
    const strips = { name: 'tristrips', properties: ['list int int vertex_indices'], rows: [[[0, 1, 2, -1]]] };
    const { regions, notes } = await read(0.5, [strips]);
    expect(regions?.size).toBe(0);
    expect(notes.join()).toContain('the face properties “red”, “green”, “blue”, “part”, “heat”');
  });
});

it('a format without a place for labels of triangles says so', async () => {
  const mesh = { ...smallMesh(), regions: Int32Array.of(1, 2, 3) };
  for (const format of ['vtp', 'vtk', 'ply'] as const) expect(await lossesOf(format, mesh)).toEqual([]);
  expect(await lossesOf('obj', mesh)).toEqual(['OBJ has no place for the regions.']);
  expect((await lossesOf('glb', mesh)).join()).toContain('has no place for the regions.');
  const cellData = new Map([['part', Int32Array.of(1, 2, 3)]]);
  for (const format of ['vtp', 'vtk', 'ply'] as const)
    expect(await lossesOf(format, smallMesh(), { cellData })).toEqual([]);
  expect(await lossesOf('obj', smallMesh(), { cellData })).toEqual(['OBJ has no place for the cell data “part”.']);
});
