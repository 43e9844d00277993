import { UsageFault } from '../fault.ts';
import { outputFormat } from '../files/surface-files.ts';
import { type Bounds, parseBounds } from './bound-arguments.ts';

/**
 * The bounds of each level, finest first, from `--levels '1%,3%,6%'` and the bounds beside it. The list is for every variable
 * that has no bound of its own; `NAME=2%` holds in all levels, `NAME=2%,4%,8%` has one for each. Throws a UsageFault.
 */
export function parseLevels(list: string, bounds: readonly string[]): Bounds[] {
  const count = list.split(',').length;
  const named = bounds.map((text) => valuesOf(text, count));
  if (bounds.some((text) => text.slice(0, text.lastIndexOf('=')) === '*')) {
    throw new UsageFault('--levels is the bound of every variable not named; --bound "*=…" cannot be given beside it.');
  }
  const all = valuesOf(`*=${list}`, count);
  return Array.from({ length: count }, (_, level) => parseBounds([all[level], ...named.map((texts) => texts[level])]));
}

/** `NAME=1%,3%` as `NAME=1%` and `NAME=3%`; one value stands in all levels. */
function valuesOf(text: string, count: number): string[] {
  const at = text.lastIndexOf('=');
  const values = text.slice(at + 1).split(',');
  if (values.length !== 1 && values.length !== count) {
    throw new UsageFault(`${text}: --levels asks for ${count} levels, but this has bounds for ${values.length}.`);
  }
  return Array.from({ length: count }, (_, level) => text.slice(0, at + 1) + (values[level] ?? values[0]));
}

/**
 * The files of the levels: `small.vtp` becomes `small-1.vtp`, `small-2.vtp` …, `#` in a name stands for the number; a GLB
 * file without it holds all of them.
 */
export function levelPaths(output: string, count: number): string[] {
  if (outputFormat(output) === 'glb' && !output.includes('#')) return [output];
  const pattern = output.includes('#') ? output : output.replace(/(\.\w+(\.gz)?)$/i, '-#$1');
  const width = String(count).length;
  return Array.from({ length: count }, (_, level) => pattern.replaceAll('#', String(level + 1).padStart(width, '0')));
}
