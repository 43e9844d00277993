import { isRaised } from './cancel-flag.ts';
import { type Core, loadCore } from './load-core.ts';
import { type Judge, loadJudge } from './load-judge.ts';
import type { Answer, Request } from './messages.ts';
import type { ModuleSettings } from './module-settings.ts';
import type { Ending, Outcome, Task, TaskKind, Value } from './tasks.ts';
import { transferables } from './transferables.ts';
import { parentPort } from './worker-port.ts';

type Continue = (progress: number) => boolean;

/** The WebAssembly modules of this worker, each loaded when it is first needed. */
class Modules {
  private loadedCore: Promise<Core> | undefined;
  private loadedJudge: Promise<Judge> | undefined;

  core(settings: ModuleSettings): Promise<Core> {
    this.loadedCore ??= loadCore(settings);
    return this.loadedCore;
  }

  judge(settings: ModuleSettings): Promise<Judge> {
    this.loadedJudge ??= loadJudge(settings);
    return this.loadedJudge;
  }

  /** What they hold, in bytes. */
  async memorySize(): Promise<number> {
    const [core, judge] = [await this.loadedCore, await this.loadedJudge];
    return (core?.memorySize() ?? 0) + (judge?.memorySize() ?? 0);
  }
}

const modules = new Modules();

const perform: {
  [Kind in TaskKind]: (
    input: Task<Kind>['input'],
    settings: ModuleSettings,
    goOn: Continue,
  ) => Promise<Outcome<Value<Kind>>>;
} = {
  reduce: async ({ mesh, options }, settings, goOn) => (await modules.core(settings)).reduce(mesh, options, goOn),
  resumeReduction: async ({ checkpoint, options }, settings, goOn) =>
    (await modules.core(settings)).resumeReduction(checkpoint, options, goOn),
  reduceLevels: async ({ mesh, options }, settings, goOn) =>
    (await modules.core(settings)).reduceLevels(mesh, options, goOn),
  segment: async ({ mesh, reduction }, settings, goOn) => (await modules.core(settings)).segment(mesh, reduction, goOn),
  verify: async ({ original, reduced, options }, settings, goOn) =>
    (await modules.judge(settings)).verify(original, reduced, options, goOn),
  inspect: async ({ mesh }, settings) => (await modules.core(settings)).inspect(mesh),
};

async function endingOf<Kind extends TaskKind>(
  { kind, input }: Task<Kind>,
  settings: ModuleSettings,
  goOn: Continue,
): Promise<Ending<Kind>> {
  return { kind, outcome: await perform[kind](input, settings, goOn) };
}

/** A trap or an exception of JavaScript: never the caller's fault. */
function unexpected({ kind }: Task, error: unknown): Ending {
  return { kind, outcome: { ok: false, failure: { code: 'internal', message: String(error) } } };
}

const port = parentPort();

async function answerTo({ task, cancel, settings }: Request): Promise<Answer> {
  const goOn = (progress: number): boolean => {
    port.post({ progress });
    return !isRaised(cancel);
  };
  try {
    const ending = await endingOf(task, settings, goOn);
    return { ending, memory: await modules.memorySize() };
  } catch (error) {
    return { ending: unexpected(task, error), memory: 0 };
  }
}

port.onRequest(async (request) => {
  const answer = await answerTo(request);
  port.post(answer, transferables(answer));
});
