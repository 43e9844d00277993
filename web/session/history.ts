/**
 * Earlier and later states, for undo and redo. Never changed in place. Changes of one thing in a row are one step until
 * `settled`: a slider that is dragged gives one.
 */
export interface History<State> {
  past: readonly State[];
  present: State;
  future: readonly State[];
  /** What the last change was of; null where the next one is a step in any case. */
  open: string | null;
}

/** How many steps can be undone. */
const longest = 200;

export function historyOf<State>(present: State): History<State> {
  return { past: [], present, future: [], open: null };
}

/** @param of what is changed, for example the name of a variable; null for a step of its own */
export function changed<State>(
  { past, present, open }: History<State>,
  next: State,
  of: string | null,
): History<State> {
  const goesOn = of !== null && of === open;
  return { past: goesOn ? past : [...past, present].slice(-longest), present: next, future: [], open: of };
}

export function settled<State>(history: History<State>): History<State> {
  return { ...history, open: null };
}

/** The state before the last step; the same where there is none. */
export function undone<State>(history: History<State>): History<State> {
  const { past, present, future } = history;
  if (past.length === 0) return history;
  return { past: past.slice(0, -1), present: past[past.length - 1], future: [present, ...future], open: null };
}

/** The state before the last undo; the same where there is none. */
export function redone<State>(history: History<State>): History<State> {
  const { past, present, future } = history;
  if (future.length === 0) return history;
  return { past: [...past, present], present: future[0], future: future.slice(1), open: null };
}
