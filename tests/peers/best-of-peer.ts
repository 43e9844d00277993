import { rmSync } from 'node:fs';
import { join } from 'node:path';

import { cached, contentHash } from './cache.ts';
import { hair, type Judge } from './native.ts';
import type { Peer, Task } from './peer.ts';
import { places } from './places.ts';
import { Search, type Start } from './search.ts';

/** What a peer left of a surface at its best, and how. */
export interface PeerResult extends Start {
  triangles: number;
  /** The judge's, of the surface; at most 1. */
  ratio: number;
  /** The judge's, of the boundary; nobody asks this of a peer. */
  boundaryRatio: number;
  /** Absolute. */
  bounds: number[];
  runs: number;
  seconds: number;
}

/** How often a peer may run for one surface and pair of bounds at effort 1, by the time that it takes. */
const allowed = { least: 40, most: 120, seconds: 12 };
/** To be raised when peers are run in another way, so that results kept from before are not taken. */
const version = 3;

/**
 * Searched for once; kept for as long as peer, surface and bounds are the same, until more effort is asked for.
 * `tighter` is what was found at tighter bounds.
 */
export function bestOfPeer(
  peer: Peer,
  name: string,
  task: Task,
  judge: Judge,
  effort: number,
  tighter: PeerResult | undefined,
): Promise<PeerResult> {
  const key = { version: `${version}, ${peer.version}`, surface: contentHash(task.path), bounds: task.bounds.join() };
  return cached<PeerResult>(`${name}-${peer.name}`, key, effort, (before) =>
    search(peer, task, judge, effort, before, tighter),
  );
}

async function search(
  peer: Peer,
  task: Task,
  judge: Judge,
  effort: number,
  ...before: (PeerResult | undefined)[]
): Promise<PeerResult> {
  const trial = join(places.cache, `trial-${process.pid}.ply`);
  const started = performance.now();
  const simplify = await peer.open(task);
  const original = { triangles: task.mesh.triangles.length / 3, variables: task.mesh.variables.length };
  const allowance = Math.round(effort * runsAllowed(peer, original.triangles));
  const known = before.filter((one) => one !== undefined).map((one) => asAt(task.bounds, one));
  const run = new Search(simplify, (path) => judge.beyond(path), trial, original, allowance);
  const { setting, target, triangles, runs } = await run.fewest(peer.options, peer.starts, known);
  const again = await simplify(setting, target, trial);
  const [ratio, boundaryRatio] = await judge.ratios(trial);
  rmSync(trial);
  if (again !== triangles || !(ratio <= 1 + hair)) {
    throw new Error(
      `${peer.name} gives ${again} triangles at a ratio of ${ratio} where it gave ${triangles} within 1.`,
    );
  }
  const seconds = (performance.now() - started) / 1000;
  return { triangles, ratio, boundaryRatio, setting, target, bounds: task.bounds, runs, seconds };
}

/** The run at other bounds that does the same: weights are measured in bounds. */
function asAt(bounds: number[], { setting, target, bounds: others }: PeerResult): Start {
  if (bounds.join() === others.join()) return { setting, target }; // to the last digit, so that it passes again
  const weights = setting.weights.map(
    (weight, variable) => (weight * (others[0] / others[variable + 1]) * bounds[variable + 1]) / bounds[0],
  );
  return { setting: { ...setting, weights }, target };
}

function runsAllowed(peer: Peer, triangles: number): number {
  const inTime = Math.round((allowed.seconds * peer.pace) / triangles);
  return Math.min(allowed.most, Math.max(allowed.least, inTime));
}
