import type { Method } from '../../session/constraints/method.ts';
import { stateAttributes } from './viewer-state.ts';

/** What a state says beside address and bounds. */
export const viewAttributes = stateAttributes.filter((name) => name !== 'src' && name !== 'bounds');

/** Of attributes whose properties are called otherwise. */
const properties = {
  'refuse-piercing': 'refusePiercing',
  'limit-to-feature-size': 'limitToFeatureSize',
  'drop-small-components': 'dropSmallComponents',
  'lock-points': 'lockPoints',
  'lock-box': 'lockBox',
  'lock-regions': 'lockRegions',
  'bound-multiplier': 'boundMultiplier',
  'focus-point': 'focusPoint',
  'level-count': 'levelCount',
  'level-pixels': 'levelPixels',
} as const;

export function propertyOf(name: (typeof viewAttributes)[number]) {
  return name in properties
    ? properties[name as keyof typeof properties]
    : (name as Exclude<typeof name, keyof typeof properties>);
}

/** Places between levels are said to two decimals. */
export function asAttribute(value: string | boolean | number | null): string | null {
  if (typeof value === 'number') return String(Number(value.toFixed(2)));
  return typeof value === 'boolean' ? (value ? '' : null) : value;
}

/** What a Method is made from. */
export const methodAttributes = [
  'errors',
  'cost',
  'refusePiercing',
  'limitToFeatureSize',
  'dropSmallComponents',
] as const;

/** Of the two that are words, what is not known is as at first. */
type WantedMethod = { [Name in keyof Method]: Method[Name] extends boolean ? boolean : Method[Name] | null };

export function methodFrom(wanted: WantedMethod): Method {
  const { refusePiercing, limitToFeatureSize, dropSmallComponents } = wanted;
  return {
    errors: wanted.errors === 'propagated' ? wanted.errors : 'tracked',
    cost: wanted.cost === 'maximum' ? wanted.cost : 'introduced',
    refusePiercing,
    limitToFeatureSize,
    dropSmallComponents,
  };
}
