import type { RegionReport } from '../../../wasm/index.ts';
import { counted, grouped, printable } from '../../formats/text/wording.ts';
import { numberText, textTable } from './text-table.ts';

/** What the labels of regions stand for, where the file says so. */
export type RegionNames = ReadonlyMap<number, string>;

/** More rows than this hide what stands above them; the report has all regions. */
const mostRows = 16;

/** How much of each region there is, before and after, and which vanished; nothing where there are no regions. */
export function regionLines(regions: readonly RegionReport[], names: RegionNames = new Map()): string[] {
  if (regions.length === 0) return [];
  const rows = regions.slice(0, mostRows).map(({ label, triangles, area }) => {
    const change = (100 * (area.after - area.before)) / area.before;
    const counts = [triangles.before, triangles.after].map(grouped);
    const changed = Number.isFinite(change) ? [`${numberText(change)} %`] : [''];
    return [labelText(label, names), ...counts, numberText(area.before), numberText(area.after), ...changed];
  });
  const table = textTable([['region', 'triangles', 'left', 'area', 'left', 'change'], ...rows]);
  const more = regions.length - rows.length;
  return [
    table,
    ...(more > 0 ? [`  … and ${counted(more, 'region')} more (--report writes all of them)`] : []),
    ...vanishedLines(regions, names),
  ];
}

function labelText(label: number, names: RegionNames): string {
  const name = names.get(label);
  return name === undefined ? `${label}` : `${label} ${printable(name)}`;
}

function vanishedLines(regions: readonly RegionReport[], names: RegionNames): string[] {
  const vanished = regions.filter(({ triangles }) => triangles.after === 0);
  const labels = vanished.map(({ label }) => labelText(label, names));
  if (labels.length === 0) return [];
  const named = labels.slice(0, mostRows).join(', ') + (labels.length > mostRows ? ', …' : '');
  return [`${counted(labels.length, 'region')} vanished: ${named}.`];
}
