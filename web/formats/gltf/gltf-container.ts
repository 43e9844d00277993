import { FormatError } from '../format-error.ts';
import { utf8Text } from '../text/utf8-text.ts';
import { foreign, grouped } from '../text/wording.ts';
import { refuseCompression } from './gltf-compression.ts';
import type { GltfJson } from './gltf-json.ts';
import { checkShape } from './gltf-shape.ts';

export interface GltfFile {
  json: GltfJson;
  /** The binary chunk of a GLB file. */
  binary: Uint8Array | undefined;
}

const headSize = 12;
const chunkHeadSize = 8;
const jsonChunk = 0x4e4f534a;
const binaryChunk = 0x004e4942;

/** Takes a GLB file apart, or reads the JSON of a glTF file. Throws where that is nothing that can be read here. */
export function openGltf(bytes: Uint8Array): GltfFile {
  const isBinary = new TextDecoder('latin1').decode(bytes.subarray(0, 4)) === 'glTF';
  const file = isBinary ? openGlb(bytes) : { json: parseJson(bytes), binary: undefined };
  refuseCompression(file.json);
  checkVersion(file.json);
  checkShape(file.json);
  return file;
}

function checkVersion(json: GltfJson | null): void {
  if (typeof json?.asset?.version === 'string' && json.asset.version.startsWith('2.')) return;
  throw new FormatError('unsupported_feature', 'This is no glTF of version 2.');
}

function openGlb(bytes: Uint8Array): GltfFile {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const declared = bytes.length < headSize ? headSize : view.getUint32(8, true);
  if (bytes.length < declared) {
    const message = `The header declares ${grouped(declared)} bytes, but the file has ${grouped(bytes.length)}.`;
    throw new FormatError('truncated', message);
  }
  if (view.getUint32(4, true) !== 2) {
    throw new FormatError('unsupported_feature', `This is GLB version ${view.getUint32(4, true)}; only 2 is read.`);
  }
  const chunks: [type: number, data: Uint8Array][] = [];
  for (let at = headSize; at + chunkHeadSize <= declared; ) {
    const [size, type] = [view.getUint32(at, true), view.getUint32(at + 4, true)];
    const end = at + chunkHeadSize + size;
    if (end > declared)
      throw new FormatError('truncated', `A chunk ends ${grouped(end - declared)} bytes behind the file.`);
    chunks.push([type, bytes.subarray(at + chunkHeadSize, end)]);
    at = end;
  }
  if (chunks[0]?.[0] !== jsonChunk) throw new FormatError('bad_header', 'The first chunk of the GLB file is not JSON.');
  return { json: parseJson(chunks[0][1]), binary: chunks.find(([type]) => type === binaryChunk)?.[1] };
}

function parseJson(bytes: Uint8Array): GltfJson {
  const text = utf8Text(bytes, 'the JSON of the glTF file');
  try {
    return JSON.parse(text) as GltfJson;
  } catch (error) {
    const cut = !text.trimEnd().endsWith('}');
    throw new FormatError(
      cut ? 'truncated' : 'bad_header',
      `The JSON of the glTF file is broken: ${foreign((error as Error).message)}.`,
    );
  }
}
