import { FormatError } from './format-error.ts';
import { formatNames } from './format-names.ts';
import type { Format } from './surface.ts';

/** Room for the comments that files may begin with. */
const headBytes = 1 << 16;

/** What may stand before the first element of an XML document; one way to read each letter, so that no text takes long. */
const prolog = String.raw`(?:\s|<\?(?:[^?]|\?(?!>))*\?>|<!--(?:[^-]|-(?!->))*-->)*(?:<!DOCTYPE[\s\S]*)?`;

/** How files begin. What no reader takes is here too, so that the message can name it. */
interface Signature {
  begins: RegExp | string;
  format?: Format;
  /** For the message where there is no reader. */
  called: string;
}

const signatures: Signature[] = [
  { begins: /^ply[ \t]*[\r\n]/, format: 'ply', called: 'PLY' },
  { begins: new RegExp(`^(?:\\xEF\\xBB\\xBF)?${prolog}<VTKFile\\b`), format: 'vtp', called: 'VTK XML' },
  { begins: /^# vtk DataFile/i, format: 'vtk', called: 'legacy VTK' },
  { begins: 'glTF', format: 'glb', called: 'GLB' },
  { begins: /^\s*solid\b[\s\S]*\b(facet|endsolid)\b/i, format: 'stl', called: 'STL' },
  { begins: /^\s*\{/, format: 'glb', called: 'glTF' },
  { begins: /^\s*(#[^\n]*\n\s*|(mtllib|o|g|s|usemtl)\b[^\n]*\n\s*)*v[nt]?\s+[-+.\d]/, format: 'obj', called: 'OBJ' },
  { begins: /^\s*OFF\b|^\s*COFF\b/, called: 'OFF' },
  { begins: '\x1F\x8B', called: 'gzip' },
  { begins: 'PK\x03\x04', called: 'ZIP' },
  { begins: '\x89HDF\r\n', called: 'HDF5' },
  { begins: '%PDF', called: 'PDF' },
  { begins: /^\x89PNG|^\xFF\xD8\xFF|^GIF8/, called: 'an image' },
  { begins: /^\s*(<!doctype html|<html)/i, called: 'HTML' },
  { begins: /^(\xEF\xBB\xBF)?\s*<\?xml|^\s*<[A-Za-z]/, called: 'XML' },
];

const readable = Object.values(formatNames).join(', ');

/**
 * The format of a file by its content. Its name is asked only where the content has no mark: an OBJ file may begin with
 * anything, a binary STL file that was cut is just bytes. Throws on what has no reader, and names it if it can.
 */
export function recognise(bytes: Uint8Array, name: string): Format {
  if (bytes.length === 0) throw new FormatError('empty_file', 'The file is empty.');
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, headBytes));
  const begins = ({ begins: mark }: Signature) => (typeof mark === 'string' ? head.startsWith(mark) : mark.test(head));
  const found = signatures.find(begins);
  const format = found ? found.format : formatWithoutMark(bytes, name);
  if (format) return format;
  if (!found)
    throw new FormatError('not_a_mesh', `This is no mesh file that is known here: ${readable} are.${adviceFor(name)}`);
  throw new FormatError(
    'unsupported_format',
    `This looks like ${found.called}, which is not read here; ${readable} are.`,
  );
}

function adviceFor(name: string): string {
  return /\.csv$/i.test(name) ? ' A CSV file adds variables to a surface: give both together.' : '';
}

function formatWithoutMark(bytes: Uint8Array, name: string): Format | undefined {
  if (isBinaryStl(bytes)) return 'stl';
  const ending = /\.(stl|obj)$/i.exec(name)?.[1]?.toLowerCase();
  return ending as 'stl' | 'obj' | undefined;
}

const [stlHead, stlFacet] = [84, 50];

/** Whether the size of a file is what the count in the head of a binary STL file makes it; it has no other mark. */
export function isBinaryStl(bytes: Uint8Array): boolean {
  if (bytes.length < stlHead) return false;
  const facets = new DataView(bytes.buffer, bytes.byteOffset).getUint32(stlHead - 4, true);
  return bytes.length === stlHead + stlFacet * facets;
}
