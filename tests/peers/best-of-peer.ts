import { rmSync } from 'node:fs';
import { join } from 'node:path';

import { cached, contentHash } from './cache.ts';
import type { Judge } from './native.ts';
import type { Peer, Setting, Task } from './peer.ts';
import { places } from './places.ts';
import { Search } from './search.ts';

/** What a peer left of a surface at its best, and how. */
export interface PeerResult {
  triangles: number;
  /** The judge's, of the surface; at most 1. */
  ratio: number;
  /** The judge's, of the boundary; nobody asks this of a peer. */
  boundaryRatio: number;
  setting: Setting;
  runs: number;
  seconds: number;
}

/** How often a peer may run for one surface and pair of bounds, by the time that it takes. */
const allowed = { least: 24, most: 150, seconds: 20 };
/** To be raised when the search changes, so that results kept from before are not taken. */
const searchVersion = 2;
/** The judge's accuracy, as a fraction of a bound. */
const hair = 1e-6;

/** Searched for once; kept for as long as peer, surface and bounds are the same. */
export function bestOfPeer(peer: Peer, name: string, task: Task, judge: Judge): Promise<PeerResult> {
  const key = {
    version: peer.version,
    search: searchVersion,
    surface: contentHash(task.path),
    bounds: task.bounds.join(),
  };
  return cached(`${name}-${peer.name}`, key, () => search(peer, task, judge));
}

async function search(peer: Peer, task: Task, judge: Judge): Promise<PeerResult> {
  const trial = join(places.cache, `trial-${process.pid}.ply`);
  const triangles = task.mesh.triangles.length / 3;
  const inTime = Math.round((allowed.seconds * peer.pace) / triangles);
  const allowance = Math.min(allowed.most, Math.max(allowed.least, inTime));
  const started = performance.now();
  const simplify = await peer.open(task);
  const original = { triangles, variables: task.mesh.variables.length };
  const run = new Search(simplify, (path) => judge.beyond(path), trial, original, allowance);
  const found = await run.fewest(peer.options, peer.starts);
  const again = await simplify(found.setting, found.target, trial);
  const [ratio, boundaryRatio] = await judge.ratios(trial);
  rmSync(trial);
  if (again !== found.triangles || !(ratio <= 1 + hair)) {
    throw new Error(`${peer.name} gives ${again} triangles at a ratio of ${ratio} where it gave ${found.triangles}.`);
  }
  const { setting, runs } = found;
  return { triangles: again, ratio, boundaryRatio, setting, runs, seconds: (performance.now() - started) / 1000 };
}
