import { FormatError } from './format-error.ts';
import { GrowingNumbers } from './growing-arrays.ts';
import { isBinaryStl } from './recognise.ts';
import type { Surface } from './surface.ts';
import { numbersFrom, type TextLine, textLines } from './text-lines.ts';
import { weldedSurface } from './welded-surface.ts';
import { counted, grouped, quoted } from './wording.ts';

// Written by hand although three.js has an STLLoader: that one reads a text that lost its end as an empty mesh, passes over
// corners that it cannot read, and allocates whatever a binary header declares.

const headSize = 84;
const facetSize = 50;
const normalSize = 12;
const cornersSize = 36;

function facetCount(bytes: Uint8Array): number {
  return new DataView(bytes.buffer, bytes.byteOffset).getUint32(headSize - 4, true);
}

/**
 * Reads an STL file, binary (single precision) or text (double, since text has no precision of its own). STL knows no
 * shared points: those of the same place are welded. It carries no variables; the normals of its facets follow from their corners.
 */
export function readStl(bytes: Uint8Array): Surface {
  const isText =
    !isBinaryStl(bytes) && /^\s*solid\b/i.test(new TextDecoder('latin1').decode(bytes.subarray(0, headSize)));
  const notes: string[] = [];
  const position = isText ? readText(bytes) : readBinary(bytes, notes);
  if (position.length === 0) throw new FormatError('no_triangles', 'The file has no facets.');
  return weldedSurface(
    { position, triangles: new Uint32Array(position.length / 3).map((_, i) => i), variables: [] },
    notes,
  );
}

function readBinary(bytes: Uint8Array, notes: string[]): Float32Array {
  const facets = bytes.length < headSize ? 0 : facetCount(bytes);
  const needed = headSize + facetSize * facets;
  if (bytes.length < needed) {
    const message = `The header declares ${counted(facets, 'facet')}, ${grouped(needed)} bytes, but the file has ${grouped(bytes.length)}.`;
    throw new FormatError('truncated', message);
  }
  const corners = new Uint8Array(facets * cornersSize);
  let coloured = 0;
  for (let facet = 0; facet < facets; facet++) {
    const start = headSize + facet * facetSize + normalSize;
    corners.set(bytes.subarray(start, start + cornersSize), facet * cornersSize);
    if (bytes[start + cornersSize] !== 0 || bytes[start + cornersSize + 1] !== 0) coloured++;
  }
  const extra = bytes.length - needed;
  if (extra > 0) notes.push(`${counted(extra, 'byte')} after the last facet passed over.`);
  if (coloured > 0) notes.push(`Not carried: colours or other attributes of ${counted(coloured, 'facet')}.`);
  return new Float32Array(corners.buffer);
}

function readText(bytes: Uint8Array): Float64Array {
  const position = new GrowingNumbers();
  let [facets, corners] = [0, 0];
  let open = false;
  for (const line of textLines(bytes)) {
    const keyword = line.words[0].toLowerCase();
    if (keyword === 'solid') open = true;
    else if (keyword === 'endsolid') open = false;
    else if (keyword === 'facet') {
      if (corners > 0) throw unknownLine(line);
    } else if (keyword === 'vertex') {
      for (const coordinate of numbersFrom(line, 1, 3)) position.push(coordinate);
      corners++;
    } else if (keyword === 'endfacet') {
      if (corners !== 3) throw wrongCorners(corners, facets, line);
      corners = 0;
      facets++;
    } else if (keyword !== 'outer' && keyword !== 'endloop') throw unknownLine(line);
  }
  if (!open && position.length === 9 * facets) return position.toArray();
  throw new FormatError('truncated', `The file ends after ${counted(facets, 'facet')} without “endsolid”.`);
}

function wrongCorners(corners: number, facet: number, { number }: TextLine): FormatError {
  const where = `facet ${facet}`;
  const message = `Facet ${grouped(facet)} has ${counted(corners, 'corner')}; it needs three (line ${number}).`;
  return new FormatError('bad_polygon', message, where);
}

function unknownLine({ words, number }: TextLine): FormatError {
  const where = `line ${number}`;
  return new FormatError('bad_header', `${quoted(words.join(' '))} is no line of an STL file (${where}).`, where);
}
