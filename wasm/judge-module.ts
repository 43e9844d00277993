import createModule from '../build/wasm/judge.mjs';
import type { Outcome } from './tasks.ts';
import type { Mesh } from './types.ts';

/** The farthest that a sample of one surface lies from the other. */
export interface Deviation {
  /** Distance in bounds: 1 is the limit. Infinity where there is nothing to be near to. */
  ratio: number;
  /** Of the sampled surface, counting those with three distinct vertices; of a boundary the edge. */
  triangle: number;
  barycentric: [number, number, number];
  /** The same place in space. */
  position: [number, number, number];
  /** Which variable is farthest there: 0 position, i + 1 the mesh's variable i. */
  variable: number;
  /** How many points were looked at. */
  samples: number;
}

/** What was found, both ways. */
export interface Judgement {
  fromOriginal: Deviation;
  fromReduced: Deviation;
}

/** The judgement of two surfaces, and of their boundaries as curves. */
export interface Verdict {
  surface: Judgement;
  boundary: Judgement;
}

/** The function of wasm/judge-bindings.cpp. It blocks until it is done. */
export interface Judge {
  /**
   * Judges a reduced surface by what anyone can see of it (tests/judge/judge.hpp). Both meshes carry the same variables in
   * the same order, finite numbers and indices that exist. `bounds` are absolute, position first; Infinity is free.
   * `multipliers` multiply all bounds, one above zero at each vertex of the original; none where nothing does.
   */
  judge(
    original: Mesh,
    reduced: Mesh,
    bounds: readonly number[],
    samples: number,
    multipliers: ArrayLike<number>,
  ): Outcome<Verdict>;
}

/** A ratio is exact to this fraction of a bound, so up to 1 + `judgeAccuracy` the bounds are kept. */
export const judgeAccuracy = 1e-6;

const binary = new URL('../build/wasm/judge.wasm', import.meta.url);

/** Loads the judge's WebAssembly module: from its address in a browser, from its file in Node. */
export function loadJudge(): Promise<Judge> {
  if (binary.protocol === 'file:') {
    return createModule<Judge>({ wasmBinary: process.getBuiltinModule('node:fs').readFileSync(binary) });
  }
  return createModule<Judge>({ locateFile: () => binary.href });
}
