import type { Polygons } from '../faces/polygons.ts';
import { FormatError } from '../format-error.ts';
import { counted, grouped, quoted } from '../text/wording.ts';
import { asEnds, asIndices } from '../vtk-data/vtk-pieces.ts';
import type { VtkValues } from '../vtk-data/vtk-values.ts';
import type { LegacyVtkText } from './legacy-vtk-text.ts';
import { countOf, typeOf } from './legacy-vtk-words.ts';

/** Cells are lists with their lengths in one array, from version 5 on two arrays of ends and corners. */
export function readCells(words: string[], text: LegacyVtkText, version: number): Polygons {
  const [first, second] = [countOf(words[1], text), countOf(words[2], text)];
  const where = `array “${words[0].toUpperCase()}”`;
  if (version < 5) return splitLists(text.numbers('Int32', second, where), first, where);
  const read = (keyword: string, count: number) => {
    const [found = '', type] = text.words();
    if (found.toUpperCase() === keyword) return text.numbers(typeOf(type, text), count, `${where}, ${keyword}`);
    const message = `${quoted(found)} stands where ${keyword} should (${text.place()}).`;
    throw new FormatError(text.atEnd() ? 'truncated' : 'bad_header', message, text.place());
  };
  const offsets = asEnds(read('OFFSETS', first), `${where}, OFFSETS`);
  const corners = asIndices(read('CONNECTIVITY', second), `${where}, CONNECTIVITY`);
  const last = offsets.at(-1) ?? 0;
  if ((offsets[0] ?? 0) !== 0 || last !== corners.length) {
    const message = `The OFFSETS of the ${where} should run from 0 to ${grouped(corners.length)}.`;
    throw new FormatError('count_mismatch', message, where);
  }
  return { corners, ends: offsets.slice(1) };
}

function splitLists(values: VtkValues, count: number, where: string): Polygons {
  if (count > values.length) {
    throw new FormatError('count_mismatch', `The ${where} has more cells than numbers.`, where);
  }
  const ends = new Uint32Array(count);
  const corners = new Float64Array(values.length - count);
  let [from, to] = [0, 0];
  for (let cell = 0; cell < count; cell++) {
    const length = values[from];
    if (!(Number.isInteger(length) && length >= 0 && from + 1 + length <= values.length)) {
      const message = `Cell ${cell} of the ${where} claims ${length} corners, which do not fit.`;
      throw new FormatError('bad_polygon', message, where);
    }
    for (let corner = 1; corner <= length; corner++) corners[to++] = values[from + corner];
    from += 1 + length;
    ends[cell] = to;
  }
  if (from === values.length) return { corners: asIndices(corners, where), ends };
  const message = `The ${where} has ${counted(values.length, 'number')}, but its cells take ${grouped(from)}.`;
  throw new FormatError('count_mismatch', message, where);
}
