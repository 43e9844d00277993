import { english } from './english.ts';

type Reason = keyof typeof english.littleWent.reasons;

/** "Why so little went: 78 % of the vertices left are locked." Of a share below 1 never 100 %, of one above 0 never 0 %. */
export function littleWentSentence({ reason, share }: { reason: Reason; share: number }): string {
  const percent = share < 1 ? Math.min(Math.max(Math.round(100 * share), 1), 99) : 100;
  return english.littleWent.sentence(String(percent), english.littleWent.reasons[reason]);
}
