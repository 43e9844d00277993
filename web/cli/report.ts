import type { Report } from '../../wasm/index.ts';
import { counted, grouped, listed } from '../formats/wording.ts';
import type { ReportOptions } from '../session/report-json.ts';
import { boundOf } from './bound-arguments.ts';
import { type RegionNames, regionLines } from './region-text.ts';
import { numberText, roundedUpText, textTable } from './text-table.ts';
import { turnLines } from './turn-text.ts';

/** The same for people. */
export function reportText(report: Report, { bounds }: Pick<ReportOptions, 'bounds'>, names?: RegionNames): string {
  const {
    triangles: { before, after },
    variables,
    regions,
    seconds,
  } = report;
  const removed = numberText((100 * (before - after)) / before);
  const rows = variables.map(({ name, constant, bound, error, ratio }) => {
    const given = boundOf(bounds, name);
    if (given === 'free') return [name, 'free', '', roundedUpText(error), ''];
    const share =
      'relative' in given ? `${roundedUpText(100 * given.relative)} %${constant ? ' of magnitude' : ''}` : '';
    return [name, roundedUpText(bound), share, roundedUpText(error), roundedUpText(ratio)];
  });
  return [
    `${grouped(before)} -> ${counted(after, 'triangle')} (${removed} % removed) in ${seconds.toFixed(2)} s`,
    textTable([['variable', 'bound', '', 'error', 'error/bound'], ...rows]),
    ...turnLines(report),
    ...regionLines(regions, names),
  ].join('\n');
}

/** A sentence about the variables that no bound was given for; none where there are none. */
export function freeNotes(names: string[]): string[] {
  if (names.length === 0) return [];
  return [
    `No bound was given for ${listed(names)}: free, so nothing is promised of ${names.length === 1 ? 'it' : 'them'}.`,
  ];
}
