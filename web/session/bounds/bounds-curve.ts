import type { Mesh, ReduceOptions, Reduction } from '../../../wasm/types.ts';
import { sameKeeping } from '../constraints/keeping.ts';
import { sameMethod } from '../constraints/method.ts';
import { Latest, superseded } from '../reducing/latest.ts';
import { taskOf } from '../reducing/task.ts';
import type { SessionState } from '../session-state.ts';
import { asBounds, type BoundSettings, largestFraction, moveAll } from './bound-setting.ts';

/** How many triangles are left where the largest bound is this fraction, and the others stand in proportion to it. */
export interface CurvePoint {
  fraction: number;
  triangles: number;
}

/** Where the curve is measured: from the middle outwards, so that it soon says something. */
export const curveFractions = [0.01, 0.1, 0.001, 0.03, 0.003, 0.2];

/** Measuring begins once the session has rested so long, in milliseconds. */
const restBeforeMeasuring = 800;

type Reduce = (mesh: Mesh, options: ReduceOptions) => Promise<Reduction>;

/**
 * Triangles against bounds, for the mix of bounds that a session has. Measured while the session rests; whatever it does
 * comes first. Emits `change` when a point is new.
 */
export class BoundsCurve extends EventTarget {
  #reduce: Reduce;
  #measuring = new Latest();
  #timer: ReturnType<typeof setTimeout> | undefined;
  #points = new Map<number, number>();
  #state: SessionState | null = null;

  constructor(reduce: Reduce) {
    super();
    this.#reduce = reduce;
  }

  /** By rising bound. */
  get points(): CurvePoint[] {
    const points = [...this.#points].map(([fraction, triangles]) => ({ fraction, triangles }));
    return points.sort((a, b) => a.fraction - b.fraction);
  }

  /** Goes on from what the session is now; null stops measuring. */
  follow(state: SessionState | null): void {
    if (state && this.#state && !measuresSame(state, this.#state)) this.#points.clear();
    this.#measuring.abort();
    clearTimeout(this.#timer);
    this.#state = state ?? this.#state;
    if (!state?.reduced || state.progress !== null || state.opening) return;
    this.#keep(largestFraction(state.bounds), state.reduced.result);
    this.#timer = setTimeout(() => void this.#measure(state), restBeforeMeasuring);
  }

  async #measure(state: SessionState): Promise<void> {
    const { surface, bounds, method, keeping } = state;
    const fraction = curveFractions.find((each) => !this.#points.has(each));
    if (!surface || fraction === undefined) return;
    try {
      const { mesh, options } = taskOf(surface, method, keeping);
      const result = await this.#measuring.run((signal) =>
        this.#reduce(mesh, {
          bounds: asBounds(moveAll(bounds, fraction)),
          ...options,
          countFolds: false,
          signal,
        }),
      );
      if (result === superseded) return;
      this.#keep(fraction, result);
      await this.#measure(state);
    } catch {
      // A bound too fine, say: the curve goes on without this point.
    }
  }

  #keep(fraction: number, { report }: Reduction): void {
    this.#points.set(fraction, report.triangles.after);
    this.dispatchEvent(new Event('change'));
  }
}

/** Whether the curve of one state is that of the other: same but for bounds in the same proportions. */
function measuresSame(one: SessionState, other: SessionState): boolean {
  return (
    one.surface === other.surface &&
    sameMethod(one.method, other.method) &&
    sameKeeping(one.keeping, other.keeping) &&
    mixOf(one.bounds) === mixOf(other.bounds)
  );
}

/** Bounds that were moved in proportion are rounded, so their proportions are the same to this many digits only. */
const mixDigits = 2;

function mixOf(bounds: BoundSettings): string {
  if (Object.keys(bounds).length === 0) return '';
  const largest = largestFraction(bounds);
  const shares = Object.entries(bounds).map(([name, { fraction, free }]) => [
    name,
    free ? 'free' : (fraction / largest).toPrecision(mixDigits),
  ]);
  return JSON.stringify(shares);
}
