import { type Reduced, ratio } from './native.ts';

/** What the table says of a peer's best result. */
export interface PeerFigure {
  triangles: number;
  /** Whether the boundary, of which nothing is asked, is within the bounds, too. */
  keepsBoundary: boolean;
}

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
  peers: Record<string, PeerFigure>;
}

/** Explained in docs/peers.md. */
const boundaryMark = '†';

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

function peerText({ triangles, keepsBoundary }: PeerFigure): string {
  return `${triangles}${keepsBoundary ? '' : ` ${boundaryMark}`}`;
}

/** The peers' figures in tables that were written before: by bounds and surface, then by name of the peer. */
export function readFigures(text: string): Map<string, Row['peers']> {
  const figures = new Map<string, Row['peers']>();
  for (const section of text.split('\n## ').slice(1)) {
    const bounds = section.slice(0, section.indexOf(' '));
    const [head, , ...lines] = section
      .split('\n')
      .filter((line) => line.startsWith('|'))
      .map(cells);
    if (head?.[0] !== 'surface') continue;
    const peers = head.slice(head.indexOf('propagated') + 1, head.indexOf('ratio'));
    for (const line of lines) {
      const figure = (peer: string): PeerFigure => {
        const cell = line[head.indexOf(peer)];
        return { triangles: Number.parseInt(cell, 10), keepsBoundary: !cell.endsWith(boundaryMark) };
      };
      figures.set(figureKey(line[0], bounds), Object.fromEntries(peers.map((peer) => [peer, figure(peer)])));
    }
  }
  return figures;
}

export function figureKey(surface: string, bounds: string): string {
  return `${surface} at ${bounds}`;
}

function cells(line: string): string[] {
  return line
    .split('|')
    .slice(1, -1)
    .map((cell) => cell.trim());
}

function decimals(value: number): string {
  return value.toFixed(2);
}

function markdown(head: string[], lines: (string | number)[][]): string {
  const alignment = head.map((title) => (title === 'surface' || title.startsWith('more') ? '---' : '---:'));
  return [head, alignment, ...lines].map((line) => `| ${line.join(' | ')} |`).join('\n');
}
