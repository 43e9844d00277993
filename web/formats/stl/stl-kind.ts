/** STL is one name for two formats. */
export type StlKind = 'text' | 'binary';

/** What a binary file begins with (80 bytes of anything and the number of facets), and what a facet takes. */
export const [stlHead, stlFacet] = [84, 50];

/** So much of a file is looked at. */
const sampleSize = 1 << 16;

/** A facet as text has it; what stands between its words is not looked at, as long as it is short. */
const facetAsText = /\bfacet\b[\s\S]{0,400}?\bouter\s+loop\s+vertex\s+[-+.\d]/i;
const beginsAsText = /^\s*(?:(?:#|\/\/|;|!)[^\r\n]*[\r\n]\s*)*solid\b/i;
/** Bytes that no text has. */
// biome-ignore lint/suspicious/noControlCharactersInRegex: these are what is looked for.
const control = /[\0-\x08\x0e-\x19\x1b-\x1f]/;

/**
 * Whether a file is STL of either kind; undefined where nothing says so. Neither has a mark of its own: files of both kinds
 * may begin with “solid”, or with anything. So size and content are asked together: facets that are text make a text, unless there are bytes that no
 * text has and the size is that of as many facets as the head of a binary file declares.
 */
export function stlKind(bytes: Uint8Array): StlKind | undefined {
  const sample = new TextDecoder('latin1').decode(bytes.subarray(0, sampleSize));
  const isPlain = !control.test(sample);
  const isSized = bytes.length >= stlHead && bytes.length === stlHead + stlFacet * declaredFacets(bytes);
  if (facetAsText.test(sample)) return isPlain || !isSized ? 'text' : 'binary';
  if (isSized) return 'binary';
  if (!beginsAsText.test(sample)) return undefined;
  return isPlain ? 'text' : 'binary';
}

/** The number of facets that the head of a binary file declares. */
export function declaredFacets(bytes: Uint8Array): number {
  return new DataView(bytes.buffer, bytes.byteOffset).getUint32(stlHead - 4, true);
}
