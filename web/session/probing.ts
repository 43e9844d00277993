import type { Mesh, Reduction, Segmentation } from '../../wasm/types.ts';
import { Correspondence } from '../probe/correspondence.ts';
import type { Place } from '../probe/place.ts';
import { type Probe, type Probed, probeAt, probePair, type Side } from '../probe/probe.ts';
import { isMapped, worstOnReduced, worstPlace } from '../probe/worst-place.ts';
import { Latest, superseded } from './reducing/latest.ts';

/** A point of one of the surfaces; with its image where that is known beforehand. */
interface Point {
  from: Side;
  place: Place;
  image?: Place;
}

/** Never changed in place: a change replaces it. */
export interface ProbeState {
  /** What stands at the place that is pointed at; null where none is. */
  probe: Probe | null;
  /** The place stays until it is let go. */
  pinned: boolean;
  /** The place on the other surface is still looked for. */
  pending: boolean;
}

export const nothingProbed: ProbeState = { probe: null, pinned: false, pending: false };

type Segment = (mesh: Mesh, reduction: Reduction, watchers: { signal?: AbortSignal }) => Promise<Segmentation>;

/**
 * Which place of the surfaces is looked at, and what stands there. The surfaces are cut by their map when a place is first
 * asked for; until that is done only one of them is known. Emits `change` whenever its state changes.
 */
export class Probing extends EventTarget {
  #segment: Segment;
  #cutting = new Latest();
  #probed: Probed | null = null;
  #point: Point | null = null;
  #state = nothingProbed;
  #mayCut = true;
  /** What could not be cut, not to try it again and again. */
  #uncuttable: Reduction | null = null;
  #report: (error: unknown) => void;

  /** @param report told of what is wrong where the surfaces cannot be cut: then one of them is known still */
  constructor(segment: Segment, report: (error: unknown) => void) {
    super();
    this.#segment = segment;
    this.#report = report;
  }

  get state(): ProbeState {
    return this.#state;
  }

  /** Whether surfaces may be cut now: while another reduction runs it must not wait for that. */
  set mayCut(may: boolean) {
    this.#mayCut = may;
    if (this.#point) void this.#cut();
  }

  /** Probes other surfaces. What is pinned stays at its place of the original, if that is the same. */
  follow(mesh: Mesh | null, reduction: Reduction | null): void {
    if (mesh === (this.#probed?.mesh ?? null) && reduction === (this.#probed?.reduction ?? null)) return;
    const { probe, pinned } = this.#state;
    const stays = pinned && mesh === this.#probed?.mesh ? (probe?.original ?? null) : null;
    this.#cutting.abort();
    this.#probed = mesh && { mesh, reduction, correspondence: null };
    this.#show(stays && { from: 'original', place: stays }, stays !== null);
  }

  /** Shows what stands at a place as long as it is pointed at; null where none is. What is pinned stays. */
  point(from: Side, place: Place | null): void {
    if (!this.#state.pinned) this.#show(place && { from, place }, false);
  }

  /** Stays at a place; null lets go. */
  pin(from: Side, place: Place | null): void {
    this.#show(place && { from, place }, place !== null);
  }

  /** Stays where a variable has its largest error; in the middle of a reduced triangle where only limits of it are known. */
  pinWorst(variable: string): void {
    const { mesh, reduction } = this.#probed ?? {};
    const index = reduction?.report.variables.findIndex(({ name }) => name === variable) ?? -1;
    if (!mesh || !reduction || index < 0) return;
    if (isMapped(reduction)) {
      const { original, reduced } = worstPlace(mesh, reduction, index);
      this.#show({ from: 'original', place: original, image: reduced }, true);
    } else {
      this.#show({ from: 'reduced', place: worstOnReduced(reduction, index) }, true);
    }
  }

  /** Stops what runs, and tells nobody. */
  stop(): void {
    this.#cutting.abort();
  }

  #show(point: Point | null, pinned: boolean): void {
    const same = point === null && this.#point === null && !this.#state.pinned;
    this.#point = point;
    if (!same) this.#update(pinned);
    if (point) void this.#cut();
  }

  #probe(): Probe | null {
    const [probed, point] = [this.#probed, this.#point];
    if (!probed || !point) return null;
    const { from, place, image } = point;
    if (!image) return probeAt(probed, from, place);
    return probePair(probed, from, place, image, Math.max(1, probed.correspondence?.preimages(image).length ?? 1));
  }

  /** Finds out which points of both surfaces belong together, once. */
  async #cut(): Promise<void> {
    const { mesh, reduction } = this.#probed ?? {};
    if (!mesh || !reduction || !isMapped(reduction) || !this.#isUncut) return;
    if (!this.#mayCut || this.#cutting.isRunning) return;
    try {
      const segmentation = await this.#cutting.run((signal) => this.#segment(mesh, reduction, { signal }));
      if (segmentation === superseded) return;
      this.#probed = { mesh, reduction, correspondence: new Correspondence(mesh, reduction, segmentation) };
      if (this.#point) this.#update(this.#state.pinned);
    } catch (error) {
      this.#uncuttable = reduction;
      if (this.#point) this.#update(this.#state.pinned);
      this.#report(error);
    }
  }

  /** Whether it is yet to be found out which points belong together. */
  get #isUncut(): boolean {
    const { reduction, correspondence } = this.#probed ?? {};
    return !!reduction && isMapped(reduction) && !correspondence && reduction !== this.#uncuttable;
  }

  #update(pinned: boolean): void {
    const probe = this.#probe();
    this.#state = { probe, pinned: pinned && probe !== null, pending: probe !== null && this.#isUncut };
    this.dispatchEvent(new Event('change'));
  }
}
