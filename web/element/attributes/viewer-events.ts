import type { Levels } from '../../../wasm/types.ts';
import type { ProbeState } from '../../session/probing.ts';
import type { LevelState } from '../../session/reducing/level-session.ts';
import type { SessionState } from '../../session/session-state.ts';
import { overall, type Phase, type Step } from '../result/progress.ts';

/** Tells the page around a viewer what happens in it, by events: of each change once, however often it is asked to. */
export class ViewerEvents {
  #viewer: EventTarget;
  /** What the work that goes on began with, and what was last told of it. */
  #first: Phase | null = null;
  #step: Step | null = null;
  #levels: Levels | null = null;
  #level = 1;
  #pin: readonly number[] | null = null;

  /** @param viewer from which the events come */
  constructor(viewer: EventTarget) {
    this.#viewer = viewer;
  }

  /** How far everything is that goes on, 0…1; null where nothing does. */
  get progress(): number | null {
    return this.#step && this.#first && overall(this.#step, this.#first);
  }

  opened(before: SessionState, { surface }: SessionState): void {
    if (!surface || surface === before.surface) return;
    this.#fire('load', { name: surface.name, variables: surface.variables.map(({ name }) => name) });
  }

  /** Not of what is provisional. */
  reduced(before: SessionState, { reduced }: SessionState): void {
    if (reduced && reduced !== before.reduced) this.#fire('reduce', reduced.result.report);
  }

  failed(before: SessionState, { notices }: SessionState): void {
    for (const { kind, code, text } of notices.filter((notice) => !before.notices.includes(notice))) {
      if (kind === 'error') this.#fire('error', { code, message: text });
    }
  }

  /** @param step null where nothing goes on any more */
  progressed(step: Step | null): void {
    const told = this.#step;
    this.#step = step;
    if (step) {
      this.#first ??= step.phase;
      if (told?.phase === step.phase && told.progress === step.progress) return;
      this.#fire('progress', { phase: step.phase, progress: overall(step, this.#first) });
    } else if (this.#first) {
      this.#first = null;
      if (told?.phase === 'draw') this.#fire('progress', { phase: 'draw', progress: 1 });
    }
  }

  levels({ nested, position }: LevelState): void {
    const [levels, level] = [this.#levels, this.#level];
    this.#levels = nested;
    this.#level = position;
    const reports = nested?.levels.map(({ report }) => report);
    if (reports && nested !== levels) this.#fire('levels', reports);
    if (position !== level) this.#fire('level-change', { level: position });
  }

  /** Of a place that is looked for on the other surface still, not before it is known there. */
  probed({ probe, pinned, pending }: ProbeState): void {
    if (!pending) this.#fire('probe', { probe, pinned });
    const place = (pinned && probe?.original?.position) || null;
    if (`${place}` === `${this.#pin}`) return;
    this.#pin = place;
    this.#fire('pin', { place });
  }

  cameraMoved(camera: string | null): void {
    this.#fire('camera-change', { camera });
  }

  #fire(name: string, detail: unknown): void {
    this.#viewer.dispatchEvent(new CustomEvent(name, { detail }));
  }
}
