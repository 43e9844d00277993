import { asBounds } from '../bounds/bound-setting.ts';
import type { OpenSurface } from '../reading/open-surface.ts';
import type { Services } from '../services.ts';
import type { Asked, Reduced } from '../session-state.ts';
import { canResume } from './checkpoints.ts';
import { Latest, superseded } from './latest.ts';
import { ProvisionalAnswers } from './provisional-answers.ts';
import { resultOf, taskOf } from './task.ts';

/**
 * A slider that is being dragged sends many changes. Until it rests this long, in milliseconds, they are answered from a
 * checkpoint; where there is none, a reduction that runs goes on meanwhile, though of earlier bounds, and shows the way. Then
 * the reduction with the last of them starts.
 */
const restBeforeReducing = 60;

/** Who asks, and is told of the answers. */
export interface Asking {
  /** What is asked now. */
  readonly state: Asked & { surface: OpenSurface | null };
  /** A reduction from the original begins: what was said of the one before holds no longer. */
  began(): void;
  progressed(progress: number): void;
  answered(provisional: Reduced): void;
  /** @param goesOn these were earlier bounds, and those of now are yet to be answered */
  reduced(reduced: Reduced, goesOn: boolean): void;
  failed(error: unknown): void;
}

/** When what is reduced, so that moving bounds are answered at once, and in the end by the reduction from the original. */
export class Reducing {
  #reduce: Services['reduce'];
  #asking: Asking;
  #running = new Latest();
  #provisional: ProvisionalAnswers;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** The bounds have changed since the reduction that runs began. */
  #isStale = false;

  constructor({ reduce, resumeReduction }: Services, asking: Asking) {
    this.#reduce = reduce;
    this.#asking = asking;
    this.#provisional = new ProvisionalAnswers(resumeReduction);
  }

  stop(): void {
    clearTimeout(this.#timer);
    this.#isStale = false;
    this.#running.abort();
    this.#provisional.abort();
  }

  /** Stops, and keeps nothing of the surface that was reduced: there is another one. */
  forget(): void {
    this.stop();
    this.#provisional.checkpoints.clear();
  }

  /** Answers bounds that have changed: from a checkpoint at once, and from the original when they rest. */
  follow(): void {
    clearTimeout(this.#timer);
    if (this.#provisional.isRunning) return; // and goes on to these
    if (this.#provisional.checkpoints.nearest(this.#asking.state)) {
      this.#running.abort();
      void this.#answer();
    } else if (this.#running.isRunning) {
      this.#isStale = true;
      this.#startAtRest();
    } else {
      void this.start();
    }
  }

  /** From the original, so that the result does not depend on which way the sliders took. */
  async start(): Promise<void> {
    clearTimeout(this.#timer);
    this.#isStale = false;
    this.#provisional.abort();
    const { surface, bounds, method, keeping } = this.#asking.state;
    if (!surface) return;
    const asked = { bounds, method, keeping };
    this.#asking.began();
    try {
      const outcome = await this.#running.run((signal) => this.#fromOriginal(surface, asked, signal));
      if (outcome === superseded) return;
      const { checkpoint, ...result } = outcome;
      const reduced = { result, ...asked };
      this.#provisional.checkpoints.keep(result, checkpoint, reduced);
      this.#asking.reduced(reduced, this.#isStale);
    } catch (error) {
      if (!this.#isStale) this.#asking.failed(error);
    }
    if (this.#isStale) this.follow();
  }

  async #fromOriginal(surface: OpenSurface, { bounds, method, keeping }: Asked, signal: AbortSignal) {
    const task = taskOf(surface, method, keeping);
    const onProgress = (progress: number) => {
      if (!signal.aborted) this.#asking.progressed(progress);
    };
    const checkpoint = canResume({ method, keeping });
    const options = { bounds: asBounds(bounds), ...task.options, checkpoint, signal, onProgress };
    return resultOf(task, await this.#reduce(task.mesh, options));
  }

  async #answer(): Promise<void> {
    this.#isStale = false;
    const question = () => this.#asking.state;
    const isAnswered = await this.#provisional.follow(question, (answer) => this.#asking.answered(answer));
    if (isAnswered) this.#startAtRest();
  }

  #startAtRest(): void {
    this.#timer = setTimeout(() => void this.start(), restBeforeReducing);
  }
}
