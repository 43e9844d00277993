/** A GLB file put together independently of the project's writer; buffer 0 is `binary`. */
export function glbFile(json: object, binary: Uint8Array): Uint8Array {
  const whole = { asset: { version: '2.0' }, buffers: [{ byteLength: binary.length }], ...json };
  const text = padded(new TextEncoder().encode(JSON.stringify(whole)), 32);
  const data = padded(binary, 0);
  const [headSize, chunkHeadSize] = [12, 8];
  const file = new Uint8Array(headSize + chunkHeadSize + text.length + chunkHeadSize + data.length);
  const words = (...numbers: number[]) => new Uint8Array(Uint32Array.from(numbers).buffer);
  file.set(words(0x46546c67, 2, file.length));
  file.set(words(text.length, 0x4e4f534a), headSize);
  file.set(text, headSize + chunkHeadSize);
  file.set(words(data.length, 0x004e4942), headSize + chunkHeadSize + text.length);
  file.set(data, headSize + 2 * chunkHeadSize + text.length);
  return file;
}

function padded(bytes: Uint8Array, filler: number): Uint8Array {
  const whole = new Uint8Array(4 * Math.ceil(bytes.length / 4)).fill(filler);
  whole.set(bytes);
  return whole;
}

const componentTypes = new Map<string, number>([
  ['Int8Array', 5120],
  ['Uint8Array', 5121],
  ['Int16Array', 5122],
  ['Uint16Array', 5123],
  ['Uint32Array', 5125],
  ['Float32Array', 5126],
]);
const types = ['SCALAR', 'VEC2', 'VEC3', 'VEC4'];

export interface GltfArray {
  values: Float32Array | Uint32Array | Uint16Array | Uint8Array | Int16Array | Int8Array;
  components: number;
  normalized?: boolean;
}

/** Arrays as accessors, each with a buffer view of its own. */
export function accessorsOf(arrays: GltfArray[]) {
  const bytes: number[] = [];
  const bufferViews: object[] = [];
  const accessors = arrays.map(({ values, components, normalized }, index) => {
    while (bytes.length % 4 > 0) bytes.push(0);
    bufferViews.push({ buffer: 0, byteOffset: bytes.length, byteLength: values.byteLength });
    for (const byte of new Uint8Array(values.buffer, values.byteOffset, values.byteLength)) bytes.push(byte);
    const componentType = componentTypes.get(values.constructor.name);
    return {
      bufferView: index,
      componentType,
      count: values.length / components,
      type: types[components - 1],
      normalized,
    };
  });
  return { json: { bufferViews, accessors }, binary: Uint8Array.from(bytes) };
}
