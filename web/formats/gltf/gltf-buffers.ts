import { Base64Bytes } from '../bytes/byte-streams.ts';
import { FormatError } from '../format-error.ts';
import type { Beside } from '../surface.ts';
import { grouped, quoted } from '../text/wording.ts';
import type { GltfFile } from './gltf-container.ts';

/**
 * The bytes of each buffer: the binary chunk of a GLB file, a data URI, or a file beside this one. Throws where there are fewer than
 * declared.
 */
export async function readBuffers({ json, binary }: GltfFile, beside?: Beside): Promise<Uint8Array[]> {
  // Copies, so that numbers lie as they must.
  const chunk = binary?.slice();
  const files = new Map<string, Uint8Array>();
  const buffers: Uint8Array[] = [];
  for (const [index, { uri, byteLength = 0 }] of (json.buffers ?? []).entries()) {
    const where = `buffer ${index}`;
    const isFile = uri !== undefined && !uri.startsWith('data:');
    if (isFile && !files.has(uri)) files.set(uri, (await readBeside(uri, beside)).slice());
    const whole = isFile
      ? files.get(uri)
      : uri === undefined
        ? chunkOf(index, chunk)
        : decodeUri(uri, byteLength, where);
    const bytes = whole ?? new Uint8Array();
    if (byteLength > bytes.length) {
      const message = `Buffer ${index} should have ${grouped(byteLength)} bytes, but has ${grouped(bytes.length)}.`;
      throw new FormatError('truncated', message, where);
    }
    buffers.push(bytes);
  }
  return buffers;
}

/** Only the first buffer is the binary chunk; others without a URI have no bytes at all. */
function chunkOf(buffer: number, chunk: Uint8Array | undefined): Uint8Array | undefined {
  return buffer === 0 ? chunk : undefined;
}

function readBeside(uri: string, beside: Beside | undefined): Promise<Uint8Array> {
  const path = pathOf(uri);
  if (path !== undefined && beside) return beside(path);
  const reason = path === undefined ? 'which is no file beside it' : 'which is not at hand';
  const message = `The file refers to ${quoted(uri)}, ${reason}. Save it as GLB, with everything in one file.`;
  throw new FormatError('unsupported_feature', message);
}

/** The path that a URI names below the folder of the file; undefined for all else. */
function pathOf(uri: string): string | undefined {
  let path: string;
  try {
    path = decodeURIComponent(uri);
  } catch {
    return undefined;
  }
  const leaves = /^[a-z][\w+.-]*:|^[/\\]|\0/i.test(path) || path.split(/[/\\]/).includes('..');
  return leaves ? undefined : path;
}

function decodeUri(uri: string, byteLength: number, where: string): Uint8Array {
  const text = /^data:[^,]*;base64,/.exec(uri);
  if (text) return new Base64Bytes(new TextEncoder().encode(uri), text[0].length, where).take(byteLength);
  throw new FormatError('unsupported_feature', `The data URI of the ${where} is not base64.`, where);
}
