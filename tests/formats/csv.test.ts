import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { FormatError } from '../../web/formats/format-error.ts';
import { addVariables, readSurface } from '../../web/formats/read.ts';
import { writeSurface } from '../../web/formats/write.ts';
import { bytesOf, smallMesh } from './sample-mesh.ts';

const surface = await readSurface(
  'mesh.ply',
  await writeSurface('ply', smallMesh([{ name: 'q', components: 1, values: new Float32Array(4) }])),
);
const add = async (text: string) => {
  const { mesh, units, notes } = await addVariables(surface, bytesOf(text));
  const variables = mesh.variables
    .slice(1)
    .map(({ name, values }) => `${name} ${values.constructor.name} ${Array.from(values).join(' ')}`);
  return { variables, units: { ...units }, notes };
};

describe('a CSV file beside a surface', () => {
  it('adds variables, vectors among them, with units', async () => {
    const text =
      'p [Pa],"v:0 [m/s]",v:1 [m/s],"a ""b"", c"\r\n1,2,3,4\r\n5,6,7,8\r\n-0.1,nan,inf,1e3\r\n 0 , 0 ,0,0\r\n\r\n';
    expect(await add(text)).toEqual({
      variables: [
        'p Float64Array 1 5 -0.1 0',
        'v Float64Array 2 3 6 7 NaN Infinity 0 0',
        'a "b", c Float64Array 4 8 1000 0',
      ],
      units: { p: 'Pa', v: 'm/s' },
      notes: [],
    });
  });

  it('may name variables like what JavaScript has already', async () => {
    const { variables, units } = await add(`__proto__ [s],constructor\n${'1,2\n'.repeat(4)}`);
    expect(variables).toEqual(['__proto__ Float64Array 1 1 1 1', 'constructor Float64Array 2 2 2 2']);
    expect(Object.entries(units)).toEqual([['__proto__', 's']]);
  });

  it('may be separated by semicolons or tabs', async () => {
    for (const separator of [';', '\t']) {
      const text = ['p,x', '1,2', '3,4', '5,6', '7,8'].join('\n').replaceAll(',', separator);
      expect((await add(text)).variables).toEqual(['p Float64Array 1 3 5 7', 'x Float64Array 2 4 6 8']);
    }
  });

  it('may have a hundred thousand columns', async () => {
    const columns = Array.from({ length: 50_000 }, (_, i) => `c${i}_0,c${i}_1`).join(',');
    const row = Array(100_000).fill('1').join(',');
    expect((await add([columns, row, row, row, row].join('\n'))).variables).toHaveLength(50_000);
  });

  it('may be packed by gzip', async () => {
    const packed = new Uint8Array(gzipSync('p\n1\n2\n3\n4\n'));
    expect((await addVariables(surface, packed)).mesh.variables[1].values).toEqual(Float64Array.of(1, 2, 3, 4));
  });

  it('has units in the last brackets of a name, whatever stands before them', async () => {
    const spaces = ' '.repeat(100_000);
    const text = `p [a] [b],[c]d,e []${spaces},f${spaces}g\n${'1,2,3,4\n'.repeat(4)}`;
    const { variables, units } = await add(text);
    expect(variables.map((each) => each.slice(0, 6))).toEqual(['p [a] ', '[c]d F', 'e Floa', 'f     ']);
    expect(units).toEqual({ 'p [a]': 'b' });
  });

  it('cut anywhere is refused, or suspected', async () => {
    const text = 'p,r_0,r_1\n1.25,2,3\n4,5,6\n7,8,9\n10,11,12.75\n';
    for (let length = 0; length < text.length; length++) {
      const cut = await add(text.slice(0, length)).catch((error) => error);
      if (!(cut instanceof FormatError))
        expect(cut.notes).toContainEqual(expect.stringContaining('CSV file does not end'));
    }
    expect((await add(text)).notes).toEqual([]);
  });

  it('that is not UTF-8 is refused', async () => {
    const latin1 = Uint8Array.from('Wärme\n1\n2\n3\n4\n', (letter) => letter.charCodeAt(0));
    await expect(addVariables(surface, latin1)).rejects.toMatchObject({ code: 'bad_encoding' });
  });

  it('has its text columns and empty cells named', async () => {
    const { variables, notes } = await add('name,p\na,1\nb,\nc,3\nd,4\n');
    expect(variables).toEqual(['p Float64Array 1 NaN 3 4']);
    expect(notes).toEqual([
      'Not carried: the columns “name”, which are text.',
      '1 empty cell taken for “not a number”.',
    ]);
  });

  it.each([
    ['too few lines', 'p\n1\n2\n3\n', 'count_mismatch', '3 lines of values', '4 points'],
    ['too many lines', 'p\n1\n2\n3\n4\n5\n', 'count_mismatch', '5 lines'],
    ['nothing', '', 'count_mismatch', '0 lines'],
    ['a line too short', 'p,r\n1,2\n1,2\n1\n1,2\n', 'count_mismatch', '2 names', '1 cell', 'line 4'],
    ['a word among numbers', 'p\n1\n2\nthree\n4\n', 'bad_number', '“three”', 'column “p”, line 4'],
    ['one name twice', 'p,p\n1,2\n1,2\n1,2\n1,2\n', 'duplicate_name', '“p”', 'column 2'],
    ['a name that the surface has', 'q\n1\n2\n3\n4\n', 'duplicate_name', '“q”'],
    ['the name of the geometry', 'position\n1\n2\n3\n4\n', 'duplicate_name', '“position”'],
    ['the name that stands for all', '*\n1\n2\n3\n4\n', 'duplicate_name', '“*”', 'stands for all variables'],
    ['a column without name', 'p,\n1,2\n1,2\n1,2\n1,2\n', 'empty_name', 'column 2'],
  ])('with %s is refused', async (_, text, code, ...words) => {
    const error = await add(text).then(
      () => expect.fail('no error'),
      (thrown: Error) => thrown,
    );
    expect(error).toMatchObject({ name: 'FormatError', code });
    for (const word of words) expect(error.message).toContain(word);
  });
});
