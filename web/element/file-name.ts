/** What the file of a reduced surface is called: the name of what was opened, with only letters that every system takes. */
export function reducedFileName(opened: string, format: string): string {
  const stem = opened
    .replace(/\.gz$/i, '')
    .replace(/\.[a-z0-9]{1,4}$/i, '')
    .replace(/[^\p{L}\p{N}._-]+/gu, '-');
  return `${stem.replace(/^[-.]+|-+$/g, '') || 'surface'}-reduced.${format}`;
}
