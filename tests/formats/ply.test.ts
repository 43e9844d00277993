import { describe, expect, it } from 'vitest';
import { readSurface } from '../../web/formats/read.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { expectFault, faultOf } from './faults.ts';
import { faces, type PlyPart, plyFile, plyOrders, square } from './ply-file.ts';
import { awkwardDoubles, awkwardFloats, bits, bytesOf, smallMesh } from './sample-mesh.ts';

function withColumns(columns: Record<string, ArrayLike<number>>): PlyPart {
  const rows = square.rows.map((row, index) => [...row, ...Object.values(columns).map((column) => column[index])]);
  return { ...square, properties: [...square.properties, ...Object.keys(columns)], rows };
}

function variablesOf(mesh: { variables: { name: string; components: number }[] }) {
  return mesh.variables.map(({ name, components }) => `${name} ${components}`);
}

describe.each(plyOrders)('PLY, %s', (order) => {
  it('reads every type, integers in single precision where that is exact', async () => {
    const columns = {
      'char c': [-128, 127, 0, 1],
      'uchar uc': [0, 255, 7, 8],
      'short s': [-32768, 32767, 0, 1],
      'ushort us': [65535, 0, 1, 2],
      'int i': [-(2 ** 31), 2 ** 24, 0, 1],
      'int big': [2 ** 24 + 1, 0, 0, 0],
      'uint u': [2 ** 32 - 1, 0, 1, 2],
      'float f': awkwardFloats,
      'double d': awkwardDoubles,
    };
    const { mesh, notes, wholeTypes } = await readSurface('', plyFile(order, [withColumns(columns), faces([0, 1, 2])]));
    const expected = Object.entries(columns).map(([property, values]) => {
      const [type, name] = property.split(' ');
      const double = ['big', 'u', 'd'].includes(name) && type !== 'float';
      return `${name} ${bits(double ? Float64Array.from(values) : Float32Array.from(values))}`;
    });
    expect(mesh.variables.map(({ name, values }) => `${name} ${bits(values)}`)).toEqual(expected);
    expect(wholeTypes).toMatchObject({ big: 'int32', u: 'uint32' });
    expect(wholeTypes).not.toHaveProperty('f');
    expect(notes).toEqual([expect.stringMatching(/^Taken for identifiers.*: “big”;/)]);
  });

  it('reads positions in double, in whole numbers and of mixed types', async () => {
    const at = async (types: string[]) => {
      const vertex = { ...square, properties: types.map((type, axis) => `${type} ${'xyz'[axis]}`) };
      return (await readSurface('', plyFile(order, [vertex, faces([0, 1, 2])]))).mesh.position.constructor;
    };
    expect(await at(['double', 'double', 'double'])).toBe(Float64Array);
    expect(await at(['float', 'double', 'float'])).toBe(Float64Array);
    expect(await at(['short', 'short', 'short'])).toBe(Float32Array);
  });

  it('splits polygons into triangles, says so, and keeps their orientation', async () => {
    const pentagon: PlyPart = {
      ...square,
      rows: [
        [0, 0, 0],
        [2, 0, 0],
        [2, 2, 0],
        [1, 0.5, 0],
        [0, 2, 0],
      ],
    };
    const { mesh, notes } = await readSurface(
      '',
      plyFile(order, [pentagon, faces([0, 1, 2, 3, 4], [0, 1, 3], [4, 3, 2, 1, 0])]),
    );
    expect(mesh.triangles.length / 3).toBe(3 + 1 + 3);
    expect(notes).toEqual(['2 faces with more than three corners split into triangles.']);
    expect(Array.from(mesh.triangles.subarray(9, 12))).toEqual([0, 1, 3]);
    const areas = Array.from({ length: 7 }, (_, face) => signedArea(mesh, face));
    // The pentagon is concave at point 3: a fan from point 0 would cover its outside.
    expect(areas.every((area, face) => (face < 4 ? area > 0 : area < 0))).toBe(true);
    expect(areas.slice(0, 3).reduce((a, b) => a + b)).toBeCloseTo(2.5);
    expect(areas.slice(4).reduce((a, b) => a + b)).toBeCloseTo(-2.5);
  });

  it('reads triangle strips', async () => {
    const strips: PlyPart = {
      name: 'tristrips',
      properties: ['list int int vertex_indices'],
      rows: [[[0, 1, 3, 2, -1, 2, 1, 0, -1]]],
    };
    const { mesh, notes } = await readSurface('', plyFile(order, [square, strips]));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 3, 1, 2, 3, 2, 1, 0]);
    expect(notes).toEqual(['2 triangle strips taken apart into triangles.']);
  });

  it('names what it does not carry', async () => {
    const parts: PlyPart[] = [
      {
        ...square,
        properties: [...square.properties, 'list uchar int ring'],
        rows: square.rows.map((row, i) => [...row, Array(i).fill(i)]),
      },
      { name: 'nothing', properties: [], rows: [[], []] },
      {
        name: 'face',
        properties: [
          'uchar red',
          'list uchar uint vertex_index',
          'list uchar float texcoord',
          'list uchar int vertex_indices',
        ],
        rows: [[9, [0, 1, 2], [0.5, 1], [2, 1]]],
      },
      { name: 'edge', properties: ['int vertex1', 'int vertex2'], rows: [[0, 1]] },
    ];
    const comments = ['comment TextureFile wood.png', 'comment by hand'];
    const { mesh, summary } = await readSurface('', plyFile(order, parts, comments));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2]);
    for (const name of [
      'textures “wood.png”',
      '“ring”',
      '“red”',
      '“texcoord”',
      '“vertex_indices”',
      '“edge” (1 row)',
      '“nothing” (2 rows)',
    ])
      expect(summary).toContain(name);
  });

  it('reads faces that stand before the vertices', async () => {
    const { mesh } = await readSurface('', plyFile(order, [faces([0, 1, 2, 3]), square]));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3]);
  });

  it('says where the file ends too early', async () => {
    const whole = plyFile(order, [square, faces([0, 1, 2], [0, 2, 3])]);
    await expectFault(whole.subarray(0, -8), 'truncated');
    await expectFault(plyFile(order, [faces([0, 1, 2]), square]).subarray(0, -2), 'truncated', 'vertex');
  });

  it.each<[string, number[], ...string[]]>([
    ['beyond the points', [0, 1, 4], 'Face 1', 'point 4', '4 points (0 to 3)'],
    ['negative', [0, -1, 2], 'Face 1', 'point -1'],
  ])('refuses an index %s', async (_, corners, ...words) => {
    await expectFault(plyFile(order, [square, faces([0, 1, 2], corners)]), 'bad_index', ...words);
  });

  it.each([0, 1, 2])('leaves a face of %i corners out, and counts it', async (corners) => {
    const short = [0, 1].slice(0, corners);
    const rows = [[0, 1, 2], short, [0, 1, 2, 3], short].map((row, i) => [row, 10 + i]);
    const face = { ...faces(), properties: [...faces().properties, 'int part'], rows };
    const { mesh, notes, regions } = await readSurface('', plyFile(order, [square, face]));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 1, 2, 0, 2, 3]);
    expect(notes).toContain('2 faces with fewer than three corners left out.');
    expect(regions?.get('part')).toEqual(Int32Array.of(10, 12, 12));
    await expectFault(plyFile(order, [square, faces(short)]), 'no_triangles', 'no faces');
  });

  it('does not ask whether the points of a face exist that is none', async () => {
    const { mesh } = await readSurface('', plyFile(order, [square, faces([0, 9], [0, 1, 2])]));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2]);
  });

  it('ends strips with the largest index, too, where indices have no sign', async () => {
    const strips = {
      name: 'tristrips',
      properties: ['list uint uint vertex_indices'],
      rows: [[[0, 1, 3, 2, 2 ** 32 - 1, 2, 1, 0, 2 ** 32 - 1]]],
    };
    const { mesh } = await readSurface('', plyFile(order, [square, strips]));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 3, 1, 2, 3, 2, 1, 0]);
  });

  it('refuses lists of negative length', async () => {
    const file = plyFile('ascii', [square]);
    const text = `${new TextDecoder().decode(file).replace('end_header', 'element face 1\nproperty list char int vertex_index\nend_header')}-1 0 1`;
    await expectFault(text, 'bad_polygon', 'face 0', '-1');
  });

  it('refuses files without points or triangles', async () => {
    await expectFault(plyFile(order, [square]), 'no_triangles', '4 points');
    await expectFault(plyFile(order, [square, faces()]), 'no_triangles');
    await expectFault(plyFile(order, [faces([0, 1, 2])]), 'no_points', 'vertex');
    await expectFault(plyFile(order, [{ ...square, rows: [] }, faces()]), 'no_points', 'The file has no points.');
    const flat = { ...square, properties: ['float x', 'float y'], rows: [[0, 0]] };
    await expectFault(plyFile(order, [flat, faces([0, 0, 0])]), 'no_points', 'x, y and z');
  });

  it('reads units, and passes over comments that only look like them', async () => {
    const comments = [
      'unit p Pa',
      'unit position mm',
      'unit unknown kg',
      'unit',
      'unit "p',
      'variable "q" missing',
      'variable "p"',
      'units are SI',
    ];
    const lines = comments.map((comment) => `comment ${comment}`);
    const { units, mesh } = await readSurface(
      '',
      plyFile(order, [withColumns({ 'float p': [1, 2, 3, 4] }), faces([0, 1, 2])], lines),
    );
    expect({ ...units }).toEqual({ p: 'Pa', position: 'mm' });
    expect(variablesOf(mesh)).toEqual(['p 1']);
  });
});

describe('PLY comments in another encoding', () => {
  const latin1 = (...comments: string[]) => {
    const lines = comments.map((comment) => `comment ${comment}`);
    const file = plyFile('ascii', [withColumns({ 'float p': [1, 2, 3, 4] }), faces([0, 1, 2])], lines);
    return file.map((byte) => (byte === 64 ? 0xb0 : byte));
  };

  it('are passed over', async () => {
    const { units } = await readSurface('', latin1('by M@ller', 'unit tests by M@ller', 'unit p Pa'));
    expect({ ...units }).toEqual({ p: 'Pa' });
  });

  it.each(['unit p @C', 'variable "@" p', 'components "p" ["@"]'])('that are “%s” are refused', async (comment) => {
    await expectFault(latin1(comment), 'bad_encoding', 'comment', 'UTF-8');
  });

  it('are no other encoding because they have its mark', async () => {
    const mark = { name: 'p', components: 1, values: Float32Array.of(1, 2, 3, 4) };
    const file = await writeSurface('ply', smallMesh([mark]), { units: { p: '\u{FFFD}' } });
    expect((await readSurface('', file)).units.p).toBe('\u{FFFD}');
  });
});

describe('PLY variables', () => {
  const read = async (...properties: string[]) => {
    const columns = Object.fromEntries(properties.map((property) => [`float ${property}`, [1, 2, 3, 4]]));
    return variablesOf((await readSurface('', plyFile('ascii', [withColumns(columns), faces([0, 1, 2])]))).mesh);
  };

  it('are vectors where the names say so', async () => {
    expect(await read('nx', 'ny', 'nz', 'red', 'green', 'blue')).toEqual(['normal 3', 'color 3']);
    expect(await read('blue', 'alpha', 'red', 'green')).toEqual(['color 4']);
    expect(await read('velocity_x', 'velocity_y', 'velocity_z', 't_0', 't_1')).toEqual(['velocity 3', 't 2']);
    expect(await read('s_1', 's_0', 's_2', 's_3', 's_4', 's_5')).toEqual(['s 6']);
  });

  it('are scalars otherwise', async () => {
    expect(await read('vx', 'vy', 'vz')).toEqual(['vx 1', 'vy 1', 'vz 1']);
    expect(await read('v_x', 'v_y', 'w_0', 'u_1', 'u_2')).toEqual(['v_x 1', 'v_y 1', 'w_0 1', 'u_1 1', 'u_2 1']);
    expect(await read('nx', 'ny', 'red', 'green', 'alpha')).toEqual(['nx 1', 'ny 1', 'red 1', 'green 1', 'alpha 1']);
    expect(await read('a', 'a_x', 'a_y', 'a_z')).toEqual(['a 1', 'a_x 1', 'a_y 1', 'a_z 1']);
  });

  it('keep components in order whatever the order of the properties', async () => {
    const columns = { 'float v_z': [3, 3, 3, 3], 'float v_x': [1, 1, 1, 1], 'float v_y': [2, 2, 2, 2] };
    const { mesh } = await readSurface('', plyFile('binary_big_endian', [withColumns(columns), faces([0, 1, 2])]));
    expect(Array.from(mesh.variables[0].values.subarray(0, 3))).toEqual([1, 2, 3]);
  });
});

describe('PLY in ASCII', () => {
  const withValue = (token: string) =>
    `ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty double p\n` +
    `element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 ${token}\n1 0 0 1\n0 1 0 1\n3 0 1 2\n`;
  const readValue = async (token: string) =>
    (await readSurface('', bytesOf(withValue(token)))).mesh.variables[0].values[0];

  it.each(['nan', '-nan', 'NaN', 'nan(ind)', '-nan(snan)', '1.#QNAN', '-1.#IND', '1.#IND00'])(
    'reads %s as NaN',
    async (token) => {
      expect(await readValue(token)).toBeNaN();
    },
  );

  it.each(['inf', '+Inf', 'INFINITY', '1.#INF'])('reads %s as infinity', async (token) => {
    expect(await readValue(token)).toBe(Infinity);
    expect(await readValue(`-${token.replace('+', '')}`)).toBe(-Infinity);
  });

  it.each([
    '1',
    '-1.5',
    '+2',
    '.5',
    '5.',
    '-0',
    '1e3',
    '1E-300',
    '0.1',
    '123456789012345678',
    '0.30000000000000004',
    '000000000000000000001',
    '1e400',
  ])('reads %s as C does', async (token) => {
    expect(await readValue(token)).toBe(Number(token));
  });

  it.each(['abc', '0x10', '1,5', '1e', '--1', '.', '-', '1_000', '∞', '1'.repeat(2000)])(
    'refuses %s',
    async (token) => {
      await expectFault(withValue(token), 'bad_number', 'vertex 0');
    },
  );

  it('reads line breaks of every system', async () => {
    for (const lineBreak of ['\r\n', '\r']) {
      const { mesh } = await readSurface('', bytesOf(withValue('7').replaceAll('\n', lineBreak)));
      expect(mesh.variables[0].values[0]).toBe(7);
    }
  });

  it('reads a header whose lines end in different ways', async () => {
    const binary = plyFile('binary_little_endian', [
      { ...square, rows: square.rows.map(([x, y, z]) => [x, y, z]) },
      faces([0, 1, 2]),
    ]);
    const headEnd = new TextDecoder('latin1').decode(binary).indexOf('end_header\n') + 'end_header\n'.length;
    const lines = new TextDecoder().decode(binary.subarray(0, headEnd)).trimEnd().split('\n');
    for (const [breaks, last] of [
      [['\r\n'], '\n'],
      [['\n'], '\r\n'],
      [['\n', '\r\n', '\r'], '\n'],
      [['\r', '\n'], '\r\n'],
      [['\r'], '\r'],
      [['\r'], '\n'],
    ] as const) {
      const [head, end] = [lines.slice(0, -1), lines.at(-1)];
      const text = head.map((line, i) => `${line}${breaks[i % breaks.length]}`).join('') + end + last;
      const file = Uint8Array.from([...bytesOf(text), ...binary.subarray(headEnd)]);
      expect((await readSurface('', file)).mesh.triangles, JSON.stringify([breaks, last])).toEqual(
        Uint32Array.of(0, 1, 2),
      );
    }
  });

  it('says when the last number may have been cut', async () => {
    const { notes } = await readSurface('', bytesOf(withValue('7').trimEnd()));
    expect(notes).toEqual([expect.stringContaining('line break')]);
  });

  it('says when there is more than the header declares', async () => {
    const { notes } = await readSurface('', bytesOf(`${withValue('7')}3 0 1 2\n`));
    expect(notes).toEqual([expect.stringMatching(/8 bytes after the last element/)]);
  });
});

describe('rows of an ASCII PLY file', () => {
  const head = (...elements: string[]) => ['ply', 'format ascii 1.0', ...elements, 'end_header', ''].join('\n');
  const points = 'element vertex 4\nproperty float x\nproperty float y\nproperty float z';
  const faceList = 'element face 2\nproperty list uchar int vertex_indices';
  const places = ['0 0 0', '1 0 0', '1 1 0', '0 1 0'];
  const read = async (header: string, ...lines: string[]) =>
    readSurface('', bytesOf(`${header}${lines.map((line) => `${line}\n`).join('')}`));

  it('may lie in their lines anyhow', async () => {
    const tokens = [...places, '3 0 1 2', '3 0 2 3'];
    const ways = [
      tokens.map((row) => `  ${row}\t `), // blanks
      tokens.flatMap((row) => [row, '', ' ']), // empty lines
      tokens.flatMap((row) => row.split(' ')), // a number a line
      tokens.map((row) => row.replace(' ', '\r\n')), // two lines a row
      [tokens.join(' ')], // all in one
      [tokens.slice(0, 4).join(' '), tokens.slice(4).join('  ')], // an element a line
    ];
    for (const lines of ways) {
      const { mesh, notes } = await read(head(points, faceList), ...lines);
      expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3]);
      expect(notes).toEqual([]);
    }
  });

  it('are read line by line where they have more numbers than declared', async () => {
    const flagged = `${faceList}\nproperty uchar flag`;
    for (const [header, lines, words] of [
      [head(points, flagged), [...places, '3 0 1 2 5 3 0', '3 0 2 3 5 3 0'], '2 lines have'],
      [head(points, faceList), [...places, '3 0 1 2 3 1 2 3', '3 0 2 3 3 1 2 3'], '2 lines have'],
      [head(points, faceList), [...places.map((row) => `${row} 1`), '3 0 1 2', '3 0 2 3'], '4 lines have'],
      [head(points, faceList), [...places, '', '3 0 1 2', '', '3 0 2 3 7'], '2 bytes after the last element'],
      [head(points, faceList), [...places, '3 0 1 2 # red', '3 0 2 3'], '1 line has'],
      [head(points, faceList), [...places.with(3, '0 1 0 3 0 1 2'), '3 0 1 2', '3 0 2 3'], '1 line has'],
      [
        head(points, flagged, 'element edge 1\nproperty int a'),
        [...places, '3 0 1 2 5 4', '3 0 2 3 5', '1'],
        '1 line has',
      ],
    ] as const) {
      const { mesh, summary } = await read(header, ...lines);
      expect(Array.from(mesh.triangles), lines.join('|')).toEqual([0, 1, 2, 0, 2, 3]);
      expect(Array.from(mesh.position)).toEqual([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
      expect(summary, lines.join('|')).toContain(words);
    }
  });

  it('are refused by their line where neither numbers nor lines fit', async () => {
    for (const [lines, line] of [
      // Two lines a row, one number too many.
      [[...places.map((row) => row.replace(' ', '\n')), '3 0\n1 2 7', '3 0\n2 3'], 'line 19'],
      // One row too short, another one too long.
      [[...places.with(1, '1 0'), '3 0 1 2 0', '3 0 2 3'], 'line 12'],
      // All faces in one line, which has too much.
      [[...places, '3 0 1 2 9 3 0 2 3'], 'line 14'],
    ] as const) {
      const { message } = await faultOf(`${head(points, faceList)}${lines.join('\n')}\n`);
      expect(message).toContain(line);
    }
  });
});

describe('a PLY header', () => {
  const body = '\nend_header\n0 0 0\n';
  const vertex = 'element vertex 1\nproperty float x\nproperty float y\nproperty float z';
  it.each([
    ['no end', `ply\nformat ascii 1.0\n${vertex}`, 'truncated', 'end_header'],
    ['no format', `ply\n${vertex}${body}`, 'bad_header', 'format'],
    [
      'an unknown format',
      `ply\nformat binary_middle_endian 1.0\n${vertex}${body}`,
      'bad_header',
      'binary_middle_endian',
    ],
    ['an unknown type', `ply\nformat ascii 1.0\n${vertex}\nproperty quad q${body}`, 'bad_header', 'quad', 'line 7'],
    ['a list without types', `ply\nformat ascii 1.0\n${vertex}\nproperty list int q${body}`, 'bad_header', 'line 7'],
    [
      'a list of fractional length',
      `ply\nformat ascii 1.0\n${vertex}\nproperty list float int q${body}`,
      'bad_header',
      'float',
    ],
    ['a property of nothing', `ply\nformat ascii 1.0\nproperty float x${body}`, 'bad_header', 'line 3'],
    ['an unknown line', `ply\nformat ascii 1.0\nvertices 3${body}`, 'bad_header', 'vertices 3'],
    ['a negative count', `ply\nformat ascii 1.0\nelement vertex -1${body}`, 'bad_header', 'count'],
    ['a fractional count', `ply\nformat ascii 1.0\nelement vertex 1.5${body}`, 'bad_header', 'count'],
    ['one property twice', `ply\nformat ascii 1.0\n${vertex}\nproperty int x${body}`, 'duplicate_name', '“x”'],
    ['one element twice', `ply\nformat ascii 1.0\n${vertex}\n${vertex}${body}`, 'duplicate_name', '“vertex”'],
  ] as const)('with %s is refused', async (_, file, code, ...words) => {
    await expectFault(file, code, ...words);
  });

  it('with a name that is not UTF-8 is refused', async () => {
    const text = `ply\nformat ascii 1.0\n${vertex}\nproperty float q#${body}`;
    await expectFault(
      bytesOf(text).map((byte) => (byte === 35 ? 0xff : byte)),
      'bad_encoding',
      'line 7',
    );
  });

  it.each(['4294967295', '4000000000', '999999999999999'])(
    'that declares %s of anything is refused at once',
    async (count) => {
      for (const order of plyOrders) {
        const head = `ply\nformat ${order} 1.0\n`;
        await expectFault(`${head}${vertex.replace('vertex 1', `vertex ${count}`)}${body}`, 'truncated', '“vertex”');
        await expectFault(
          `${head}element face ${count}\nproperty list uchar int vertex_index${body}`,
          'truncated',
          '“face”',
        );
        await expectFault(`${head}element nothing ${count}${body}`, 'no_points');
      }
    },
  );

  it('that declares a huge list is refused at once', async () => {
    const list = `element face 1\nproperty list uint int vertex_index${body.replace('0 0 0', '')}`;
    await expectFault(`ply\nformat ascii 1.0\n${list}4294967295 0 1 2`, 'truncated', 'face 0', '4 294 967 295 items');
    const binary = bytesOf(`ply\nformat binary_little_endian 1.0\n${list.trimEnd()}\n`);
    await expectFault(
      Uint8Array.of(...binary, 255, 255, 255, 255, 0, 0, 0, 0),
      'truncated',
      'face 0',
      '4 294 967 295 items',
    );
  });
});

function signedArea(
  { position, triangles }: { position: ArrayLike<number>; triangles: Uint32Array },
  face: number,
): number {
  const [a, b, c] = triangles.subarray(3 * face, 3 * face + 3);
  const edge = (from: number, to: number) => [0, 1].map((axis) => position[3 * to + axis] - position[3 * from + axis]);
  const [u, v] = [edge(a, b), edge(a, c)];
  return (u[0] * v[1] - u[1] * v[0]) / 2;
}
