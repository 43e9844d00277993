import type { Setting, Simplify } from './peer.ts';

/** The fewest triangles found, and how. */
export interface Found {
  triangles: number;
  setting: Setting;
  /** The number of triangles asked for. */
  target: number;
  /** Runs of the peer. */
  runs: number;
}

/** How all weights together are tried first, then how those of the best are changed, coarse to fine. */
const firstFactors = [1, 0.25, 4, 0.06, 16];
const refinements = [2, 1.4, 1.2];
/** A setting is worth more runs if it passes with this part of the triangles of the best so far. More fail more often, but not always. */
const hopes = [0.97, 0.92];
/** Two numbers of triangles this close need no more bisection. */
const closeEnough = 0.985;
const largestStep = 0.5;

/**
 * Looks for the fewest triangles with which a peer's result passes: by bisection of the number for one setting, and by
 * moving from setting to setting as long as one is better. Ends after `allowance` runs, or where no move helps.
 */
export class Search {
  private best: Found;
  private runs = 0;

  constructor(
    private readonly simplify: Simplify,
    private readonly passes: (path: string) => Promise<boolean>,
    private readonly trial: string,
    /** Triangles and variables of the original. */
    private readonly original: { triangles: number; variables: number },
    private readonly allowance: number,
  ) {
    const { triangles } = original;
    this.best = { triangles, target: triangles, setting: this.uniform(1), runs: 0 };
  }

  async fewest(options: string[]): Promise<Found> {
    for (const factor of firstFactors) await this.descend(this.uniform(factor));
    for (const refinement of refinements) {
      let before: number;
      do {
        before = this.best.triangles;
        for (const move of this.moves(options, refinement)) await this.descend(move(this.best.setting));
      } while (this.best.triangles < before && !this.isOver());
    }
    return { ...this.best, runs: this.runs };
  }

  private uniform(factor: number): Setting {
    return { weights: Array(this.original.variables).fill(factor), options: [] };
  }

  private moves(options: string[], step: number): ((from: Setting) => Setting)[] {
    const steps = [step, 1 / step];
    const scaled = (from: Setting, factor: number, only?: number): Setting => ({
      ...from,
      weights: from.weights.map((weight, variable) =>
        only === undefined || only === variable ? weight * factor : weight,
      ),
    });
    const variables = this.original.variables > 1 ? [...Array(this.original.variables).keys()] : [];
    return [
      ...options.map((option) => (from: Setting) => toggled(from, option)),
      ...steps.map((factor) => (from: Setting) => scaled(from, factor)),
      ...variables.flatMap((variable) => steps.map((factor) => (from: Setting) => scaled(from, factor, variable))),
    ];
  }

  private isOver(): boolean {
    return this.runs >= this.allowance;
  }

  /** Whether the peer passes with at most `target` triangles, so that there is a new best. */
  private async improves(setting: Setting, target: number): Promise<boolean> {
    if (this.isOver()) return false;
    this.runs++;
    const triangles = await this.simplify(setting, target, this.trial);
    if (triangles === 0 || triangles >= this.best.triangles || !(await this.passes(this.trial))) return false;
    this.best = { triangles, target, setting, runs: this.runs };
    return true;
  }

  /** As few triangles as this setting gives, if that is fewer than the best so far. */
  private async descend(setting: Setting): Promise<void> {
    const isFirst = this.best.triangles === this.original.triangles;
    let fails = 0;
    if (!isFirst && !(await this.isHopeful(setting))) return;
    for (
      let step = isFirst ? largestStep : hopes[0] ** 2;
      fails === 0 && !this.isOver();
      step = Math.max(step ** 2, largestStep)
    ) {
      const target = Math.floor(this.best.triangles * step);
      if (target < 1) return;
      if (!(await this.improves(setting, target))) fails = target;
    }
    while (fails < closeEnough * this.best.triangles && !this.isOver()) {
      const target = Math.floor(Math.sqrt(fails * this.best.triangles));
      if (target <= fails) return;
      if (!(await this.improves(setting, target))) fails = target;
    }
  }

  private async isHopeful(setting: Setting): Promise<boolean> {
    const start = this.best.triangles;
    for (const hope of hopes) {
      if (await this.improves(setting, Math.floor(start * hope))) return true;
    }
    return false;
  }
}

function toggled({ weights, options }: Setting, option: string): Setting {
  const others = options.filter((one) => one !== option);
  return { weights, options: others.length < options.length ? others : [...options, option] };
}
