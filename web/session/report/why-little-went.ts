import type { Report } from '../../../wasm/types.ts';

/** What besides the bounds kept most vertices. */
export type Reason = keyof Report['refused'];

export interface WhyLittleWent {
  reason: Reason;
  /** How many of the vertices that are left it kept, 0…1. */
  share: number;
}

/** How many vertices the bounds kept, all variables together. */
export function keptByBounds({ variables }: Pick<Report, 'variables'>): number {
  return variables.reduce((sum, { refused }) => sum + refused, 0);
}

/**
 * Why little went, where that has to be said: fewer than half of the candidates did, and the bounds kept fewer of the others
 * than everything else together. Then what else kept most of them; nothing otherwise, nor where the reduction was cancelled.
 */
export function whyLittleWent(report: Report): WhyLittleWent | undefined {
  const { candidates, vertices, refused, termination } = report;
  if (termination !== 'finished' || 2 * (candidates - vertices.after) >= candidates) return undefined;
  const reasons = Object.entries(refused) as [Reason, number][];
  const others = reasons.reduce((sum, [, count]) => sum + count, 0);
  const bounds = keptByBounds(report);
  if (others <= bounds) return undefined;
  const [reason, count] = reasons.reduce((most, next) => (next[1] > most[1] ? next : most));
  return { reason, share: count / (others + bounds) };
}
