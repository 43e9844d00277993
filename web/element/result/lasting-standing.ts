import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type { Session } from '../../session/session.ts';
import { type Standing, standingOf } from '../../session/session-state.ts';

/** Milliseconds after which an answer that is on its way is worth a word: most are there before anyone could read it. */
const worthAWord = 300;

/**
 * How the answer that is shown stands to what is asked for, in so far as it lasts: while a slider is dragged, answer follows
 * answer, and words about each would flicker.
 */
export class LastingStanding implements ReactiveController {
  value: Standing = 'asked';
  #host: ReactiveControllerHost;
  #session: Session;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(host: ReactiveControllerHost, session: Session) {
    this.#host = host;
    this.#session = session;
    host.addController(this);
  }

  hostConnected(): void {
    this.#session.addEventListener('change', this.#follow);
    this.#follow();
  }

  hostDisconnected(): void {
    clearTimeout(this.#timer);
    this.#session.removeEventListener('change', this.#follow);
  }

  #follow = (): void => {
    const now = standingOf(this.#session.state);
    if (now !== 'running') {
      clearTimeout(this.#timer);
      this.#timer = undefined;
      this.#become(now);
    } else if (this.value !== 'running') {
      this.#timer ??= setTimeout(() => this.#become('running'), worthAWord);
    }
  };

  #become(standing: Standing): void {
    this.#timer = undefined;
    if (standing === this.value) return;
    this.value = standing;
    this.#host.requestUpdate();
  }
}
