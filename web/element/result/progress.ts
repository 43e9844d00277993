import type { Opening, SessionState } from '../../session/session-state.ts';
import { english } from '../../words/english.ts';

/** What a viewer does from an address to a picture, in this order, and about how long each takes of it all. */
const shares = { download: 0.25, read: 0.15, check: 0.05, reduce: 0.5, draw: 0.05 };

export type Phase = keyof typeof shares;

const phases = Object.keys(shares) as Phase[];

/** Where a viewer is. */
export interface Step {
  phase: Phase;
  /** Of this phase, 0…1. */
  progress: number;
}

/** What a session is doing; drawing where it has a result that is not to be seen yet, null where it rests. */
export function stepOf({ opening, progress }: SessionState, drawn: boolean): Step | null {
  if (opening) return { phase: opening.phase, progress: opening.progress };
  if (progress !== null) return { phase: 'reduce', progress };
  return drawn ? null : { phase: 'draw', progress: 0 };
}

/** The progress over everything, 0…1, of what began with phase `first`. */
export function overall({ phase, progress }: Step, first: Phase): number {
  const upTo = (end: Phase) => phases.slice(0, phases.indexOf(end)).reduce((sum, each) => sum + shares[each], 0);
  const begin = upTo(first);
  return Math.max(0, (upTo(phase) + progress * shares[phase] - begin) / (1 - begin));
}

/** "Downloading wing.vtp… 40 %" */
export function openingText({ name, phase, progress }: Opening): string {
  const { phases, percent } = english.progress;
  return `${phases[phase]} ${name}…${progress > 0 ? percent(Math.round(100 * progress)) : ''}`;
}
