import type { Measurement } from './cases.ts';

export type Contender =
  | 'native'
  | 'native, all threads'
  | 'native, propagated'
  | 'module'
  | 'module, propagated'
  | 'meshoptimizer'
  | 'VTK';

/** What the contenders did on one surface with one set of variables; one that failed is missing. */
export interface Row {
  size: string;
  variables: number;
  results: Partial<Record<Contender, Measurement>>;
}

/** The better of two runs of the same: whatever else the machine does only adds. */
export function better(one: Measurement | undefined, other: Measurement): Measurement {
  if (!one) return other;
  return { ...other, wall: Math.min(one.wall, other.wall), cpu: Math.min(one.cpu, other.cpu) };
}
