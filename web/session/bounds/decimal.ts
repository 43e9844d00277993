/** A decimal comma, as much of the world writes it. */
const withComma = /^([+-]?\d*),(\d+)((?:e[+-]?\d+)?)$/i;
/** With three digits behind it, it may as well part thousands. */
const likeThousands = /^[+-]?[1-9]\d{0,2},\d{3}$/;

/**
 * The number that a text states, with a decimal point or a decimal comma; NaN where it states none, and where a comma could
 * as well part thousands.
 */
export function readDecimal(text: string): number {
  const written = text.trim();
  if (written === '' || likeThousands.test(written)) return Number.NaN;
  return Number(written.replace(withComma, '$1.$2$3'));
}

/** What is wrong with a text that states no number. */
export function notANumber(text: string): string {
  const written = text.trim();
  if (!likeThousands.test(written)) return `“${written}” is not a number.`;
  const [whole, part] = written.split(',');
  return `“${written}” can be read in two ways: write ${whole}${part} or ${whole}.${part}.`;
}
