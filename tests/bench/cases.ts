import { fileURLToPath } from 'node:url';

export const fromRoot = (path: string) => fileURLToPath(new URL(`../../${path}`, import.meta.url));

/** A surface of the benchmark: fireballs, on ever finer grids. */
export interface Size {
  name: string;
  path: string;
  /** How often everything is run: the small ones more often, since chance weighs more on them. */
  rounds: number;
}

export const folder = fromRoot('build/bench');

export const sizes: Size[] = [
  { name: '7k', path: fromRoot('build/samples/fireballs.ply'), rounds: 3 },
  { name: '100k', path: fromRoot('build/samples/fireballs-fine.ply'), rounds: 3 },
  { name: '1m', path: `${folder}/fireballs-1m.ply`, rounds: 1 },
  { name: '4m', path: `${folder}/fireballs-4m.ply`, rounds: 1 },
];

/** The sets of variables that the surfaces carry in turn, by how many they are. */
export const variableSets: Record<string, string[]> = {
  0: [],
  2: ['pressure', 'temperature'],
  7: ['density', 'pressure', 'vx', 'vy', 'vz', 'energy', 'temperature'],
};

/** Of position, and of every variable; the same stand in reduce_main.cpp. */
export const bounds = { position: { relative: 0.01 }, '*': { relative: 0.03 } };

export type Errors = 'tracked' | 'propagated';

/** What a run of a program is told. */
export interface Case {
  path: string;
  variables: string[];
}

/** What a run found: times in seconds, of one reduction. */
export interface Measurement {
  /** Wall time. */
  wall: number;
  /** Time of the processor, all threads together: what other work on the machine changes least. */
  cpu: number;
  triangles: number;
  left: number;
  /** At the peak, mesh and result included; 0 where that cannot be told. */
  peakBytes: number;
}
