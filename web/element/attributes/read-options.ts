import { notWeld, weldFraction } from '../../formats/cracks/weld-fraction.ts';
import type { ReadOptions } from '../../formats/read.ts';

/** How the next surface is to be read, from the attribute `weld`. Throws where that is no fraction. */
export function readOptionsFrom(weld: string | null): ReadOptions {
  if (weld === null || weld.trim() === '') return {};
  const fraction = weldFraction(weld);
  if (fraction === undefined) throw Object.assign(new Error(notWeld('weld', weld)), { code: 'bad_option' });
  return { weld: fraction };
}
