import type { RegionReport } from '../../wasm/index.ts';
import { counted, grouped } from '../formats/wording.ts';
import { numberText, textTable } from './text-table.ts';

/** More rows than this hide what stands above them; the report has all regions. */
const mostRows = 16;

/** How much of each region there is, before and after, and which vanished; nothing where there are no regions. */
export function regionLines(regions: readonly RegionReport[]): string[] {
  if (regions.length === 0) return [];
  const rows = regions.slice(0, mostRows).map(({ label, triangles, area }) => {
    const change = (100 * (area.after - area.before)) / area.before;
    const counts = [triangles.before, triangles.after].map(grouped);
    const changed = Number.isFinite(change) ? [`${numberText(change)} %`] : [''];
    return [`${label}`, ...counts, numberText(area.before), numberText(area.after), ...changed];
  });
  const table = textTable([['region', 'triangles', 'left', 'area', 'left', 'change'], ...rows]);
  const more = regions.length - rows.length;
  return [
    table,
    ...(more > 0 ? [`  … and ${counted(more, 'region')} more (--report writes all of them)`] : []),
    ...vanishedLines(regions),
  ];
}

function vanishedLines(regions: readonly RegionReport[]): string[] {
  const labels = regions.filter(({ triangles }) => triangles.after === 0).map(({ label }) => label);
  if (labels.length === 0) return [];
  const named = labels.slice(0, mostRows).join(', ') + (labels.length > mostRows ? ', …' : '');
  return [`${counted(labels.length, 'region')} vanished: ${named}.`];
}
