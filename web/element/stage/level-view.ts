import type { Levels, Mesh, Morph, Reduction } from '../../../wasm/types.ts';
import { placeByShare, placeBySign } from '../../colour/error-places.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import type { MorphSource } from '../../viewer/prepare-morph.ts';
import type { ViewSettings } from '../attributes/view-settings.ts';
import { type Colouring, valueColouring } from './colouring.ts';
import { reducedErrors } from './error-colouring.ts';

/** A level; 0 is the original. */
export interface ExactStep {
  level: number;
  mesh: Mesh;
  /** What it came from; of the original the finest level's. */
  result: Reduction;
}

/** On the way from a level to the next. */
export interface MorphStep {
  morph: MorphSource;
  from: number;
  /** How far, 0…1. */
  share: number;
  /** That of the coarser level. */
  result: Reduction;
}

/** What is shown at a position among levels. */
export type LevelStep = ExactStep | MorphStep;

/** The levels of a surface as they are shown. */
export class LevelView {
  readonly nested: Levels;
  #surface: OpenSurface;
  #morphs: MorphSource[];

  constructor(surface: OpenSurface, nested: Levels) {
    this.nested = nested;
    this.#surface = surface;
    this.#morphs = nested.morphs.map((morph, from) => this.#source(morph, from));
  }

  get surface(): OpenSurface {
    return this.#surface;
  }

  /**
   * A level where the position is a whole number, else what lies between two. Without morphs (propagated errors) there is
   * nothing between: then it is the nearest level.
   */
  at(position: number): LevelStep {
    const from = Math.floor(position);
    const morph = this.#morphs[from];
    if (position === from || !morph) {
      const level = Math.min(morph ? from : Math.round(position), this.nested.levels.length);
      return { level, mesh: this.#mesh(level), result: this.#result(level) };
    }
    return { morph, from, share: position - from, result: this.#result(from + 1) };
  }

  /** The largest geometric error of each level, the original's first: none. */
  get errors(): number[] {
    return [0, ...this.nested.levels.map(({ report }) => report.variables[0].error)];
  }

  /** The colours of a level. */
  colouring(level: number, settings: ViewSettings): Colouring {
    const mesh = this.#mesh(level);
    if (settings.quantity === 'value') return valueColouring(mesh, this.#surface, settings);
    const errors = reducedErrors(this.#result(level), this.#surface.labels, settings);
    return level > 0 ? errors : { ...errors, places: this.#noErrors(settings) };
  }

  /** The original has none. */
  #noErrors({ quantity, variable }: ViewSettings): Float32Array {
    const bound = this.#result(1).report.variables.find(({ name }) => name === variable)?.bound ?? Infinity;
    const placeOf = quantity === 'signed-error' ? placeBySign(1) : placeByShare(bound);
    return new Float32Array(this.#surface.mesh.triangles.length).fill(placeOf(0));
  }

  #mesh(level: number): Mesh {
    return level === 0 ? this.#surface.mesh : this.nested.levels[level - 1].mesh;
  }

  /** Of the original that of the finest level: what its errors are measured in. */
  #result(level: number): Reduction {
    return this.nested.levels[Math.max(level, 1) - 1];
  }

  #source({ triangles, finer, coarser }: Morph, from: number): MorphSource {
    return {
      triangles,
      finer: { end: finer, surface: this.#mesh(from) },
      coarser: { end: coarser, surface: this.#mesh(from + 1) },
    };
  }
}
