import type { Bound, Report } from '../../../wasm/index.ts';
import { counted, grouped, listed, quoted } from '../../formats/text/wording.ts';
import type { ReportOptions } from '../../session/report/report-json.ts';
import { whyLittleWent } from '../../session/report/why-little-went.ts';
import { littleWentSentence } from '../../words/little-went.ts';
import { type Bounded, boundOf } from '../options/bound-arguments.ts';
import { type RegionNames, regionLines } from './region-text.ts';
import { removedText, roundedUpText, textTable } from './text-table.ts';
import { turnLines } from './turn-text.ts';

/** What a table of variables needs to know of how it was asked. */
type AskedFor = Pick<ReportOptions, 'bounds'> & Partial<Pick<ReportOptions, 'boundMultiplier'>>;

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
    ...roundingLines(report),
    ...multiplierLines(options),
    ...littleWentLines(report),
    ...turnLines(report),
    ...regionLines(regions, names),
  ].join('\n');
}

function variableRows({ variables, featureSize }: Report, { bounds }: AskedFor): string[][] {
  return variables.map(({ name, kind, constant, bound, error, ratio }) => {
    const given = boundOf(bounds, { name, kind });
    if (given === 'free') return [name, 'free', '', Number.isNaN(error) ? 'not known' : roundedUpText(error), ''];
    const limited = name === 'position' && featureSize !== undefined;
    const share = limited ? 'limited' : shareText(given, constant);
    return [name, roundedUpText(bound), share, roundedUpText(error), roundedUpText(ratio)];
  });
}

function shareText(given: Exclude<Bound, 'free'>, constant: boolean): string {
  if (!('relative' in given)) return '';
  return `${roundedUpText(100 * given.relative)} %${constant ? ' of magnitude' : ''}`;
}

/** Why, where little went though the bounds would let it. */
function littleWentLines(report: Report): string[] {
  const why = whyLittleWent(report);
  return why ? [littleWentSentence(why).replaceAll('\u00a0', ' ')] : [];
}

/** What the format of the file takes of the bounds; nothing where it holds every number. */
function roundingLines({ variables }: Report): string[] {
  const rounded = variables.flatMap(({ name, rounding }) =>
    rounding ? [`${quoted(name)} by up to ${roundedUpText(rounding)}`] : [],
  );
  return rounded.length > 0 ? [`the file rounds ${rounded.join(', ')}: counted in the error`] : [];
}

/** Why an error may be larger than its bound in the table; nothing where it may not. */
function multiplierLines({ boundMultiplier }: AskedFor): string[] {
  return boundMultiplier
    ? [`bounds are multiplied by “${boundMultiplier}”: error/bound compares with the bound at each place`]
    : [];
}

/** Sentences about the variables that no bound was given for; none where there are none. */
export function freeNotes(variables: readonly Bounded[]): string[] {
  const [identifiers, others] = [true, false].map((wanted) =>
    variables.filter(({ kind }) => (kind === 'identifier') === wanted).map(({ name }) => name),
  );
  const notes: string[] = [];
  if (others.length > 0) notes.push(`No bound was given for ${listed(others)}: ${nothingPromised(others)}.`);
  if (identifiers.length > 0) {
    const are = identifiers.length === 1 ? 'is an identifier' : 'are identifiers';
    notes.push(
      `${listed(identifiers)} ${are}, which a bound for all variables is not about: ${nothingPromised(identifiers)}.`,
    );
  }
  return notes;
}

function nothingPromised({ length }: readonly string[]): string {
  return `free, so nothing is guaranteed of ${length === 1 ? 'it' : 'them'}`;
}
