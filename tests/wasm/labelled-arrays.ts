const types = { Float32Array, Float64Array, Int32Array, Uint8Array, Uint32Array };

export type NumberArray = Float32Array | Float64Array | Int32Array | Uint8Array | Uint32Array;
export type LabelledArrays = Map<string, NumberArray>;

/** Reads what tests/wasm/native_reduction.cpp writes: for each array a line "name type count", then its bytes. */
export function readLabelledArrays(file: Buffer): LabelledArrays {
  const arrays: LabelledArrays = new Map();
  for (let at = 0; at < file.length; ) {
    const end = file.indexOf('\n', at);
    const [name = '', type, count] = file.toString('latin1', at, end).split(' ');
    const ArrayType = types[type as keyof typeof types];
    at = end + 1 + Number(count) * ArrayType.BYTES_PER_ELEMENT;
    // A copy, since the bytes need not stand where an array of their type may begin.
    arrays.set(name, new ArrayType(new Uint8Array(file.subarray(end + 1, at)).buffer));
  }
  return arrays;
}

/** The names of arrays that only one side has, or that differ in a byte. */
export function differences(one: LabelledArrays, other: LabelledArrays): string[] {
  const names = new Set([...one.keys(), ...other.keys()]);
  return [...names].filter((name) => !sameBytes(one.get(name), other.get(name)));
}

function sameBytes(one: NumberArray | undefined, other: NumberArray | undefined): boolean {
  return one !== undefined && other !== undefined && bytes(one).equals(bytes(other));
}

function bytes({ buffer, byteOffset, byteLength }: NumberArray): Buffer {
  return Buffer.from(buffer, byteOffset, byteLength);
}
