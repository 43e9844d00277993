import type { CancelFlag } from './cancel-flag.ts';
import type { ModuleSettings } from './module-settings.ts';
import type { Ending, Task } from './tasks.ts';

/**
 * To the worker: one task at a time. `cancel`, where memory can be shared, is raised to stop it. The first request says how
 * the WebAssembly module is loaded; those of the following ones are the same.
 */
export interface Request {
  task: Task;
  cancel?: CancelFlag;
  settings: ModuleSettings;
}

/** From the worker: any number of progress messages, then how the task ended and how much memory the worker holds by now. */
export type Answer = { progress: number } | { ending: Ending; memory: number };
