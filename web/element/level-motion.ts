import type { LevelSession } from '../session/reducing/level-session.ts';

/** Milliseconds on the way from a level to the next: long enough to be smooth, short enough not to be waited for. */
const wayTime = 400;

/** The most of them that one frame takes: where frames are slow the way is longer, and no less smooth. */
const longestFrame = 50;

/**
 * Leads a level session to a level of its own accord, morphing on the way; at once for those who want less motion. It waits
 * where what is to be seen is not yet drawn.
 */
export class LevelMotion {
  #levels: LevelSession;
  #isDrawn: () => boolean;
  #target = 0;
  #frame = 0;
  #last = 0;

  /** @param isDrawn whether the position of the session is what one sees */
  constructor(levels: LevelSession, isDrawn: () => boolean) {
    this.#levels = levels;
    this.#isDrawn = isDrawn;
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
    // The first frame may have begun before it was asked for.
    const passed = Math.min(Math.max(now - this.#last, 0), longestFrame);
    const step = this.#isDrawn() ? passed / wayTime : 0;
    this.#last = now;
    const way = this.#target - position;
    const arrived = Math.abs(way) <= step;
    this.#frame = arrived || pixels === null ? 0 : requestAnimationFrame(this.#move);
    if (pixels !== null) this.#levels.arriveAt(arrived ? this.#target : position + Math.sign(way) * step);
  };
}
