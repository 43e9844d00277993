import { weldedSurface } from '../cracks/welded-surface.ts';
import { FormatError } from '../format-error.ts';
import type { Surface } from '../surface.ts';
import { counted, grouped } from '../text/wording.ts';
import { declaredFacets, stlFacet, stlHead, stlKind } from './stl-kind.ts';
import { readStlText } from './stl-text.ts';

// Written by hand although three.js has an STLLoader: that one reads a text that lost its end as an empty mesh, passes over
// corners that it cannot read, and allocates whatever a binary header declares.

const normalSize = 12;
const cornersSize = 36;

/**
 * Reads an STL file, binary (single precision) or text (double, since text has no precision of its own). STL knows no
 * shared points: those of the same place are welded. It carries no variables; the normals of its facets follow from their corners.
 */
export function readStl(bytes: Uint8Array): Surface {
  const notes: string[] = [];
  const position = stlKind(bytes) === 'text' ? readStlText(bytes, notes) : readBinary(bytes, notes);
  if (position.length === 0) throw new FormatError('no_triangles', 'The file has no facets.');
  return weldedSurface(
    { position, triangles: new Uint32Array(position.length / 3).map((_, i) => i), variables: [] },
    notes,
  );
}

/** What the head declares; some programs leave it 0, and then the size of the file tells, if it is facets that follow. */
function facetCount(bytes: Uint8Array, notes: string[]): number {
  if (bytes.length < stlHead) return 0;
  const declared = declaredFacets(bytes);
  const room = Math.floor((bytes.length - stlHead) / stlFacet);
  if (declared > 0 || room === 0 || !areFacets(bytes, room)) return declared;
  notes.push(`The header declares no facets, but ${counted(room, 'facet')} follow, which were read.`);
  return room;
}

/** Whether so many facets have places in space. */
function areFacets(bytes: Uint8Array, facets: number): boolean {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let facet = 0; facet < facets; facet++) {
    const start = stlHead + facet * stlFacet + normalSize;
    for (let at = start; at < start + cornersSize; at += 4)
      if (!Number.isFinite(view.getFloat32(at, true))) return false;
  }
  return true;
}

function readBinary(bytes: Uint8Array, notes: string[]): Float32Array {
  const facets = facetCount(bytes, notes);
  const needed = stlHead + stlFacet * facets;
  if (bytes.length < needed) {
    const message = `The header declares ${counted(facets, 'facet')}, ${grouped(needed)} bytes, but the file has ${grouped(bytes.length)}.`;
    throw new FormatError('truncated', message);
  }
  const corners = new Uint8Array(facets * cornersSize);
  let coloured = 0;
  for (let facet = 0; facet < facets; facet++) {
    const start = stlHead + facet * stlFacet + normalSize;
    corners.set(bytes.subarray(start, start + cornersSize), facet * cornersSize);
    if (bytes[start + cornersSize] !== 0 || bytes[start + cornersSize + 1] !== 0) coloured++;
  }
  const extra = bytes.length - needed;
  if (extra > 0) notes.push(`${counted(extra, 'byte')} after the last facet passed over.`);
  if (coloured > 0) notes.push(`Not carried: colours or other attributes of ${counted(coloured, 'facet')}.`);
  return new Float32Array(corners.buffer);
}
