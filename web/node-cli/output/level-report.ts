import type { Report } from '../../../wasm/index.ts';
import { counted, grouped } from '../../formats/text/wording.ts';
import { type ReportOptions, reportJson, type Seams } from '../../session/report/report-json.ts';
import type { Bounds } from '../options/bound-arguments.ts';
import { type RegionNames, regionLines } from './region-text.ts';
import { removedText, roundedUpText, textTable } from './text-table.ts';
import { turnLines } from './turn-text.ts';

/** A level with the file that holds it. */
export interface LevelReport {
  file: string;
  bounds: Bounds;
  report: Report;
}

/** What `--report` writes of levels: for each what it writes of one, and its file; documented in docs/command-line.md. */
export function levelsJson(levels: LevelReport[], options: ReportOptions, seams: Seams, names?: RegionNames): string {
  const entries = levels.map(({ file, bounds, report }) =>
    JSON.parse(reportJson(report, { ...options, bounds }, { seams, names, file })),
  );
  return `${JSON.stringify({ levels: entries }, undefined, 2)}\n`;
}

/** The same for people. */
export function levelsText(levels: LevelReport[], names?: RegionNames): string {
  const [{ report: first }] = levels;
  const { before } = first.triangles;
  const rows = levels.map(({ file, report: { triangles, variables } }, i) => {
    const used = variables.reduce((most, variable) => (variable.ratio > most.ratio ? variable : most));
    return [
      `${i + 1}  ${file}`,
      grouped(triangles.after),
      removedText(before, triangles.after),
      roundedUpText(variables[0].error),
      used.ratio > 0 ? `${roundedUpText(used.ratio)} of ${used.name}` : '',
    ];
  });
  return [
    `${counted(before, 'triangle')} -> ${counted(levels.length, 'level')} in ${first.seconds.toFixed(2)} s`,
    textTable([['level', 'triangles', 'removed', 'position error', 'most of a bound used'], ...rows]),
    ...levels.flatMap(({ report }, i) => turnLines(report).map((line) => `Level ${i + 1}: ${line}`)),
    ...regionLines(first.regions.length > 0 ? levels[levels.length - 1].report.regions : [], names),
  ].join('\n');
}
