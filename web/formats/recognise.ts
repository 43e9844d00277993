import { FormatError } from './format-error.ts';
import { formatNames } from './format-names.ts';
import { stlKind } from './stl/stl-kind.ts';
import type { Format } from './surface.ts';

/** Room for the comments that files may begin with. */
const headBytes = 1 << 16;

/** What may stand before the first element of an XML document; one way to read each letter, so that no text takes long. */
const prolog = String.raw`(?:\s|<\?(?:[^?]|\?(?!>))*\?>|<!--(?:[^-]|-(?!->))*-->)*(?:<!DOCTYPE[\s\S]*)?`;

/** How files begin; texts have no byte 0. What no reader takes is here too, so that the message can name it. */
interface Signature {
  begins: RegExp | string | ((bytes: Uint8Array) => boolean);
  format?: Format;
  /** For the message where there is no reader. */
  called: string;
}

const signatures: Signature[] = [
  { begins: /^ply[ \t]*[\r\n]/, format: 'ply', called: 'PLY' },
  { begins: new RegExp(`^(?:\\xEF\\xBB\\xBF)?${prolog}<VTKFile\\b`), format: 'vtp', called: 'VTK XML' },
  { begins: /^\s*# vtk DataFile/i, format: 'vtk', called: 'legacy VTK' },
  { begins: 'glTF', format: 'glb', called: 'GLB' },
  { begins: isStl, format: 'stl', called: 'STL' },
  { begins: /^\s*\{[^\0]*$/, format: 'glb', called: 'glTF' },
  {
    begins: /^\s*(#[^\n]*\n\s*|(mtllib|o|g|s|usemtl)\b[^\n]*\n\s*)*v[nt]?\s+[-+.\d][^\0]*$/,
    format: 'obj',
    called: 'OBJ',
  },
  { begins: /^\s*OFF\b|^\s*COFF\b/, called: 'OFF' },
  { begins: '\x1F\x8B', called: 'gzip' },
  { begins: 'PK\x03\x04', called: 'ZIP' },
  { begins: '\x89HDF\r\n', called: 'HDF5' },
  { begins: /^\xFF\xFE[\s\S]\0|^\xFE\xFF\0/, called: 'text in UTF-16' },
  { begins: '%PDF', called: 'PDF' },
  { begins: /^\x89PNG|^\xFF\xD8\xFF|^GIF8/, called: 'an image' },
  { begins: /^\s*(<!doctype html|<html)/i, called: 'HTML' },
  { begins: /^(\xEF\xBB\xBF)?\s*<\?xml|^\s*<[A-Za-z]/, called: 'XML' },
];

/** A text that is one needs more than its first word. */
function isStl(bytes: Uint8Array): boolean {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, headBytes));
  const kind = stlKind(bytes);
  return kind === 'binary' || (kind === 'text' && /\b(facet|endsolid)\b/i.test(head));
}

const readable = Object.values(formatNames).join(', ');

/**
 * The format of a file by its content. Its name is asked only where the content has no mark: an OBJ file may begin with
 * anything, a binary STL file that was cut is just bytes. Throws on what has no reader, and names it if it can.
 */
export function recognise(bytes: Uint8Array, name: string): Format {
  if (bytes.length === 0) throw new FormatError('empty_file', 'The file is empty.');
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, headBytes));
  const begins = ({ begins: mark }: Signature) => {
    if (typeof mark === 'string') return head.startsWith(mark);
    return typeof mark === 'function' ? mark(bytes) : mark.test(head);
  };
  const found = signatures.find(begins);
  const format = found ? found.format : formatWithoutMark(name);
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

function formatWithoutMark(name: string): Format | undefined {
  const ending = /\.(stl|obj)$/i.exec(name)?.[1]?.toLowerCase();
  return ending as 'stl' | 'obj' | undefined;
}
