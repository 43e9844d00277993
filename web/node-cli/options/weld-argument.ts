import { notWeld, weldFraction } from '../../formats/cracks/weld-fraction.ts';
import { UsageFault } from '../fault.ts';

/** What `--weld` is in every help text. */
export const weldHelp =
  '--weld FRACTION         join ends of sheets that are nearer than this fraction of the extent (cracks of rounding: 1e-6)';

/** A fraction of the extent, or a percentage. Throws a UsageFault for anything else. */
export function parseWeld(text: string | undefined): number | undefined {
  if (text === undefined) return undefined;
  const fraction = weldFraction(text);
  if (fraction === undefined) throw new UsageFault(notWeld('--weld', text));
  return fraction;
}
