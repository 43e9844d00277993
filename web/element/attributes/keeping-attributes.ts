import { boxText, readBox } from '../../session/constraints/box-text.ts';
import { focusPointText, readFocusPoint } from '../../session/constraints/focus-point.ts';
import { type Keeping, readLabels } from '../../session/constraints/keeping.ts';
import { pointsText, readPoints } from '../../session/constraints/point-list.ts';
import { messageOf } from '../../session/reading/failure.ts';
import { english } from '../../words/english.ts';

/** What of a surface is to be kept, as attributes say it; null and empty text say nothing. */
export interface WantedKeeping {
  lockPoints: string | null;
  lockBox: string | null;
  regions: string | null;
  lockRegions: string | null;
  boundMultiplier: string | null;
  focusPoint: string | null;
}

export const keepingAttributes = [
  'lockPoints',
  'lockBox',
  'regions',
  'lockRegions',
  'boundMultiplier',
  'focusPoint',
] as const;

/** Throws an Error that says which attribute cannot be understood. */
export function keepingFrom(wanted: WantedKeeping): Keeping {
  return {
    lockPoints: read('lock-points', wanted.lockPoints, readPoints) ?? [],
    lockBox: read('lock-box', wanted.lockBox, readBox),
    regions: wanted.regions || null,
    lockRegions: read('lock-regions', wanted.lockRegions, readLabels) ?? [],
    boundMultiplier: wanted.boundMultiplier || null,
    focusPoint: read('focus-point', wanted.focusPoint, readFocusPoint),
  };
}

function read<Value>(name: string, text: string | null, reader: (text: string) => Value): Value | null {
  if (!text) return null;
  try {
    return reader(text);
  } catch (error) {
    throw new Error(english.faults.attribute(name, text, messageOf(error)));
  }
}

/** The attributes that `keepingFrom` reads as this. */
export function keepingText({
  lockPoints,
  lockBox,
  regions,
  lockRegions,
  boundMultiplier,
  focusPoint,
}: Keeping): WantedKeeping {
  return {
    lockPoints: pointsText(lockPoints) || null,
    lockBox: lockBox && boxText(lockBox),
    regions,
    lockRegions: lockRegions.join(',') || null,
    boundMultiplier,
    focusPoint: focusPoint && focusPointText(focusPoint),
  };
}
