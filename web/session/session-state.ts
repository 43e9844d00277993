import type { Multiplied } from '../probe/multiplied.ts';
import type { BoundSettings } from './bounds/bound-setting.ts';
import { type Keeping, nothingKept, sameKeeping } from './constraints/keeping.ts';
import { firstMethod, type Method, sameMethod } from './constraints/method.ts';
import type { OpenSurface } from './reading/open-surface.ts';

/** A file that is being opened. */
export interface Opening {
  name: string;
  /** Fetched, read, or checked by the core. */
  phase: 'download' | 'read' | 'check';
  /** Of this phase, 0…1. */
  progress: number;
}

/** What is asked of a surface. */
export interface Asked {
  bounds: BoundSettings;
  method: Method;
  keeping: Keeping;
}

/** A result with what it was asked with. */
export interface Reduced extends Asked {
  result: Multiplied;
}

/** Something to tell the user, until dismissed. */
export interface Notice {
  id: number;
  kind: 'error' | 'note';
  text: string;
  /** Of an error: what is wrong, for programs. */
  code?: string;
  /** What it is about, where that is said more than once: a later notice about the same takes its place. */
  about?: string;
  /** It is not about the file, and stays when another one is opened. */
  lasting?: boolean;
  /** It tells that something went well, and goes by itself. */
  passing?: boolean;
  /** It is about the last reduction, and goes when the next one starts. */
  ofReduction?: boolean;
  /** It tells of what can part the surface into regions, and goes when that is chosen. */
  ofRegions?: boolean;
  /** A way out that the user may take. */
  remedy?: { label: string; take: () => void };
}

/** Never changed in place: a change replaces it. */
export interface SessionState extends Asked {
  opening: Opening | null;
  surface: OpenSurface | null;
  /** Whether a change of the bounds can be undone, and done again. */
  canUndo: boolean;
  canRedo: boolean;
  /** Of the running reduction, 0…1; null where none runs. */
  progress: number | null;
  /** The user stopped the last reduction: a result is that of the one before. */
  cancelled: boolean;
  /** Why what is asked for cannot be reduced: a result is of what was asked for before. Null where nothing is wrong. */
  refusal: string | null;
  /** The last good reduction of this surface: of earlier bounds where another one runs. */
  reduced: Reduced | null;
  /**
   * While bounds move and until the reduction is there: an answer from a checkpoint, which keeps its bounds, but is not the one
   * that counts. Null where there is none, and always where nothing runs.
   */
  provisional: Reduced | null;
  notices: readonly Notice[];
}

export const emptyState: SessionState = {
  opening: null,
  surface: null,
  bounds: {},
  canUndo: false,
  canRedo: false,
  method: firstMethod,
  keeping: nothingKept,
  progress: null,
  cancelled: false,
  refusal: null,
  reduced: null,
  provisional: null,
  notices: [],
};

/** How the answer at hand stands to what is asked for: it is the answer to that, or to what was asked for before. */
export type Standing = 'asked' | 'running' | 'cancelled' | 'refused';

export function standingOf(state: SessionState): Standing {
  if (state.refusal !== null) return 'refused';
  const answer = answerOf(state);
  if (!answer || isAnswerTo(answer, state)) return 'asked';
  return state.progress === null ? 'cancelled' : 'running';
}

function isAnswerTo(answer: Reduced, { bounds, method, keeping }: Asked): boolean {
  return answer.bounds === bounds && sameMethod(answer.method, method) && sameKeeping(answer.keeping, keeping);
}

/** What is to be seen of a session: the answer at hand. */
export function answerOf({ provisional, reduced }: SessionState): Reduced | null {
  return provisional ?? reduced;
}
