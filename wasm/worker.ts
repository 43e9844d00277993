import { isRaised } from './cancel-flag.ts';
import { type Core, loadCore } from './load-core.ts';
import type { Answer, Outcome, Request, Value } from './messages.ts';
import { transferables } from './transferables.ts';
import { type ParentPort, parentPort } from './worker-port.ts';

function perform(core: Core, { task, cancel }: Request, port: ParentPort): Outcome<Value> {
  if (task.kind === 'inspect') {
    return core.inspect(task.mesh);
  }
  const goOn = (progress: number): boolean => {
    port.post({ progress });
    return !isRaised(cancel);
  };
  if (task.kind === 'reduceOnward') {
    return core.reduceOnward(task.waypoint, task.options, goOn);
  }
  if (task.kind === 'reduceLevels') {
    return core.reduceLevels(task.mesh, task.options, goOn);
  }
  if (task.kind === 'segment') {
    return core.segment(task.mesh, task.reduction, goOn);
  }
  return core.reduce(task.mesh, task.options, goOn);
}

/** A trap or an exception of JavaScript: never the caller's fault. */
function unexpected(error: unknown): Outcome<never> {
  return { ok: false, failure: { code: 'internal', message: String(error) } };
}

const port = parentPort();
const core = loadCore();

port.onRequest(async (request) => {
  let answer: Answer;
  try {
    const loaded = await core;
    answer = { outcome: perform(loaded, request, port), memory: loaded.memorySize() };
  } catch (error) {
    answer = { outcome: unexpected(error), memory: 0 };
  }
  port.post(answer, transferables(answer));
});
