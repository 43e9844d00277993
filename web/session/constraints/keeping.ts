import type { Box } from '../../../wasm/types.ts';
import type { FocusPoint } from './focus-point.ts';
import type { PointRange } from './point-list.ts';

/** What of a surface must stay as it is, what parts it into regions, and where its bounds are others. */
export interface Keeping {
  /** Vertices that must stay. */
  lockPoints: readonly PointRange[];
  /** Every triangle that meets it must stay. */
  lockBox: Box | null;
  /** The cell data whose values part the surface into regions: their borders are kept within the bounds. */
  regions: string | null;
  /** Labels of regions that must stay. */
  lockRegions: readonly number[];
  /** The variable that multiplies all bounds. */
  boundMultiplier: string | null;
  /** Near it the bounds are finer still. */
  focusPoint: FocusPoint | null;
}

export const nothingKept: Keeping = {
  lockPoints: [],
  lockBox: null,
  regions: null,
  lockRegions: [],
  boundMultiplier: null,
  focusPoint: null,
};

export function sameKeeping(one: Keeping, other: Keeping): boolean {
  return JSON.stringify(one) === JSON.stringify(other);
}

/** Whether bounds differ over the surface. */
export function isMultiplied({ boundMultiplier, focusPoint }: Keeping): boolean {
  return boundMultiplier !== null || focusPoint !== null;
}

/** Labels of regions as people write them, `1,2,5`. Throws an Error whose message is a sentence for people. */
export function readLabels(text: string): number[] {
  const words = text.split(/[\s,;]+/).filter((word) => word !== '');
  const wrong = words.find((word) => !Number.isInteger(Number(word)) || Math.abs(Number(word)) >= 2 ** 31);
  if (wrong !== undefined) throw new Error(`“${wrong}” is not the number of a region.`);
  return words.map(Number);
}
