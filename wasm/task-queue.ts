import { type CancelFlag, createCancelFlag, raise } from './cancel-flag.ts';
import { abortError, type Failure, MeshboundError } from './errors.ts';
import type { Answer } from './messages.ts';
import type { ModuleSettings } from './module-settings.ts';
import type { Ending, Task, TaskKind, Value } from './tasks.ts';
import { transferables } from './transferables.ts';
import { startWorker, type WorkerThread } from './worker-thread.ts';

/** Who waits for the value of a task of each kind. */
type Receivers = { [Kind in TaskKind]?: (value: Value<Kind>) => void };

interface Job {
  task: Task;
  cancel: CancelFlag | undefined;
  onProgress: ((progress: number) => void) | undefined;
  /** One, for the kind of the task. */
  receivers: Receivers;
  reject(reason: unknown): void;
  /** Its signal was aborted: the caller has been told, whatever still arrives is dropped. */
  aborted: boolean;
}

interface Watchers {
  signal?: AbortSignal;
  onProgress?: (progress: number) => void;
}

/** WebAssembly never gives memory back. A worker may keep this much of it, in bytes, whatever it is asked next… */
const keptMemory = 128 * 2 ** 20;
/** …and so many times what the arrays of its next task take; a reduction takes some 25 times that. */
const keptRatio = 100;

/** How the queue's worker is started, and what it loads. */
export interface WorkerSettings extends ModuleSettings {
  /** Where the worker's script lies; beside this module where this is not said. */
  workerUrl?: string;
}

/**
 * Runs tasks one after the other in one worker, which is started at the first and kept for all; only a worker that a large
 * task has left with memory that a small one does not need makes room for another.
 */
export class TaskQueue {
  private worker: WorkerThread | undefined;
  /** What the worker holds since its last task, in bytes. */
  private memory = 0;
  private running: Job | undefined;
  private readonly waiting: Job[] = [];
  private disposed = false;

  constructor(private readonly settings: WorkerSettings = {}) {}

  run<Kind extends TaskKind>(task: Task<Kind> & Task, { signal, onProgress }: Watchers = {}): Promise<Value<Kind>> {
    return new Promise((resolve, reject) => {
      if (signal?.aborted || this.disposed) {
        reject(this.disposed ? disposedError() : abortError());
        return;
      }
      const onAbort = () => this.abort(job);
      const settled = () => signal?.removeEventListener('abort', onAbort);
      const job: Job = {
        task,
        cancel: signal ? createCancelFlag() : undefined,
        onProgress,
        receivers: receiverOf<Kind>(task.kind, (value) => {
          settled();
          resolve(value);
        }),
        reject: (reason) => {
          settled();
          reject(reason);
        },
        aborted: false,
      };
      signal?.addEventListener('abort', onAbort);
      this.waiting.push(job);
      this.next();
    });
  }

  /** Ends the worker. What runs or waits is rejected, as is whatever is asked later. */
  dispose(): void {
    this.disposed = true;
    this.stopWorker();
    const jobs = [...(this.running ? [this.running] : []), ...this.waiting.splice(0)];
    this.running = undefined;
    for (const job of jobs) job.reject(disposedError());
  }

  private next(): void {
    if (this.running) {
      return;
    }
    this.running = this.waiting.shift();
    if (this.running) {
      const { task, cancel } = this.running;
      const { wasmUrl, judgeUrl, threads } = this.settings;
      const arrays = transferables(task);
      if (this.holdsTooMuchFor(task, sizeOf(arrays))) {
        this.stopWorker();
      }
      this.worker ??= this.start();
      this.worker.post({ task, cancel, settings: { wasmUrl, judgeUrl, threads } }, arrays);
    }
  }

  /** Not for a resumed reduction: the one from the original, which is to follow, needs that memory again. */
  private holdsTooMuchFor({ kind }: Task, size: number): boolean {
    return kind !== 'resumeReduction' && this.memory > Math.max(keptMemory, keptRatio * size);
  }

  private start(): WorkerThread {
    const worker = startWorker(this.settings.workerUrl, {
      onAnswer: (answer) => {
        if (worker === this.worker) {
          this.receive(answer);
        }
      },
      onFailure: (reason) => {
        if (worker === this.worker) {
          this.fail(reason);
        }
      },
    });
    return worker;
  }

  private receive(answer: Answer): void {
    const job = this.running;
    if (!job) {
      return;
    }
    if ('ending' in answer) {
      this.memory = answer.memory;
      this.finish(job, answer.ending);
    } else if (!job.aborted) {
      job.onProgress?.(answer.progress);
    }
  }

  private finish(job: Job, ending: Ending): void {
    const { outcome } = ending;
    if (outcome.ok) {
      deliver(ending, job.receivers);
    } else {
      job.reject(new MeshboundError(outcome.failure));
      if (leavesWorkerUnfit(outcome.failure)) {
        this.stopWorker();
      }
    }
    this.running = undefined;
    this.next();
  }

  private fail(reason: string): void {
    this.stopWorker();
    this.running?.reject(new MeshboundError({ code: 'worker_failed', message: `The worker failed: ${reason}.` }));
    this.running = undefined;
    this.next();
  }

  private abort(job: Job): void {
    job.aborted = true;
    job.reject(abortError());
    if (job !== this.running) {
      this.waiting.splice(this.waiting.indexOf(job), 1);
    } else if (job.cancel) {
      raise(job.cancel);
    } else {
      this.stopWorker();
      this.running = undefined;
      this.next();
    }
  }

  private stopWorker(): void {
    this.worker?.terminate();
    this.worker = undefined;
    this.memory = 0;
  }
}

function receiverOf<Kind extends TaskKind>(kind: Kind, receive: (value: Value<Kind>) => void): Receivers {
  const receivers: Receivers = {};
  receivers[kind] = receive;
  return receivers;
}

function deliver<Kind extends TaskKind>({ kind, outcome }: Ending<Kind>, receivers: Receivers): void {
  if (outcome.ok) {
    receivers[kind]?.(outcome.value);
  }
}

function disposedError(): MeshboundError {
  return new MeshboundError({ code: 'disposed', message: 'The engine was disposed of.' });
}

function sizeOf(arrays: ArrayBuffer[]): number {
  return arrays.reduce((sum, { byteLength }) => sum + byteLength, 0);
}

/** WebAssembly never gives memory back, and after a trap its state is unknown. */
function leavesWorkerUnfit({ code }: Failure): boolean {
  return code === 'out_of_memory' || code === 'internal';
}
