import type { ReduceOptions } from '../../../wasm/index.ts';

/**
 * How errors are accounted for, what retriangulation makes small where they are propagated, and how parts of the surface are
 * treated that are near each other or small.
 */
export type Method = Required<
  Pick<ReduceOptions, 'errors' | 'cost' | 'refusePiercing' | 'limitToFeatureSize' | 'dropSmallComponents'>
>;

export const firstMethod: Method = {
  errors: 'tracked',
  cost: 'introduced',
  refusePiercing: false,
  limitToFeatureSize: false,
  dropSmallComponents: false,
};

export function sameMethod(one: Method, other: Method): boolean {
  return (Object.keys(firstMethod) as (keyof Method)[]).every((name) => one[name] === other[name]);
}
