const wholeTypes = ['int8', 'uint8', 'int16', 'uint16', 'int32', 'uint32', 'int64', 'uint64'] as const;

/** The types of whole numbers in files. */
export type WholeType = (typeof wholeTypes)[number];

export function isWholeType(type: string): type is WholeType {
  return wholeTypes.some((each) => each === type);
}
