import type { Mesh, Verdict, VerifyOptions } from '../../wasm/types.ts';
import type { Multiplied } from '../probe/multiplied.ts';
import { messageOf } from './reading/failure.ts';
import { Latest, superseded } from './reducing/latest.ts';

/** Never changed in place: a change replaces it. */
export interface VerifyState {
  /** Of the judge at work, 0…1; null where none is. */
  progress: number | null;
  /** What the judge said of this result; null where it was not asked yet. */
  verdict: Verdict | null;
  /** Why it could not say anything. */
  fault: string | null;
}

export const notVerified: VerifyState = { progress: null, verdict: null, fault: null };

type Verify = (original: Mesh, reduced: Mesh, options: VerifyOptions) => Promise<Verdict>;

/** What is judged: a result with the surface that it was made of. */
interface Judged {
  mesh: Mesh;
  result: Multiplied;
}

/**
 * Has a result judged when somebody asks for it. What is said is of that result alone: another one is yet to be judged. Emits
 * `change` whenever its state changes.
 */
export class Verifying extends EventTarget {
  #verify: Verify;
  #running = new Latest();
  #judged: Judged | null = null;
  #state = notVerified;

  constructor(verify: Verify) {
    super();
    this.#verify = verify;
  }

  get state(): VerifyState {
    return this.#state;
  }

  /**
   * Says what there is to be judged.
   *
   * @param busy a reduction runs: it must not wait for a judge, who stops
   */
  follow(mesh: Mesh | null, result: Multiplied | null, busy: boolean): void {
    const isSame = mesh === (this.#judged?.mesh ?? null) && result === (this.#judged?.result ?? null);
    if (isSame && !(busy && this.#running.isRunning)) return;
    this.#running.abort();
    this.#judged = mesh && result && { mesh, result };
    this.#update(notVerified);
  }

  async start(): Promise<void> {
    if (!this.#judged) return;
    const { mesh, result } = this.#judged;
    this.#update({ ...notVerified, progress: 0 });
    try {
      const verdict = await this.#running.run((signal) => this.#ask(mesh, result, signal));
      if (verdict !== superseded) this.#update({ ...notVerified, verdict });
    } catch (error) {
      this.#update({ ...notVerified, fault: messageOf(error) });
    }
  }

  cancel(): void {
    this.#running.abort();
    this.#update(notVerified);
  }

  #ask(mesh: Mesh, { mesh: reduced, report, multiplier }: Multiplied, signal: AbortSignal): Promise<Verdict> {
    return this.#verify(mesh, reduced, {
      bounds: report.variables.map(({ bound }) => bound),
      multipliers: multiplier && Float64Array.from(multiplier),
      signal,
      onProgress: (progress) => {
        if (!signal.aborted) this.#update({ ...notVerified, progress });
      },
    });
  }

  #update(state: VerifyState): void {
    if (state === this.#state) return;
    this.#state = state;
    this.dispatchEvent(new Event('change'));
  }
}
