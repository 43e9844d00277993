import type { Setting, Simplify } from './peer.ts';

/** A run of a peer that passed. */
export interface Start {
  setting: Setting;
  /** The number of triangles asked for. */
  target: number;
}

/** The fewest triangles found, and how. */
export interface Found extends Start {
  triangles: number;
  /** Runs of the peer. */
  runs: number;
}

/** How all weights together are tried first, then how those of the best are changed, coarse to fine. */
const firstFactors = [1, 8, 64, 0.125];
const refinements = [2, 1.4, 1.2];
/**
 * A setting is worth more runs if it passes with one of these parts of the triangles of the best so far: several, for
 * results that fail with some triangles can pass with fewer.
 */
const hopes = [0.97, 0.85, 0.7];
const hope = hopes[0];
/** Two numbers of triangles this close need no more bisection. */
const closeEnough = 0.985;
const largestStep = 0.5;
/** A variable at fault gets this much more weight, so many times in a row. */
const moreWeight = 1.5;
const mends = 5;

/**
 * Looks for the fewest triangles with which a peer's result passes: by bisection of the number for one setting, and by
 * moving from setting to setting as long as one is better. Ends after `allowance` runs, or where no move helps.
 */
export class Search {
  private best: Found;
  private runs = 0;
  /** The variable at fault in the last run; 0 is position. */
  private fault = 0;

  constructor(
    private readonly simplify: Simplify,
    /** The variable at fault in a PLY file, or nothing where it passes. */
    private readonly beyond: (path: string) => Promise<number | undefined>,
    private readonly trial: string,
    /** Triangles and variables of the original. */
    private readonly original: { triangles: number; variables: number },
    private readonly allowance: number,
  ) {
    const { triangles } = original;
    this.best = { triangles, target: triangles, setting: this.uniform(1, []), runs: 0 };
  }

  /**
   * `options` are switched on and off; `starts` are the sets of them to begin with, after what was found `before`: by a
   * shorter search, or at tighter bounds.
   */
  async fewest(options: string[], starts: string[][], before: Start[] = []): Promise<Found> {
    for (const { setting, target } of before) {
      if (await this.improves(setting, target)) await this.descend(setting, hopes);
    }
    if (before.length > 0) await this.mend();
    for (const factor of firstFactors) {
      for (const start of starts) await this.descend(this.uniform(factor, start), hopes);
    }
    await this.mend();
    for (const option of options) await this.descend(toggled(this.best.setting, option));
    for (const refinement of refinements) {
      let before: number;
      do {
        before = this.best.triangles;
        for (const move of this.moves(refinement)) await this.descend(move(this.best.setting));
        await this.mend();
      } while (this.best.triangles < before && !this.isOver());
    }
    return { ...this.best, runs: this.runs };
  }

  private uniform(factor: number, options: string[]): Setting {
    return { weights: Array(this.original.variables).fill(factor), options };
  }

  private moves(step: number): ((from: Setting) => Setting)[] {
    const steps = [step, 1 / step];
    const variables = this.original.variables > 1 ? [...Array(this.original.variables).keys()] : [];
    return [
      ...steps.map((factor) => (from: Setting) => scaled(from, factor)),
      ...variables.flatMap((variable) => steps.map((factor) => (from: Setting) => scaled(from, factor, variable))),
    ];
  }

  private isOver(): boolean {
    return this.runs >= this.allowance;
  }

  /** Whether the peer passes with about `target` triangles, and fewer than the best so far; then this is the best. */
  private async improves(setting: Setting, target: number): Promise<boolean> {
    if (this.isOver() || target < 1) return false;
    this.runs++;
    const triangles = await this.simplify(setting, target, this.trial);
    if (triangles === 0 || triangles >= this.best.triangles) return false;
    const fault = await this.beyond(this.trial);
    this.fault = fault ?? this.fault;
    if (fault === undefined) this.best = { triangles, target, setting, runs: this.runs };
    return fault === undefined;
  }

  /** As few triangles as this setting gives, if that is fewer than the best so far. */
  private async descend(setting: Setting, parts = [hope]): Promise<void> {
    const isFirst = this.best.triangles === this.original.triangles;
    if (!isFirst && !(await this.isHopeful(setting, parts))) return;
    let fails = await this.leap(setting, isFirst ? largestStep : hope);
    while (fails < closeEnough * this.best.triangles && !this.isOver()) {
      const target = Math.floor(Math.sqrt(fails * this.best.triangles));
      if (target <= fails) return;
      if (!(await this.improves(setting, target))) fails = target;
    }
  }

  private async isHopeful(setting: Setting, parts: number[]): Promise<boolean> {
    const start = this.best.triangles;
    for (const part of parts) {
      if (await this.improves(setting, Math.floor(start * part))) return true;
    }
    return false;
  }

  /** Down in growing steps until two numbers of triangles in a row fail; returns the larger one. */
  private async leap(setting: Setting, firstStep: number): Promise<number> {
    let step = firstStep;
    for (;;) {
      const start = this.best.triangles;
      const target = Math.floor(start * step);
      step = Math.max(step ** 2, largestStep);
      if (await this.improves(setting, target)) continue;
      if (await this.improves(setting, Math.floor(start * Math.max(step ** 2, largestStep ** 2)))) continue;
      return Math.max(1, target);
    }
  }

  /** Shifts weight to the variable at fault, from the best setting on, for as long as that helps. */
  private async mend(): Promise<void> {
    let { setting } = this.best;
    for (let failures = 0; failures < mends && !this.isOver(); ) {
      if (await this.improves(setting, Math.floor(this.best.triangles * hope))) {
        failures = 0;
        continue;
      }
      failures++;
      setting = this.fault === 0 ? scaled(setting, 1 / moreWeight) : scaled(setting, moreWeight, this.fault - 1);
    }
  }
}

/** With the weight of one variable, or of all, times a factor. */
function scaled({ weights, options }: Setting, factor: number, only?: number): Setting {
  return {
    weights: weights.map((weight, variable) => (only === undefined || only === variable ? weight * factor : weight)),
    options,
  };
}

function toggled({ weights, options }: Setting, option: string): Setting {
  const others = options.filter((one) => one !== option);
  return { weights, options: others.length < options.length ? others : [...options, option] };
}
