import type { Mesh } from '../../wasm/types.ts';
import type { Surface } from '../../web/formats/surface.ts';
import { markdownTable, shortNumber, unitText } from './markdown.ts';
import { type DetailedOutcome, detailedOutcomeOf } from './outcome.ts';

/** A surface of §5 and the bounds that it is reduced with, in percent, the same for geometry and variables. */
export interface PaperCase {
  /** Name of the sample that stands for it. */
  sample: string;
  description: string;
  percents: [number, number];
  /** What the paper's figures leave, in percent, over both bounds. */
  paperLeaves: string;
  /** Three variables, the first of them drawn flat shaded. */
  drawn: [string, string, string];
}

export const paperCases: PaperCase[] = [
  {
    sample: 'fireballs',
    description: '70×40×25 grid, seven variables (figure 7)',
    percents: [3, 6],
    paperLeaves: '20–30',
    drawn: ['pressure', 'vx', 'temperature'],
  },
  {
    sample: 'impact',
    description: '54×24×24 grid, six variables (figure 8)',
    percents: [3, 9],
    paperLeaves: '30–50',
    drawn: ['pressure', 'temperature', 'vx'],
  },
];

interface Result {
  percent: number;
  propagated: DetailedOutcome;
  tracked: DetailedOutcome;
}

async function resultsOf(mesh: Mesh, percents: number[]): Promise<Result[]> {
  const results: Result[] = [];
  for (const percent of percents) {
    const bounds = { '*': { relative: percent / 100 } };
    const propagated = await detailedOutcomeOf(mesh, bounds, 'propagated');
    results.push({ percent, propagated, tracked: await detailedOutcomeOf(mesh, bounds, 'tracked') });
  }
  return results;
}

/** The table of triangles left, and one of errors for each surface and bound. */
export async function paperTables(surfaces: Map<string, Surface>): Promise<{ counts: string; errors: string }> {
  const counts: (string | number)[][] = [];
  const errors: string[] = [];
  for (const { sample, percents, paperLeaves } of paperCases) {
    const { mesh, units } = surfaces.get(sample) as Surface;
    const before = mesh.triangles.length / 3;
    const share = ({ triangles }: DetailedOutcome) => `${triangles} (${((100 * triangles) / before).toFixed(1)} %)`;
    for (const result of await resultsOf(mesh, percents)) {
      const { percent, propagated, tracked } = result;
      counts.push([sample, before, `${percent} %`, `${paperLeaves} %`, share(propagated), share(tracked)]);
      errors.push(`**${sample}, ${percent} %**\n\n${errorTable(result, units)}`);
    }
  }
  const head = ['surface', 'triangles', 'bounds', 'paper leaves', 'propagated (the paper)', 'tracked (ours)'];
  return { counts: markdownTable(head, counts), errors: errors.join('\n\n') };
}

function errorTable({ propagated, tracked }: Result, units: Surface['units']): string {
  const percent = (ratio: number) => `${(100 * ratio).toFixed(1)}`;
  const lines = tracked.variables.map(({ name, bound, constant }, i) => [
    constant ? `${name} (constant)` : name,
    `${shortNumber(bound)}${unitText(units[name])}`,
    ...[propagated, tracked].flatMap((outcome) => [
      percent(outcome.variables[i].ratio),
      percent(outcome.judgedErrors[i]),
    ]),
  ]);
  const all = ['all together', '', '', percent(propagated.judged), '', percent(tracked.judged)];
  const head = ['variable', 'bound', 'propagated: guaranteed', 'judged', 'tracked: guaranteed', 'judged'];
  return markdownTable(head, [...lines, all]);
}
