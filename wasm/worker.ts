import { isRaised } from './cancel-flag.ts';
import { type Core, loadCore } from './load-core.ts';
import type { Answer, Request } from './messages.ts';
import type { Ending, Outcome, Task, TaskKind, Value } from './tasks.ts';
import { transferables } from './transferables.ts';
import { parentPort } from './worker-port.ts';

type Continue = (progress: number) => boolean;

const perform: {
  [Kind in TaskKind]: (core: Core, input: Task<Kind>['input'], goOn: Continue) => Outcome<Value<Kind>>;
} = {
  reduce: (core, { mesh, options }, goOn) => core.reduce(mesh, options, goOn),
  resumeReduction: (core, { checkpoint, options }, goOn) => core.resumeReduction(checkpoint, options, goOn),
  reduceLevels: (core, { mesh, options }, goOn) => core.reduceLevels(mesh, options, goOn),
  segment: (core, { mesh, reduction }, goOn) => core.segment(mesh, reduction, goOn),
  inspect: (core, { mesh }) => core.inspect(mesh),
};

function endingOf<Kind extends TaskKind>(core: Core, { kind, input }: Task<Kind>, goOn: Continue): Ending<Kind> {
  return { kind, outcome: perform[kind](core, input, goOn) };
}

/** A trap or an exception of JavaScript: never the caller's fault. */
function unexpected({ kind }: Task, error: unknown): Ending {
  return { kind, outcome: { ok: false, failure: { code: 'internal', message: String(error) } } };
}

const port = parentPort();
let core: Promise<Core> | undefined;

async function answerTo({ task, cancel, settings }: Request): Promise<Answer> {
  const goOn = (progress: number): boolean => {
    port.post({ progress });
    return !isRaised(cancel);
  };
  try {
    core ??= loadCore(settings);
    const loaded = await core;
    return { ending: endingOf(loaded, task, goOn), memory: loaded.memorySize() };
  } catch (error) {
    return { ending: unexpected(task, error), memory: 0 };
  }
}

port.onRequest(async (request) => {
  const answer = await answerTo(request);
  port.post(answer, transferables(answer));
});
