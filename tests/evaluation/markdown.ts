/** A table in Markdown; the first column runs left, the others right. */
export function markdownTable(head: string[], lines: (string | number)[][]): string {
  const alignment = head.map((_, column) => (column === 0 ? '---' : '---:'));
  return [head, alignment, ...lines].map((line) => `| ${line.join(' | ')} |`).join('\n');
}
