/** Honest files rarely unpack to a hundred times their size; a bomb goes to a thousand. Small ones may be as constant as they like. */
const mostExpansion = 256;
const freeExpansion = 16 << 20;
/** Nor can more than this be reduced: it is all the memory that WebAssembly has. */
const mostBytes = 2 ** 32;

/** How many bytes a file of this size may grow to when it is unpacked or its parts are repeated. */
export function expansionLimit(fileSize: number): number {
  return Math.min(freeExpansion + mostExpansion * fileSize, mostBytes);
}
