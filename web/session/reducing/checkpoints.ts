import type { Checkpoint, VariableReport } from '../../../wasm/types.ts';
import { type BoundSetting, wholeOf } from '../bounds/bound-setting.ts';
import { isMultiplied, sameKeeping } from '../constraints/keeping.ts';
import { sameMethod } from '../constraints/method.ts';
import type { Asked } from '../session-state.ts';

interface Kept extends Omit<Asked, 'bounds'> {
  checkpoints: Checkpoint[];
}

/** What is left of a bound behind a checkpoint that has spent more of it than this is worth little. */
const mostSpent = 0.5;

/** Who waits no longer than this for the answer from the original, in seconds, has it at once and needs none before. */
const soon = 0.15;

/** Of so many reductions checkpoints are kept: of the last one, and of the one before, whose bounds may have been finer. */
const mostKept = 2;

/** Whether a reduction may go on from a checkpoint: what only the original can tell forbids it. */
export function canResume({ method, keeping }: Omit<Asked, 'bounds'>): boolean {
  return !method.limitToFeatureSize && !method.dropSmallComponents && !isMultiplied(keeping);
}

/** From where a reduction of the surface that is open may go on, without beginning at the original. */
export class Checkpoints {
  #kept: Kept[] = [];

  /** Takes those of a reduction: its result, and what it passed on its way, if it gave that out. */
  keep(result: Checkpoint, passed: Checkpoint | undefined, { method, keeping }: Asked): void {
    if (!passed || result.report.seconds < soon) return;
    const { mesh, vertices, report } = result; // the map is as large as the original
    const checkpoints = [{ mesh, vertices, report }, passed];
    this.#kept = [{ checkpoints, method, keeping }, ...this.#kept].slice(0, mostKept);
  }

  clear(): void {
    this.#kept = [];
  }

  /** The coarsest from which these bounds can be kept; null where there is none. */
  nearest({ bounds, method, keeping }: Asked): Checkpoint | null {
    const usable = this.#kept
      .filter((kept) => sameMethod(kept.method, method) && sameKeeping(kept.keeping, keeping))
      .flatMap(({ checkpoints }) => checkpoints)
      .filter(({ report }) => report.variables.every((variable) => leavesEnough(variable, bounds[variable.name])));
    usable.sort((a, b) => a.mesh.triangles.length - b.mesh.triangles.length);
    return usable[0] ?? null;
  }
}

/** What was free and is bounded now counts by its error, as everything does. */
function leavesEnough(variable: VariableReport, { fraction, absolute, free }: BoundSetting): boolean {
  return free || variable.error <= mostSpent * (absolute ?? fraction * wholeOf(variable));
}
