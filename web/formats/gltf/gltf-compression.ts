import { FormatError } from '../format-error.ts';
import { listed } from '../text/wording.ts';

/** Extensions that change how points are stored. Those of textures and materials do not matter here. */
const compressing = /draco|meshopt|(?<!texture)_compression/i;

/**
 * Throws where points or triangles are compressed, by the name of the extension: required or not, what stands in the place of
 * the compressed data need not be all of it. Looks at JSON that nobody has checked yet.
 */
export function refuseCompression(json: unknown): void {
  const file = asItem(json);
  const required = listIn(file.extensionsRequired).filter((name) => typeof name === 'string');
  const primitives = listIn(file.meshes).flatMap((mesh) => listIn(asItem(mesh).primitives));
  const holders = [...primitives, ...listIn(file.bufferViews), ...listIn(file.buffers)].map(asItem);
  const used = holders.flatMap(({ extensions }) => Object.keys(asItem(extensions)));
  const declared = hasPlaceless(file, primitives) ? listIn(file.extensionsUsed).map(String) : [];
  const names = new Set([...required, ...used, ...declared].filter((name) => compressing.test(name)));
  if (names.size === 0) return;
  const message = `The file is compressed by ${listed([...names])}, which is not read. Save it uncompressed.`;
  throw new FormatError('unsupported_feature', message);
}

/** Whether the points of a primitive are nowhere in the file. */
function hasPlaceless({ accessors }: Item, primitives: unknown[]): boolean {
  return primitives.some((primitive) => {
    const accessor = listIn(accessors)[Number(asItem(asItem(primitive).attributes).POSITION)];
    return accessor !== undefined && asItem(accessor).bufferView === undefined && asItem(accessor).sparse === undefined;
  });
}

type Item = Record<string, unknown>;

function asItem(value: unknown): Item {
  return typeof value === 'object' && value !== null ? (value as Item) : {};
}

function listIn(value: unknown): unknown[] {
  return Array.isArray(value) ? value : [];
}
