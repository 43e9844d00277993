import { FormatError } from './format-error.ts';
import type { Format } from './surface.ts';

/** How files begin. What no reader takes is here too, so that the message can name it. */
const headBytes = 512;

interface Signature {
  begins: RegExp | string;
  format?: Format;
  /** For the message where there is no reader. */
  called: string;
}

const signatures: Signature[] = [
  { begins: /^ply[ \t]*[\r\n]/, format: 'ply', called: 'PLY' },
  {
    begins: /^(\xEF\xBB\xBF)?\s*(<\?xml[\s\S]*?\?>\s*)?(<!--[\s\S]*?-->\s*)*(<!DOCTYPE[\s\S]*)?<VTKFile\b/,
    format: 'vtp',
    called: 'VTK XML',
  },
  { begins: /^# vtk DataFile/i, format: 'vtk', called: 'legacy VTK' },
  { begins: 'glTF', called: 'GLB' },
  { begins: /^\s*solid\b[\s\S]*\bfacet\b/, called: 'STL' },
  { begins: /^\s*\{[\s\S]*"asset"/, called: 'glTF' },
  { begins: /^\s*(#[^\n]*\n\s*|(mtllib|o|g|s|usemtl)\b[^\n]*\n\s*)*v\s+[-+.\d]/, called: 'OBJ' },
  { begins: /^\s*OFF\b|^\s*COFF\b/, called: 'OFF' },
  { begins: '\x1F\x8B', called: 'gzip' },
  { begins: 'PK\x03\x04', called: 'ZIP' },
  { begins: '\x89HDF\r\n', called: 'HDF5' },
  { begins: '%PDF', called: 'PDF' },
  { begins: /^\x89PNG|^\xFF\xD8\xFF|^GIF8/, called: 'an image' },
  { begins: /^\s*(<!doctype html|<html)/i, called: 'HTML' },
  { begins: /^(\xEF\xBB\xBF)?\s*<\?xml|^\s*<[A-Za-z]/, called: 'XML' },
];

/** The format of a file by its content; its name is not asked. Throws on what has no reader, and names it if it can. */
export function recognise(bytes: Uint8Array): Format {
  if (bytes.length === 0) throw new FormatError('empty_file', 'The file is empty.');
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, headBytes));
  const found =
    signatures.find(({ begins }) => (typeof begins === 'string' ? head.startsWith(begins) : begins.test(head))) ??
    binaryStl(bytes);
  if (found?.format) return found.format;
  if (found) {
    throw new FormatError(
      'unsupported_format',
      `This looks like ${found.called}, which is not read here; PLY and VTP are.`,
    );
  }
  throw new FormatError(
    'not_a_mesh',
    'This is no mesh file that is known here: it begins neither as PLY nor as VTP does.',
  );
}

/** Binary STL has no signature, only a size that fits its count of triangles. */
function binaryStl(bytes: Uint8Array): Signature | undefined {
  const [headSize, triangleSize] = [84, 50];
  if (bytes.length < headSize) return undefined;
  const count = new DataView(bytes.buffer, bytes.byteOffset).getUint32(headSize - 4, true);
  return bytes.length === headSize + triangleSize * count ? { begins: '', called: 'STL' } : undefined;
}
