import type { Variable } from '../../../wasm/types.ts';
import type { Format, Labels } from '../surface.ts';
import { isByteColour } from './colours.ts';
import type { WholeType } from './whole-types.ts';

// The mesh holds every number in floating point, and a reduction keeps those of the vertices that stay bit for bit. So the type
// that a file has whole numbers in is told beside them, as a label, and a writer gives them back in it.

const arrays = {
  int8: Int8Array,
  uint8: Uint8Array,
  int16: Int16Array,
  uint16: Uint16Array,
  int32: Int32Array,
  uint32: Uint32Array,
  int64: BigInt64Array,
  uint64: BigUint64Array,
};

export type WholeArray =
  | Int8Array
  | Uint8Array
  | Int16Array
  | Uint16Array
  | Int32Array
  | Uint32Array
  | BigInt64Array
  | BigUint64Array;

/** Which of the types a format has a place for; those of colours aside. */
const held: Partial<Record<Format, (type: WholeType) => boolean>> = {
  ply: (type) => !type.endsWith('64'),
  vtp: () => true,
  vtk: () => true,
};

type Types = Pick<Partial<Labels>, 'wholeTypes' | 'roles'>;

/** The type of whole numbers that a file of this format gets for a variable; undefined where that stays floating point. */
export function wholeTypeIn(format: Format, variable: Variable, types: Types): WholeType | undefined {
  if (held[format] && isByteColour(variable, types)) return 'uint8';
  const type = declaredType(variable, types);
  return type !== undefined && held[format]?.(type) && isHeldBy(type, variable) ? type : undefined;
}

/** The variables that were whole numbers in their file and will be floating point in a file of this format. */
export function noLongerWhole(format: Format, variables: Variable[], types: Types): Variable[] {
  return variables.filter(
    (variable) =>
      declaredType(variable, types) !== undefined &&
      wholeTypeIn(format, variable, types) === undefined &&
      !isByteColour(variable, types),
  );
}

function declaredType({ name }: Variable, { wholeTypes = {} }: Types): WholeType | undefined {
  return Object.hasOwn(wholeTypes, name) ? wholeTypes[name] : undefined;
}

/** The values in this type; for wholeTypeIn says that it holds them. */
export function asWhole(values: Variable['values'], type: WholeType): WholeArray {
  if (type === 'int64' || type === 'uint64') return arrays[type].from(Array.from(values, BigInt));
  return arrays[type].from(values);
}

/** Whether each value is a number of this type; beyond 2^53 nothing tells whether it is the one of the file. */
function isHeldBy(type: WholeType, { values }: Variable): boolean {
  const bits = Math.min(53, Number(/\d+/.exec(type)?.[0]) - (type.startsWith('u') ? 0 : 1));
  const [lowest, highest] = [type.startsWith('u') ? 0 : -(2 ** bits), 2 ** bits - 1];
  return values.every(
    (value: number) => Number.isInteger(value) && value >= lowest && value <= highest && !Object.is(value, -0),
  );
}
