import type { LevelSession } from '../session/level-session.ts';

/** Milliseconds on the way from a level to the next: long enough to be smooth, short enough not to be waited for. */
const wayTime = 400;

/** Leads a level session to a level of its own accord, morphing on the way; at once for those who want less motion. */
export class LevelMotion {
  #levels: LevelSession;
  #target = 0;
  #frame = 0;
  #last = 0;

  constructor(levels: LevelSession) {
    this.#levels = levels;
  }

  /** Goes to a level, from wherever it is. */
  towards(level: number): void {
    this.#target = level;
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) this.#levels.arriveAt(level);
    else if (!this.#frame && level !== this.#levels.state.position) this.#start();
  }

  stop(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
  }

  #start(): void {
    this.#last = performance.now();
    this.#frame = requestAnimationFrame(this.#move);
  }

  #move = (now: number): void => {
    const { position, pixels } = this.#levels.state;
    const step = (now - this.#last) / wayTime;
    this.#last = now;
    const way = this.#target - position;
    const arrived = Math.abs(way) <= step;
    this.#frame = arrived || pixels === null ? 0 : requestAnimationFrame(this.#move);
    if (pixels !== null) this.#levels.arriveAt(arrived ? this.#target : position + Math.sign(way) * step);
  };
}
