import type { Session } from '../../session/session.ts';
import type { Reduced } from '../../session/session-state.ts';
import { english } from '../../words/english.ts';

/**
 * What the reduction that runs comes to, provisional answers aside. Rejects with an AbortError where it is aborted, another
 * surface takes its place or the session stops, and with an Error that says why where it fails: who waits is always told.
 */
export function outcomeOf(session: Session): Promise<Reduced> {
  const { surface, reduced: before } = session.state;
  return new Promise((resolve, reject) => {
    const waiting = new AbortController();
    const end = (tell: () => void) => {
      waiting.abort();
      tell();
    };
    const abort = () => end(() => reject(new DOMException(english.faults.aborted, 'AbortError')));
    const look = () => {
      const { state } = session;
      if (state.surface !== surface || state.cancelled) abort();
      else if (state.progress !== null) return;
      else if (state.reduced && state.reduced !== before) end(() => resolve(state.reduced as Reduced));
      else end(() => reject(new Error(faultOf(session) ?? english.faults.failed)));
    };
    session.addEventListener('change', look, { signal: waiting.signal });
    session.addEventListener('stop', abort, { signal: waiting.signal });
  });
}

function faultOf({ state }: Session): string | undefined {
  return state.notices.findLast(({ ofReduction }) => ofReduction)?.text;
}
