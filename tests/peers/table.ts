import type { PeerResult } from './best-of-peer.ts';
import { hair, type Reduced, ratio } from './native.ts';

/** One surface at one pair of bounds. */
export interface Row {
  surface: string;
  triangles: number;
  variables: number;
  /** In percent: `1/3`. */
  bounds: string;
  tracked: Reduced;
  propagated: Reduced;
  /** By name of the peer. */
  peers: Record<string, PeerResult>;
}

/** Explained in docs/peers.md. */
const boundaryMark = ' †';

export function bestPeer(row: Row): number {
  return Math.min(...Object.values(row.peers).map(({ triangles }) => triangles));
}

/** Meshbound's triangles over the best peer's. */
export function share(row: Row): number {
  return row.tracked.triangles / bestPeer(row);
}

export function median(values: number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length / 2;
  return (sorted[Math.ceil(middle) - 1] + sorted[Math.floor(middle)]) / 2;
}

/** One table a pair of bounds, after one of the medians. */
export function tables(rows: Row[]): string {
  const bounds = [...new Set(rows.map((row) => row.bounds))];
  const groups = bounds.map((one) => rows.filter((row) => row.bounds === one));
  return [medians(groups), ...groups.map((group) => `## ${group[0].bounds} %\n\n${table(group)}`)].join('\n\n');
}

function medians(groups: Row[][]): string {
  const lines = groups.map((group) => {
    const shares = group.map(share);
    const more = group.filter((row) => share(row) > 1).map((row) => row.surface);
    return [
      group[0].bounds,
      group.length,
      decimals(median(shares)),
      decimals(Math.max(...shares)),
      more.join(', ') || 'none',
      decimals(median(group.map((row) => ratio(row.tracked)))),
    ];
  });
  return markdown(
    ['bounds, %', 'surfaces', 'median ratio', 'largest ratio', 'more than the best peer on', 'judge, median'],
    lines,
  );
}

function table(rows: Row[]): string {
  const peers = Object.keys(rows[0].peers);
  return markdown(
    ['surface', 'triangles', 'variables', 'tracked', 'propagated', ...peers, 'ratio', 'judge', 'seconds'],
    rows.map((row) => [
      row.surface,
      row.triangles,
      row.variables,
      row.tracked.triangles,
      row.propagated.triangles,
      ...peers.map((peer) => peerText(row.peers[peer])),
      decimals(share(row)),
      decimals(ratio(row.tracked)),
      decimals(row.tracked.seconds),
    ]),
  );
}

/** Marked where the peer's boundary, of which nothing is asked, lies beyond the bounds. */
function peerText(result: PeerResult | undefined): string {
  if (!result) return '';
  return `${result.triangles}${result.boundaryRatio > 1 + hair ? boundaryMark : ''}`;
}

function decimals(value: number): string {
  return value.toFixed(2);
}

function markdown(head: string[], lines: (string | number)[][]): string {
  const alignment = head.map((title) => (title === 'surface' || title.startsWith('more') ? '---' : '---:'));
  return [head, alignment, ...lines].map((line) => `| ${line.join(' | ')} |`).join('\n');
}
