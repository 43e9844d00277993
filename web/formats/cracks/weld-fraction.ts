/** More would be no crack any more. */
const largestWeld = 0.01;

/** A fraction of the extent as a user writes it, `1e-6` or `0.0001%`; undefined for what is none. */
export function weldFraction(text: string): number | undefined {
  const [, digits = '', percent] = /^([\d.]+(?:[eE][-+]?\d+)?)(%?)$/.exec(text.trim()) ?? [];
  const fraction = digits === '' ? Number.NaN : Number(digits) / (percent ? 100 : 1);
  return fraction > 0 && fraction <= largestWeld ? fraction : undefined;
}

/** What is to be said where it is none. */
export function notWeld(option: string, text: string): string {
  return `${option} cannot be “${text}”; it is a fraction of the extent above 0 and up to ${largestWeld}, like 1e-6.`;
}
