import { asBounds } from '../bounds/bound-setting.ts';
import type { OpenSurface } from '../reading/open-surface.ts';
import type { Services } from '../services.ts';
import type { Asked, Reduced } from '../session-state.ts';
import { Checkpoints } from './checkpoints.ts';
import { Latest, superseded } from './latest.ts';
import { taskOf } from './task.ts';

/** What is to be answered now. */
type Question = () => Asked & { surface: OpenSurface | null };

/**
 * Answers bounds that move: one answer after the other from checkpoints, each to the newest bounds; those in between are left
 * out. They keep their bounds, but depend on the way that the sliders took, and stand only until the original has been asked.
 */
export class ProvisionalAnswers {
  readonly checkpoints = new Checkpoints();
  #resumeReduction: Services['resumeReduction'];
  #running = new Latest();

  constructor(resumeReduction: Services['resumeReduction']) {
    this.#resumeReduction = resumeReduction;
  }

  get isRunning(): boolean {
    return this.#running.isRunning;
  }

  abort(): void {
    this.#running.abort();
  }

  /** Tells each answer, until the newest bounds have theirs or there is none. Resolves to whether it came so far. */
  async follow(question: Question, tell: (answer: Reduced) => void): Promise<boolean> {
    let answer: Reduced | null | typeof superseded;
    do {
      answer = await this.#running.run((signal) => this.#answer(question(), signal));
      if (answer === superseded) return false;
      if (answer) tell(answer);
    } while (answer && answer.bounds !== question().bounds);
    return true;
  }

  /** Null where no checkpoint serves, or where something is wrong: the reduction from the original will say what. */
  async #answer({ surface, ...asked }: ReturnType<Question>, signal: AbortSignal): Promise<Reduced | null> {
    const { bounds, method, keeping } = asked;
    const checkpoint = this.checkpoints.nearest(asked);
    if (!surface || !checkpoint) return null;
    const { options } = taskOf(surface, method, keeping);
    try {
      const result = await this.#resumeReduction(checkpoint, { bounds: asBounds(bounds), ...options, signal });
      return { result, bounds, method, keeping };
    } catch {
      return null;
    }
  }
}
