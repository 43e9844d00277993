import { constants } from 'node:os';

const signals = ['SIGINT', 'SIGTERM', 'SIGHUP'] as const;

/** The user, or the system, ended the command by a signal. */
export class Interrupted extends Error {
  readonly signalNumber: number;

  constructor(signal: NodeJS.Signals) {
    super(`Interrupted by ${signal}; nothing was written.`);
    this.name = 'Interrupted';
    this.signalNumber = constants.signals[signal];
  }
}

/**
 * Runs with a signal that Ctrl-C aborts, so that what was begun can be cleared away. Rejects with Interrupted then.
 * Outside of this Ctrl-C ends the process at once, which is as well while nothing is being written.
 */
export async function interruptible<Value>(run: (signal: AbortSignal) => Promise<Value>): Promise<Value> {
  const controller = new AbortController();
  const interrupt = (signal: NodeJS.Signals) => controller.abort(new Interrupted(signal));
  for (const signal of signals) process.on(signal, interrupt);
  try {
    return await run(controller.signal);
  } catch (error) {
    throw controller.signal.aborted ? controller.signal.reason : error;
  } finally {
    for (const signal of signals) process.off(signal, interrupt);
  }
}
