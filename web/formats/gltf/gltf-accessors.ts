import { expansionLimit } from '../bytes/expansion-limit.ts';
import { FormatError } from '../format-error.ts';
import { counted, grouped } from '../text/wording.ts';
import type { GltfAccessor, GltfJson } from './gltf-json.ts';

const componentSizes = new Map([
  [5120, 1],
  [5121, 1],
  [5122, 2],
  [5123, 2],
  [5125, 4],
  [5126, 4],
]);
const typeSizes = new Map([
  ['SCALAR', 1],
  ['VEC2', 2],
  ['VEC3', 3],
  ['VEC4', 4],
  ['MAT2', 4],
  ['MAT3', 9],
  ['MAT4', 16],
]);

/** Checks what glTF-Transform takes on trust: that accessors lie inside the buffers, and do not repeat them too often. */
export function checkAccessors(json: GltfJson, buffers: Uint8Array[], fileSize: number): void {
  for (const [index, view] of (json.bufferViews ?? []).entries()) checkView(view, index, buffers);
  // Overlapping accessors could ask for any amount of memory.
  let budget = expansionLimit(fileSize);
  for (const [index, accessor] of (json.accessors ?? []).entries()) {
    budget -= checkAccessor(accessor, `accessor ${index}`, json);
    if (accessor.sparse) budget -= checkSparse(accessor, `accessor ${index}`, json, buffers);
    if (budget < 0)
      throw new FormatError('too_large', 'The accessors ask for far more memory than a file of this size holds.');
  }
}

function isCount(value: unknown): value is number {
  return Number.isSafeInteger(value) && (value as number) >= 0;
}

function checkView(
  view: { buffer?: number; byteOffset?: number; byteLength?: number; byteStride?: number },
  index: number,
  buffers: Uint8Array[],
): void {
  const { buffer, byteOffset = 0, byteLength, byteStride = 4 } = view;
  const size = buffers[buffer ?? -1]?.length ?? -1;
  if (
    isCount(byteOffset) &&
    isCount(byteLength) &&
    isCount(byteStride) &&
    byteStride > 0 &&
    byteOffset + byteLength <= size
  )
    return;
  const where = `buffer view ${index}`;
  throw new FormatError('truncated', `The ${where} lies outside its buffer.`, where);
}

/** The memory that an accessor takes. */
function checkAccessor(accessor: GltfAccessor, where: string, json: GltfJson): number {
  const { count, componentType = 0, type = '', byteOffset = 0 } = accessor;
  const [componentSize, components] = [componentSizes.get(componentType), typeSizes.get(type)];
  if (componentSize === undefined || components === undefined || !isCount(count) || !isCount(byteOffset)) {
    throw new FormatError('bad_header', `The ${where} has no valid type, count or offset.`, where);
  }
  const size = componentSize * components;
  if (accessor.bufferView !== undefined && count > 0) {
    const view = json.bufferViews?.[accessor.bufferView];
    const stride = view?.byteStride ?? size;
    if (stride < size) {
      const message = `The ${where} has elements of ${size} bytes, but one every ${stride}.`;
      throw new FormatError('bad_header', message, where);
    }
    const needed = byteOffset + (count - 1) * stride + size;
    if (!view || needed > (view.byteLength ?? 0)) {
      const message = `The ${where} has ${counted(count, 'element')}, which its buffer view cannot hold.`;
      throw new FormatError('truncated', message, where);
    }
  }
  return count * size;
}

/** The same for the elements that a sparse accessor has in place of others. */
function checkSparse(accessor: GltfAccessor, place: string, json: GltfJson, buffers: Uint8Array[]): number {
  const { count, indices, values } = accessor.sparse ?? {};
  const where = `sparse part of ${place}`;
  const places = { ...indices, count, type: 'SCALAR' };
  const elements = { ...values, count, type: accessor.type, componentType: accessor.componentType };
  const size = checkAccessor(places, where, json) + checkAccessor(elements, where, json);
  for (let i = 0; i < (count ?? 0); i++) {
    const index = sparseIndex(places, i, json, buffers);
    if (index < (accessor.count ?? 0)) continue;
    const message = `The ${where} names element ${index}, but there are ${grouped(accessor.count ?? 0)}.`;
    throw new FormatError('bad_index', message, where);
  }
  return size;
}

/** Infinity where the accessor has no data or no type that indices may have. */
function sparseIndex(
  { bufferView, byteOffset = 0, componentType }: GltfAccessor,
  i: number,
  json: GltfJson,
  buffers: Uint8Array[],
): number {
  const view = json.bufferViews?.[bufferView ?? -1];
  const bytes = buffers[view?.buffer ?? -1];
  if (!view || !bytes) return Number.POSITIVE_INFINITY;
  const data = new DataView(bytes.buffer, bytes.byteOffset + (view.byteOffset ?? 0) + byteOffset);
  if (componentType === 5121) return data.getUint8(i);
  if (componentType === 5123) return data.getUint16(2 * i, true);
  return componentType === 5125 ? data.getUint32(4 * i, true) : Number.POSITIVE_INFINITY;
}
