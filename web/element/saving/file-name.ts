/**
 * What a saved file is called: the name of what was opened, with only letters that every system takes, what it is, and
 * an ending: `wing.vtp` gives `wing-reduced.ply`.
 */
export function savedFileName(opened: string, what: string, ending: string): string {
  const stem = opened
    .replace(/\.gz$/i, '')
    .replace(/\.[a-z0-9]{1,4}$/i, '')
    .replace(/[^\p{L}\p{N}._-]+/gu, '-');
  return `${stem.replace(/^[-.]+|-+$/g, '') || 'surface'}-${what}.${ending}`;
}
