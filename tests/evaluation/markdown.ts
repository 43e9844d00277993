/** A table in Markdown; the first columns hold words and run left, the others right. */
export function markdownTable(head: string[], lines: (string | number)[][], ofWords = 1): string {
  const alignment = head.map((_, column) => (column < ofWords ? '---' : '---:'));
  return [head, alignment, ...lines].map((line) => `| ${line.join(' | ')} |`).join('\n');
}

/** Three digits that count, without an exponent. */
export function shortNumber(value: number): string {
  return String(Number(value.toPrecision(3)));
}

/** A unit behind a number, which the unit 1 is not. */
export function unitText(unit: string | undefined): string {
  return unit === undefined || unit === '1' ? '' : ` ${unit}`;
}
