import { type CancelFlag, createCancelFlag, raise } from './cancel-flag.ts';
import { abortError, type Failure, MeshboundError } from './errors.ts';
import type { Answer, Outcome, Task, Value } from './messages.ts';
import { transferables } from './transferables.ts';
import { startWorker, type WorkerThread } from './worker-thread.ts';

interface Job {
  task: Task;
  cancel: CancelFlag | undefined;
  onProgress: ((progress: number) => void) | undefined;
  resolve(value: Value): void;
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

  run(task: Task, { signal, onProgress }: Watchers = {}): Promise<Value> {
    return new Promise((resolve, reject) => {
      if (signal?.aborted) {
        reject(abortError());
        return;
      }
      const onAbort = () => this.abort(job);
      const job: Job = {
        task,
        cancel: signal ? createCancelFlag() : undefined,
        onProgress,
        resolve: (value) => {
          signal?.removeEventListener('abort', onAbort);
          resolve(value);
        },
        reject: (reason) => {
          signal?.removeEventListener('abort', onAbort);
          reject(reason);
        },
        aborted: false,
      };
      signal?.addEventListener('abort', onAbort);
      this.waiting.push(job);
      this.next();
    });
  }

  private next(): void {
    if (this.running) {
      return;
    }
    this.running = this.waiting.shift();
    if (this.running) {
      const { task, cancel } = this.running;
      const arrays = transferables(task);
      if (this.holdsTooMuchFor(task, sizeOf(arrays))) {
        this.stopWorker();
      }
      this.worker ??= this.start();
      this.worker.post({ task, cancel }, arrays);
    }
  }

  /** Not for a reduction onward: the one from the original, which is to follow, needs that memory again. */
  private holdsTooMuchFor({ kind }: Task, size: number): boolean {
    return kind !== 'reduceOnward' && this.memory > Math.max(keptMemory, keptRatio * size);
  }

  private start(): WorkerThread {
    const worker = startWorker({
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
    if ('outcome' in answer) {
      this.memory = answer.memory;
      this.finish(job, answer.outcome);
    } else if (!job.aborted) {
      job.onProgress?.(answer.progress);
    }
  }

  private finish(job: Job, outcome: Outcome<Value>): void {
    if (outcome.ok) {
      job.resolve(outcome.value);
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

function sizeOf(arrays: ArrayBuffer[]): number {
  return arrays.reduce((sum, { byteLength }) => sum + byteLength, 0);
}

/** WebAssembly never gives memory back, and after a trap its state is unknown. */
function leavesWorkerUnfit({ code }: Failure): boolean {
  return code === 'out_of_memory' || code === 'internal';
}
