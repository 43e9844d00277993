import type { Levels, LevelsOptions, Mesh } from '../../../wasm/index.ts';
import { asBounds, type BoundSettings, largestFraction, moveAll } from '../bounds/bound-setting.ts';
import type { OpenSurface } from '../reading/open-surface.ts';
import type { Session } from '../session.ts';
import { answerOf, type Reduced } from '../session-state.ts';
import { Latest, superseded } from './latest.ts';
import { levelsOf, taskOf } from './task.ts';

/** Levels of detail of the surface that is open. Never changed in place: a change replaces it. */
export interface LevelState {
  /** How many are wanted; 0: none. */
  count: number;
  /** Those of the last reduction, with the morphs between them; null where there are none. */
  nested: Levels | null;
  /** The same, each with what it was asked with; empty where there are none. */
  results: readonly Reduced[];
  /** Some are wanted, but no variable has a bound that could grow from level to level. */
  unbounded: boolean;
  /** Of making them, 0…1; null where none are being made. */
  progress: number | null;
  /** What is shown: 0 the original, 1 the finest level, … `count` the coarsest; in between on the way. */
  position: number;
  /** Chosen by its size on screen: the error may span this many pixels. Null where the position is the user's. */
  pixels: number | null;
}

/** More levels than this have bounds beyond any use. */
export const mostLevels = 6;

/** From level to level all bounds grow by this factor. */
export const levelFactor = 2;

function isUnbounded(bounds: BoundSettings): boolean {
  return Object.values(bounds).every(({ free }) => free);
}

/** All bounds times a factor. */
export function coarser(bounds: BoundSettings, factor: number): BoundSettings {
  const largest = largestFraction(bounds);
  return largest > 0 ? moveAll(bounds, largest * factor) : bounds;
}

/**
 * Makes levels of detail of every result of a session, if any are wanted, but of no provisional one: the finest has the
 * session's bounds. Emits `change`
 * whenever its state changes; faults become notices of the session.
 */
export class LevelSession extends EventTarget {
  #session: Session;
  #reduceLevels: (mesh: Mesh, options: LevelsOptions) => Promise<Levels>;
  #making = new Latest();
  #of: Reduced | null = null;
  #state: LevelState = {
    count: 0,
    nested: null,
    results: [],
    unbounded: false,
    progress: null,
    position: 1,
    pixels: null,
  };

  constructor(session: Session, reduceLevels: (mesh: Mesh, options: LevelsOptions) => Promise<Levels>) {
    super();
    this.#session = session;
    this.#reduceLevels = reduceLevels;
    session.addEventListener('change', () => this.#follow());
  }

  get state(): LevelState {
    return this.#state;
  }

  /** The level that is shown, or on the way to which it is; of the original the finest. Null where there are none. */
  get shown(): Reduced | null {
    return this.#state.results[Math.max(1, Math.ceil(this.#state.position)) - 1] ?? null;
  }

  /** How many levels there are to be; 0 for none. */
  setCount(count: number): void {
    if (count === this.#state.count) return;
    this.#update({ count, position: 1 });
    this.#start();
  }

  /** Shows a level, or the way between two, and no longer what its size on screen asks for. */
  setPosition(position: number): void {
    this.#update({ pixels: null });
    this.arriveAt(position);
  }

  /** Has the level chosen by its size on screen; null: by the position. */
  setPixels(pixels: number | null): void {
    this.#update({ pixels });
  }

  /** Shows what the size on screen asks for. */
  arriveAt(position: number): void {
    this.#update({ position: Math.min(Math.max(position, 0), this.#state.count) });
  }

  #follow(): void {
    const answer = answerOf(this.#session.state);
    if (answer === this.#of) return;
    this.#of = answer;
    this.#start();
  }

  #start(): void {
    this.#making.abort();
    this.#session.forget('levels');
    const { surface, provisional } = this.#session.state;
    const unbounded = this.#state.count > 0 && this.#of !== null && isUnbounded(this.#of.bounds);
    const wanted = this.#state.count > 0 && this.#of !== null && surface !== null && provisional === null && !unbounded;
    this.#update({ nested: null, results: [], unbounded, progress: wanted ? 0 : null });
    if (wanted) void this.#make(surface, this.#of as Reduced);
  }

  async #make(surface: OpenSurface, { bounds, method, keeping }: Reduced): Promise<void> {
    const all = Array.from({ length: this.#state.count }, (_, level) => coarser(bounds, levelFactor ** level));
    const levels = all.map(asBounds);
    try {
      const nested = await this.#making.run(async (signal) => {
        const task = taskOf(surface, method, keeping);
        const onProgress = (progress: number) => {
          if (!signal.aborted) this.#update({ progress });
        };
        const options = { levels, morphs: true, ...task.options, signal, onProgress };
        return levelsOf(task, await this.#reduceLevels(task.mesh, options));
      });
      if (nested === superseded) return;
      const results = nested.levels.map((result, level) => ({ result, bounds: all[level], method, keeping }));
      this.#update({ nested, results, progress: null });
    } catch (error) {
      this.#update({ progress: null });
      this.#session.report(error, { about: 'levels' });
    }
  }

  #update(change: Partial<LevelState>): void {
    this.#state = { ...this.#state, ...change };
    this.dispatchEvent(new Event('change'));
  }
}
