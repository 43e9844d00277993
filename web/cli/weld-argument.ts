import { UsageFault } from './fault.ts';

/** What `--weld` is in every help text; it stands behind two spaces and the padded name. */
export const weldHelp =
  '--weld FRACTION         join ends of sheets that are nearer than this fraction of the extent (cracks of rounding: 1e-6)';

/** More would be no crack any more. */
const largestWeld = 0.01;

/** A fraction of the extent, or a percentage. Throws a UsageFault for anything else. */
export function parseWeld(text: string | undefined): number | undefined {
  if (text === undefined) return undefined;
  const [, digits = '', percent] = /^([\d.]+(?:[eE][-+]?\d+)?)(%?)$/.exec(text.trim()) ?? [];
  const fraction = digits === '' ? Number.NaN : Number(digits) / (percent ? 100 : 1);
  if (fraction > 0 && fraction <= largestWeld) return fraction;
  throw new UsageFault(
    `--weld cannot be “${text}”; it is a fraction of the extent above 0 and up to ${largestWeld}, like 1e-6.`,
  );
}
