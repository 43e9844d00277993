import type { Bound, Report } from '../../wasm/index.ts';
import { counted, grouped, listed } from '../formats/wording.ts';
import type { ReportOptions } from '../session/report-json.ts';
import { boundOf } from './bound-arguments.ts';
import { type RegionNames, regionLines } from './region-text.ts';
import { removedText, roundedUpText, textTable } from './text-table.ts';
import { turnLines } from './turn-text.ts';

/** What a table of variables needs to know of how it was asked. */
type AskedFor = Pick<ReportOptions, 'bounds'> & Partial<Pick<ReportOptions, 'focus'>>;

/** The same for people. */
export function reportText(report: Report, options: AskedFor, names?: RegionNames): string {
  const {
    triangles: { before, after },
    regions,
    seconds,
  } = report;
  const removed = removedText(before, after);
  return [
    `${grouped(before)} -> ${counted(after, 'triangle')} (${removed} removed) in ${seconds.toFixed(2)} s`,
    textTable([['variable', 'bound', '', 'error', 'error/bound'], ...variableRows(report, options)]),
    ...focusLines(options),
    ...turnLines(report),
    ...regionLines(regions, names),
  ].join('\n');
}

function variableRows({ variables, featureSize }: Report, { bounds }: AskedFor): string[][] {
  return variables.map(({ name, constant, bound, error, ratio }) => {
    const given = boundOf(bounds, name);
    if (given === 'free') return [name, 'free', '', roundedUpText(error), ''];
    const limited = name === 'position' && featureSize !== undefined;
    const share = limited ? 'limited' : shareText(given, constant);
    return [name, roundedUpText(bound), share, roundedUpText(error), roundedUpText(ratio)];
  });
}

function shareText(given: Exclude<Bound, 'free'>, constant: boolean): string {
  if (!('relative' in given)) return '';
  return `${roundedUpText(100 * given.relative)} %${constant ? ' of magnitude' : ''}`;
}

/** Why an error may be larger than its bound in the table; nothing where it may not. */
function focusLines({ focus }: AskedFor): string[] {
  return focus ? [`bounds are multiplied by “${focus}”: error/bound compares with the bound at each place`] : [];
}

/** A sentence about the variables that no bound was given for; none where there are none. */
export function freeNotes(names: string[]): string[] {
  if (names.length === 0) return [];
  return [
    `No bound was given for ${listed(names)}: free, so nothing is promised of ${names.length === 1 ? 'it' : 'them'}.`,
  ];
}
