import type { LevelState } from '../../session/reducing/level-session.ts';
import type { Standing } from '../../session/session-state.ts';
import { english } from '../../words/english.ts';

/**
 * What has to be said before the sentence on the result that is shown, so that nothing false stands beside it: that it is not
 * the answer to what is asked for, or not what is drawn. Empty where there is nothing.
 */
export function resultLead(standing: Standing, { nested, position }: LevelState): string {
  const { earlier, levelZero, onTheWay } = english.sentence;
  const lead: string[] = standing === 'asked' ? [] : [earlier[standing]];
  if (nested && position === 0) lead.push(levelZero);
  else if (nested && !Number.isInteger(position)) lead.push(onTheWay(Math.ceil(position)));
  return lead.join(' ');
}
