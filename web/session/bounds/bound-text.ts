import type { Bound, Variable } from '../../../wasm/types.ts';
import { quoted } from '../../formats/text/wording.ts';
import { readDecimal } from './decimal.ts';

/** Bounds by variable name; `position` is the geometry, `*` every variable not named but identifiers. */
export type Bounds = Readonly<Record<string, Bound>>;

/** A text that states no bounds. The message is a sentence for people. */
export class BoundTextError extends Error {
  readonly code = 'bad_bound';
}

/** A bound as people write it: `1%` of the extent, `0.2` in the variable's unit, or `free`. Throws a BoundTextError. */
export function readBound(text: string): Bound {
  const value = text.trim();
  if (value === 'free') return 'free';
  const [, digits, percent] = /^(.*?)\s*(%?)$/.exec(value) ?? [];
  const number = readDecimal(digits ?? '');
  if (Number.isNaN(number)) throw new BoundTextError(`${quoted(value)} is not a number, a percentage or “free”.`);
  if (!(number > 0 && Number.isFinite(number))) {
    throw new BoundTextError(`${quoted(value)} is not a finite number above zero.`);
  }
  return percent ? { relative: Number(inHundreds(String(number), -1)) } : { absolute: number };
}

/** One entry of a list: a name, plain or in double quotes as in JSON, a colon, a bound; then a semicolon or the end. */
const entry = /\s*(?:"((?:[^"\\]|\\.)*)"|([^";]*?))\s*:([^:;"]*)(?:;|$)/y;

/**
 * Bounds as one text: `position: 1%; pressure: 3%; velocity: 0.2; "a: b": free; *: 5%`. Of two with one name the later
 * one holds. Throws a BoundTextError.
 */
export function readBounds(text: string): Bounds {
  const bounds: [string, Bound][] = [];
  const rest = text.trim().replace(/;$/, '');
  for (entry.lastIndex = 0; entry.lastIndex < rest.length; ) {
    const from = entry.lastIndex;
    const [, inQuotes, plain, value] = entry.exec(rest) ?? [];
    const name = inQuotes === undefined ? plain : unquoted(inQuotes);
    if (!name) throw new BoundTextError(`${quoted(rest.slice(from).trim())} does not have the form “name: 1%”.`);
    bounds.push([name, readBound(value)]);
  }
  // From entries, so that a variable may be called `__proto__`.
  return Object.fromEntries(bounds);
}

function unquoted(text: string): string {
  try {
    return JSON.parse(`"${text}"`);
  } catch {
    throw new BoundTextError(`The name ${quoted(text)} has an escape that JSON does not know.`);
  }
}

/** The text that `readBounds` reads as these bounds. */
export function boundsText(bounds: Bounds): string {
  return Object.entries(bounds)
    .map(([name, bound]) => `${nameText(name)}: ${boundText(bound)}`)
    .join('; ');
}

function nameText(name: string): string {
  const plain = !/["\\;:]/.test(name) && name.trim() === name && name !== '';
  return plain ? name : JSON.stringify(name);
}

function boundText(bound: Bound): string {
  if (bound === 'free') return 'free';
  return 'relative' in bound ? `${percentOf(bound.relative)}%` : String(bound.absolute);
}

/** The percentage that reads back as the fraction: 100 × 0.07 is 7.000000000000001 in the machine's numbers. */
function percentOf(fraction: number): string {
  const exact = inHundreds(fraction.toExponential(), +1);
  const plain = String(Number(exact));
  return Number(inHundreds(plain, -1)) === fraction ? plain : exact;
}

/** The number that a text states, times 100 or 1/100, as text: moving the point rounds nothing. */
function inHundreds(text: string, power: 1 | -1): string {
  const [digits, exponent = '0'] = text.toLowerCase().split('e');
  return `${digits}e${Number(exponent) + 2 * power}`;
}

/** What tells which bound is a variable's. */
export type Bounded = Pick<Variable, 'name' | 'kind'>;

/** The bound that holds for a variable; none is free. One for all is not about identifiers. */
export function boundOf(bounds: Bounds, { name, kind }: Bounded): Bound {
  if (Object.hasOwn(bounds, name)) return bounds[name];
  return kind !== 'identifier' && Object.hasOwn(bounds, '*') ? bounds['*'] : 'free';
}
