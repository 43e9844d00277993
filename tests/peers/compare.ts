/**
 * Compares Meshbound with the tools that a user would pick instead: how many triangles each leaves at the same bounds.
 *
 *     npm run peers -- [--quick] [--surfaces NAME,...] [--bounds GEOMETRY/VARIABLES,...] [--effort NUMBER] [--out FILE]
 *
 * Bounds are in percent of the extents, 0.1/1,1/3,3/3,6/6,9/9 where none are given. --quick takes three small surfaces, two
 * bounds and half the effort. Effort says how long to search for the best of a peer: 2 lets it run twice as often as 1, the
 * usual; what was found is kept in build/peers-cache, and what the file has found before stands until a search finds better
 * (so 0, which searches not at all, renews Meshbound's own columns). MESHBOUND_DATA names a folder of further surfaces (PLY). The tables
 * go to standard output and, as they grow, to the file, in place of what it has below the line that says so.
 */

import { existsSync, readFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { parseArgs } from 'node:util';

import { writeBelow } from '../write-below.ts';
import { bestOfPeer, type PeerResult } from './best-of-peer.ts';
import { meshoptimizer } from './meshoptimizer.ts';
import { buildNative, hair, Judge, ratio } from './native.ts';
import type { Peer, Task } from './peer.ts';
import { hasSmallParts, withoutSmallParts } from './small-parts.ts';
import { findSurfaces, quickSurfaces, quickSurfacesWithoutData, readScalars, type SurfaceFile } from './surfaces.ts';
import { bestPeer, figureKey, type Row, readFigures, share, tables } from './table.ts';
import { vtk } from './vtk.ts';

const usualBounds = '0.1/1,1/3,3/3,6/6,9/9';
const quickBounds = '1/3,6/6';
const quickEffort = 0.5;

/** Whatever stands below this line of a file is written here. */
const marker = '<!-- Below: tests/peers/compare.ts -->';

/** By name of the peer. */
type Found = Record<string, PeerResult>;

/** In percent. */
interface Bounds {
  name: string;
  geometry: number;
  variables: number;
}

function parseBounds(text: string): Bounds[] {
  return text.split(',').map((name) => {
    const [geometry, variables] = name.split('/').map(Number);
    if (!(geometry > 0 && variables > 0)) throw new Error(`Not a pair of bounds: "${name}". Bounds look like 1/3.`);
    return { name, geometry, variables };
  });
}

function chooseSurfaces(wanted: string | undefined, isQuick: boolean): SurfaceFile[] {
  const all = findSurfaces();
  const named = (names: string[]) => names.flatMap((name) => all.filter((surface) => surface.name === name));
  if (wanted) {
    const missing = wanted.split(',').filter((name) => named([name]).length === 0);
    if (missing.length === 0) return named(wanted.split(','));
    throw new Error(`No surface "${missing.join('", "')}". There are: ${all.map(({ name }) => name).join(', ')}.`);
  }
  if (!isQuick) return all;
  const quick = named(quickSurfaces);
  return quick.length > 0 ? quick : named(quickSurfacesWithoutData);
}

async function findPeers(): Promise<Peer[]> {
  const peers = [await meshoptimizer(), vtk()];
  if (!peers[1]) console.error('VTK is left out: install it with apt-get install --no-install-recommends python3-vtk9');
  return peers.filter((peer) => peer !== undefined);
}

async function compare({ name, path }: SurfaceFile): Promise<Row[]> {
  const mesh = readScalars(path);
  const triangles = await judge.open(path);
  const rows: Row[] = [];
  let found: Found = {};
  for (const { name: boundsName, geometry, variables } of bounds) {
    const task = { path, mesh, bounds: await judge.bound(geometry, variables) };
    const row: Row = {
      surface: name,
      triangles,
      variables: mesh.variables.length,
      bounds: boundsName,
      tracked: await judge.reduce('tracked'),
      propagated: await judge.reduce('propagated'),
      peers: {},
    };
    if (effort > 0) found = await search(`${name}-${boundsName.replace('/', '-')}`, task, found);
    row.peers = best(found, foundBefore.get(figureKey(name, boundsName)));
    console.error(
      `${name} at ${boundsName}: ${row.tracked.triangles} against ${bestPeer(row)}, ${share(row).toFixed(2)}`,
    );
    rows.push(row);
  }
  return rows;
}

/** `tighter`: what was found at tighter bounds. */
async function search(keptAs: string, task: Task, tighter: Found): Promise<Found> {
  const found: Found = {};
  for (const peer of peers) {
    const results = [await bestOfPeer(peer, keptAs, task, judge, effort, tighter[peer.name])];
    if (hasSmallParts(task.mesh)) {
      const largeParts = withoutSmallParts(peer);
      results.push(await bestOfPeer(largeParts, `${keptAs}-large-parts`, task, judge, effort, tighter[peer.name]));
    }
    found[peer.name] = results.reduce((one, other) => (other.triangles < one.triangles ? other : one));
  }
  return found;
}

/** The better of what was found now and before, peer by peer. */
function best(found: Found, before: Row['peers'] = {}): Row['peers'] {
  const figures = { ...before };
  for (const [peer, { triangles, boundaryRatio }] of Object.entries(found)) {
    if (triangles < (before[peer]?.triangles ?? Number.POSITIVE_INFINITY)) {
      figures[peer] = { triangles, keepsBoundary: boundaryRatio <= 1 + hair };
    }
  }
  if (Object.keys(figures).length === 0) throw new Error('Nothing is known of the peers: let them search.');
  return figures;
}

function head(): string {
  const tools = peers.map(({ name, version }) => `${name} ${version}`).join(', ');
  const date = new Date().toISOString().slice(0, 10);
  const searched = effort > 0 ? `the peers searched with effort ${effort} or more` : 'the peers as found before';
  return `Measured on ${date} with ${tools}, Node ${process.versions.node}; ${cpus().length} × ${cpus()[0].model}; ${searched}.`;
}

const { values: options } = parseArgs({
  options: {
    quick: { type: 'boolean', default: false },
    surfaces: { type: 'string' },
    bounds: { type: 'string' },
    effort: { type: 'string' },
    out: { type: 'string' },
  },
});
const bounds = parseBounds(options.bounds ?? (options.quick ? quickBounds : usualBounds));
const effort = Number(options.effort ?? (options.quick ? quickEffort : 1));
if (!(effort >= 0)) throw new Error(`Effort is a number from 0, not "${options.effort}".`);
const foundBefore = readFigures(options.out && existsSync(options.out) ? readFileSync(options.out, 'utf8') : '');
buildNative();
const surfaces = chooseSurfaces(options.surfaces, options.quick);
const peers = await findPeers();
const judge = new Judge();
const rows: Row[] = [];
for (const surface of surfaces) {
  rows.push(...(await compare(surface)));
  // After every surface: a long comparison can be looked at, or ended, on its way.
  if (options.out) writeBelow(options.out, marker, `${head()}\n\n${tables(rows)}`);
}
console.log(`${head()}\n\n${tables(rows)}`);
for (const row of rows.filter(({ tracked, propagated }) => Math.max(ratio(tracked), ratio(propagated)) > 1 + hair)) {
  console.error(`Meshbound is beyond the bounds on ${row.surface} at ${row.bounds}.`);
  process.exitCode = 1;
}
for (const tool of [judge, ...peers]) tool.close();
