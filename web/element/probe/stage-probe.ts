import type { Mesh } from '../../../wasm/types.ts';
import { normalOf, type Place } from '../../probe/place.ts';
import type { Probe, Side } from '../../probe/probe.ts';
import type { Viewer } from '../../viewer/viewer.ts';
import type { View } from '../attributes/view-settings.ts';

const sides: readonly Side[] = ['original', 'reduced'];

/** So far, in CSS pixels, a pointer may move between press and release and still have clicked: farther, it turned the view. */
const clickReach = 4;

/** Where a place is seen. */
export interface Marker {
  side: Side;
  /** In CSS pixels from the stage's left and upper edge. */
  x: number;
  y: number;
  /** Whether something hides it: it is behind the surface, cut off, or beyond the divider. */
  hidden: boolean;
}

/** A point of a surface that is pointed at. */
export interface Pointed {
  from: Side;
  place: Place;
}

/** What a stage tells of itself to whom probes it. */
export interface ProbedStage {
  readonly viewer: Viewer | null;
  readonly panes: readonly HTMLElement[];
  readonly view: View;
  /** Where one surface ends and the other begins in a wipe, 0…1. */
  readonly divider: number;
  /** The mesh that a side has drawn; null where it shows none, or one that is not to be probed. */
  meshOf(side: Side): Mesh | null;
  /** Told of what is pointed at, and of what is to be pinned; null: nothing. */
  pointed(pointed: Pointed | null): void;
  pinned(pointed: Pointed | null): void;
}

/** Finds what is pointed at on a stage, by pointer or keys, and where a probed place is seen on it. */
export class StageProbe {
  #stage: ProbedStage;
  #nextPick = 0;
  #pressed: readonly [x: number, y: number] = [0, 0];

  constructor(stage: ProbedStage) {
    this.#stage = stage;
  }

  /** Once a frame: a pointer may move more often. */
  move(pane: number, { pointerType, buttons, clientX, clientY }: PointerEvent): void {
    // A finger turns and moves the surface; it probes by a tap.
    if (pointerType === 'touch') return;
    if (buttons !== 0) {
      this.leave();
      return;
    }
    cancelAnimationFrame(this.#nextPick);
    this.#nextPick = requestAnimationFrame(() => this.#stage.pointed(this.#pick(pane, clientX, clientY)));
  }

  /** Nothing is pointed at any more, or the view is turned. */
  leave(): void {
    cancelAnimationFrame(this.#nextPick);
    this.#stage.pointed(null);
  }

  press({ clientX, clientY }: PointerEvent): void {
    this.#pressed = [clientX, clientY];
  }

  click(pane: number, { clientX, clientY }: MouseEvent): void {
    const [x, y] = this.#pressed;
    if (Math.hypot(clientX - x, clientY - y) > clickReach) return;
    this.#stage.pinned(this.#pick(pane, clientX, clientY));
  }

  /** For those without a pointer: they move the surface under the middle of its pane. */
  pinMiddle(pane: number): void {
    const { left, top, width, height } = this.#stage.panes[pane].getBoundingClientRect();
    const pointed = this.#pick(pane, left + width / 2, top + height / 2);
    if (pointed) this.#stage.pinned(pointed);
  }

  /** Where a probed place is seen on the panes that are to be seen. */
  markers(probe: Probe | null): Marker[] {
    return sides.flatMap((side, pane) => this.#marker(side, pane, probe) ?? []);
  }

  /** Turns the surfaces until a probed place is in sight. */
  reveal(probe: Probe): void {
    const { viewer } = this.#stage;
    sides.forEach((side, pane) => {
      const [mesh, place] = [this.#stage.meshOf(side), probe[side]];
      if (!viewer || !mesh || !place || !this.#hasSize(pane) || this.#isSeen(pane, place.position)) return;
      const normal = normalOf(mesh, place.triangle);
      if (normal.every((each) => each === 0)) return;
      viewer.cameras.turnTo(pane, normal);
      if (this.#isSeen(pane, place.position)) return;
      viewer.cameras.fit();
      viewer.cameras.turnTo(pane, normal);
    });
  }

  #pick(pane: number, x: number, y: number): Pointed | null {
    const { viewer, view, divider, panes } = this.#stage;
    const { left, width } = panes[pane].getBoundingClientRect();
    // One over the other, the divider says whose surface is seen.
    const seen = view === 'wipe' ? Number(x > left + divider * width) : pane;
    const from = sides[seen];
    const place = this.#stage.meshOf(from) && viewer?.pick(seen, x, y);
    return place ? { from, place: { triangle: place.triangle, barycentric: place.barycentric } } : null;
  }

  #marker(side: Side, pane: number, probe: Probe | null): Marker | null {
    const { viewer, view, divider, panes } = this.#stage;
    const place = probe?.[side];
    if (!viewer || !place || !this.#hasSize(pane) || !this.#stage.meshOf(side)) return null;
    const seen = viewer.screenPlace(pane, place.position);
    if (!seen) return null;
    const { offsetLeft, offsetTop, clientWidth } = panes[pane];
    const beyond = view === 'wipe' && seen.x > divider * clientWidth === (side === 'original');
    return { side, x: offsetLeft + seen.x, y: offsetTop + seen.y, hidden: seen.hidden || beyond };
  }

  #isSeen(pane: number, position: readonly number[]): boolean {
    return this.#stage.viewer?.screenPlace(pane, position)?.hidden === false;
  }

  #hasSize(pane: number): boolean {
    return this.#stage.panes[pane].clientWidth > 0;
  }
}
