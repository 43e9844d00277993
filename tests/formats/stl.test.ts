import { describe, expect, it } from 'vitest';
import { readSurface } from '../../web/formats/read.ts';
import { lossesOf, writeSurface } from '../../web/formats/write.ts';
import { expectFault } from './faults.ts';
import { bytesOf, smallMesh } from './sample-mesh.ts';

const facet = 'facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 .1 0\n endloop\nendfacet\n';

describe('STL', () => {
  it('gives the surface back, welded', async () => {
    const mesh = smallMesh();
    const { mesh: back, notes } = await readSurface('mesh.stl', await writeSurface('stl', mesh));
    const places = (from: typeof mesh) =>
      Array.from(from.triangles, (point) => Array.from(from.position.subarray(3 * point, 3 * point + 3)));
    expect(back.position).toBeInstanceOf(Float32Array);
    expect(back.position.length).toBe(mesh.position.length);
    expect(places(back)).toEqual(places(mesh));
    expect(notes).toEqual(['5 repeated points welded.']);
  });

  it('is written with the normals of its facets', async () => {
    const file = await writeSurface('stl', {
      position: Float64Array.of(0, 0, 0, 2, 0, 0, 0, 2, 0),
      triangles: Uint32Array.of(0, 1, 2, 0, 0, 0),
      variables: [],
    });
    const view = new DataView(file.buffer);
    const normal = (index: number) => [0, 4, 8].map((at) => view.getFloat32(84 + 50 * index + at, true));
    expect([normal(0), normal(1)]).toEqual([
      [0, 0, 1],
      [0, 0, 0],
    ]);
    expect(file.length).toBe(84 + 50 * 2);
  });

  it('is read from text, in double precision, of several solids in any case', async () => {
    const text = `solid one\n${facet}endsolid one\nSOLID\n${facet.toUpperCase().replace('1 0 0', '1 0 1E0')}ENDSOLID\n`;
    const { mesh } = await readSurface('mesh.stl', bytesOf(text));
    expect(mesh.position).toEqual(Float64Array.of(0, 0, 0, 1, 0, 0, 0, 0.1, 0, 1, 0, 1));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 0, 3, 2]);
  });

  it('is read with the line breaks of any system', async () => {
    for (const lineBreak of ['\r\n', '\r']) {
      const text = `solid\n${facet.repeat(20_000)}endsolid\n`.replaceAll('\n', lineBreak);
      expect((await readSurface('mesh.stl', bytesOf(text))).mesh.triangles).toHaveLength(60_000);
      await expectFault(text.replace('1 0 0', '1 0'), 'bad_number', '(line 5)');
    }
  });

  it('is recognised in capitals', async () => {
    const { format, notes } = await readSurface('mesh', bytesOf(`SOLID\n${facet.toUpperCase()}ENDSOLID\n`));
    expect({ format, notes }).toEqual({ format: 'stl', notes: [] });
  });

  it('is told by its size although it begins with “solid”, and names colours as lost', async () => {
    const file = await writeSurface('stl', smallMesh());
    file.set(bytesOf('solid '));
    file[84 + 48] = 7;
    const { format, summary } = await readSurface('mesh', file);
    expect(format).toBe('stl');
    expect(summary).toContain('attributes of 1 facet.');
    const longer = await readSurface('mesh.stl', Uint8Array.of(...(await writeSurface('stl', smallMesh())), 1, 2));
    expect(longer.summary).toContain('2 bytes after the last facet passed over.');
  });

  it.each([
    ['without end', `solid\n${facet}`, 'truncated', '1 facet', 'endsolid'],
    ['with an open facet', `solid\n${facet.replace('endfacet', '')}endsolid`, 'truncated', '0 facets'],
    ['without facets', 'solid\nendsolid\n', 'no_triangles', 'no facets'],
    [
      'with four corners',
      `solid\n${facet.replace('endloop', 'vertex 1 1 1')}endsolid`,
      'bad_polygon',
      'Facet 0',
      '4 corners',
    ],
    ['with two coordinates', `solid\n${facet.replace('1 0 0', '1 0')}endsolid`, 'bad_number', 'line 5'],
    [
      'with a word for a number',
      `solid\n${facet.replace('1 0 0', '1 0 one')}endsolid`,
      'bad_number',
      '“one”',
      'line 5',
    ],
    [
      'with a facet inside another',
      `solid\n${facet.replace(' endloop\nendfacet\n', '')}${facet}endsolid`,
      'bad_header',
      'line 7',
    ],
    ['with one end of a facet too many', `solid\n${facet}endfacet\nendsolid`, 'bad_polygon', 'Facet 1', '0 corners'],
  ] as const)('in text %s is refused', async (_, text, code, ...words) => {
    await expectFault(text, code, ...words);
  });

  const square = facet + facet.replace('1 0 0', '0 1 0').replace('0 .1 0', '-1 0 0');

  it.each([
    ['a comment', `# by a mesher\n// of two\n; kinds\n! or more\nsolid x\n${square}endsolid x\n`],
    ['a long comment', `${'# remark\n'.repeat(2000)}solid x\n${square}endsolid x\n`],
    ['a byte order mark', `\u{FEFF}solid x\n${square}endsolid x\n`],
    ['empty lines', `\r\n\r\n\tsolid x\n${square}endsolid x\n`],
    ['no solid', square],
    ['a name of the words of facets', `solid facet of vertex\n${square}endsolid facet of vertex\n`],
    ['everything in one line', `solid x ${square}endsolid x`.replaceAll('\n', ' ')],
    ['several solids in one line', `solid x ${facet}endsolid x solid y ${facet}endsolid y`.replaceAll('\n', ' ')],
    ['capitals', `SOLID X\n${square.toUpperCase()}ENDSOLID X\n`],
    ['no normals', `solid\n${square.replaceAll(' normal 0 0 1', '')}endsolid\n`],
    ['normals that are no numbers', `solid\n${square.replaceAll('0 0 1', '-nan(ind) ? x')}endsolid\n`],
    ['a control character of DOS at its end', `solid\n${square}endsolid\n\u001A`],
    ['tabs', `solid\t x\n${square.replaceAll(' ', '\t')}endsolid\n`],
  ])('is read as text with %s', async (_, text) => {
    const { mesh, format, notes } = await readSurface('part', bytesOf(text));
    expect(format).toBe('stl');
    expect(mesh.triangles).toHaveLength(6);
    expect(Array.from(mesh.position.subarray(0, 6))).toEqual([0, 0, 0, 1, 0, 0]);
    expect(notes.filter((note) => !note.includes('welded') && !note.includes('passed over'))).toEqual([]);
  });

  it('names colours and unknown lines of a text as passed over', async () => {
    for (const place of ['solid x\n', 'solid x\nfacet normal 0 0 1\n']) {
      const text = `solid x\n${square}endsolid\n`.replace(place, `${place}color 0.5 0.5 0.5\n`);
      const { mesh, summary } = await readSurface('part', bytesOf(text));
      expect(mesh.triangles).toHaveLength(6);
      expect(summary).toContain('Not carried: colours.');
    }
    const { summary } = await readSurface('part', bytesOf(`solid x\n${square}colour red\ntag 7\ntag 8\nendsolid\n`));
    expect(summary).toContain('3 lines passed over that no STL file has, beginning with “colour”, “tag”.');
  });

  it('is read as binary whatever its head says and whatever follows', async () => {
    const file = await writeSurface('stl', smallMesh());
    const heads = [
      'solid part',
      'solid\nfacet normal 0 0 1\nouter loop\nvertex',
      '# a comment',
      '',
      'COLOR=',
      '{',
      'v 0 0 0',
    ];
    for (const head of heads) {
      for (const tail of [0, 1, 4, 49, 50, 51, 500]) {
        const bytes = new Uint8Array(file.length + tail);
        bytes.set(file);
        bytes.fill(32, 0, 80);
        bytes.set(bytesOf(head));
        bytes.fill(1, file.length);
        const { mesh, summary } = await readSurface('part.stl', bytes);
        expect(mesh.triangles, `${head} ${tail}`).toHaveLength(9);
        if (tail > 0) expect(summary).toContain(`${tail} byte${tail > 1 ? 's' : ''} after the last facet passed over.`);
      }
    }
  });

  it('of binary facets that the head does not count has them counted by its size', async () => {
    const file = await writeSurface('stl', smallMesh());
    file.fill(0, 80, 84);
    file.set(bytesOf('solid part'));
    const { mesh, summary } = await readSurface('part.stl', file);
    expect(mesh.triangles).toHaveLength(9);
    expect(summary).toContain('The header declares no facets, but 3 facets follow, which were read.');
    const longer = await readSurface('part.stl', Uint8Array.from([...file, 1, 2]));
    expect(longer.summary).toContain('2 bytes after the last facet');
    file.fill(255, 84);
    await expect(readSurface('part.stl', file)).rejects.toMatchObject({ code: 'no_triangles' });
  });

  it('in binary is refused where the header declares more than the file holds', async () => {
    const file = await writeSurface('stl', smallMesh());
    const read = (bytes: Uint8Array) => readSurface('mesh.stl', bytes);
    await expect(read(file.subarray(0, -1))).rejects.toMatchObject({ code: 'truncated' });
    await expect(read(file.subarray(0, 60))).rejects.toMatchObject({ code: 'truncated' });
    file.fill(255, 80, 84);
    await expect(read(file)).rejects.toMatchObject({
      code: 'truncated',
      message: expect.stringContaining('4 294 967 295 facets'),
    });
  });

  it('says beforehand what it cannot hold', async () => {
    const mesh = {
      ...smallMesh([{ name: 'p', components: 1, values: new Float32Array(4) }]),
      position: new Float64Array(12),
    };
    expect(await lossesOf('stl', mesh)).toEqual([
      'STL has no place for the variables “p”.',
      expect.stringContaining('rounded: “position”'),
    ]);
    expect(await lossesOf('vtp', mesh)).toEqual([]);
  });
});
