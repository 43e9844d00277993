/** Runs one task at a time: starting another aborts the one before, and only the latest one's outcome is reported. */
export class Latest {
  #controller: AbortController | null = null;

  /** Resolves to the task's outcome, or to `superseded` where a newer task (or abort) took its place. */
  async run<Outcome>(task: (signal: AbortSignal) => Promise<Outcome>): Promise<Outcome | typeof superseded> {
    this.abort();
    const controller = new AbortController();
    this.#controller = controller;
    try {
      const outcome = await task(controller.signal);
      return controller.signal.aborted ? superseded : outcome;
    } catch (error) {
      if (controller.signal.aborted) return superseded;
      throw error;
    } finally {
      if (this.#controller === controller) this.#controller = null;
    }
  }

  get isRunning(): boolean {
    return this.#controller !== null;
  }

  abort(): void {
    this.#controller?.abort();
    this.#controller = null;
  }
}

export const superseded = Symbol('superseded');
