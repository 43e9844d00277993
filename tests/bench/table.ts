import type { Measurement } from './cases.ts';
import type { Contender, Row } from './row.ts';

type Cell = (row: Row, rows: Row[]) => string;

const columns: [string, Cell][] = [
  ['triangles', ({ results }) => String(results.native?.triangles ?? '')],
  ['variables', ({ variables }) => String(variables)],
  ['left', ({ results }) => String(results.native?.left ?? '')],
  ['native : meshoptimizer', throughput('native', 'meshoptimizer')],
  ['native : VTK', throughput('native', 'VTK')],
  ['module : meshoptimizer', throughput('module', 'meshoptimizer')],
  ['module : native', speed('module', 'native')],
  ['all threads : one', speed('native, all threads', 'native', 'wall')],
  ['growth', growth],
  ['bytes, native', bytes('native')],
  ['bytes, module', bytes('module')],
  ['propagated : tracked', speed('native, propagated', 'native')],
  ['propagated, left', ({ results }) => String(results['native, propagated']?.left ?? '')],
  ['propagated, module : native', speed('module, propagated', 'native, propagated')],
];

const none = '–';

/**
 * Triangles that another tool may leave above what it was asked for: what one collapse removes from a closed surface, where
 * it rather stops than goes below. With more it gave up.
 */
const slack = 2;

/**
 * How many times as many triangles ours removes in a second of the processor as another tool: where both leave as many, how
 * many times as fast it is. A tool that gave up is not the faster for what it did not do; what it left is named.
 */
function throughput(ours: Contender, peer: Contender): Cell {
  return ({ results }) => {
    const [we, they] = [results[ours], results[peer]];
    if (!we || !they) return none;
    const ratio = they.left < they.triangles ? twoDigits(removedPerSecond(we) / removedPerSecond(they)) : none;
    return they.left > we.left + slack ? `${ratio} (${they.left} left)` : ratio;
  };
}

function removedPerSecond({ cpu, triangles, left }: Measurement): number {
  return (triangles - left) / cpu;
}

/** How many times as fast the one is as the other. */
function speed(one: Contender, other: Contender, time: 'wall' | 'cpu' = 'cpu'): Cell {
  return ({ results }) => {
    const [ours, theirs] = [results[one], results[other]];
    return ours && theirs ? twoDigits(theirs[time] / ours[time]) : none;
  };
}

/** The time for n triangles over n log n, in that of the smallest surface with these variables. */
function growth({ variables, results }: Row, rows: Row[]): string {
  const first = rows.find((row) => row.variables === variables)?.results.native;
  return results.native && first ? twoDigits(ofLinearLog(results.native) / ofLinearLog(first)) : none;
}

function ofLinearLog({ cpu, triangles }: Measurement): number {
  return cpu / (triangles * Math.log(triangles));
}

function bytes(contender: Contender): Cell {
  return ({ results }) => {
    const { peakBytes, triangles } = results[contender] ?? { peakBytes: 0, triangles: 1 };
    return peakBytes > 0 ? String(Math.round(peakBytes / triangles)) : none;
  };
}

function twoDigits(value: number): string {
  return value < 10 ? value.toPrecision(2) : value.toFixed(0);
}

/** In Markdown. */
export function table(rows: Row[]): string {
  const head = columns.map(([title]) => title);
  const lines = rows.map((row) => columns.map(([, cell]) => cell(row, rows)));
  return [head, head.map(() => '---:'), ...lines].map((line) => `| ${line.join(' | ')} |`).join('\n');
}
