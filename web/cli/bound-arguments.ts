import type { Bound, Mesh } from '../../wasm/index.ts';
import { listed, quoted } from '../formats/wording.ts';
import { Fault, UsageFault } from './fault.ts';

/** Bounds by variable name; `position` is the geometry, `*` every variable not named. */
export type Bounds = Record<string, Bound>;

/** The bounds of a command line, `NAME=1%`, `NAME=0.2` or `NAME=free` each; of two with one name the later one holds. */
export function parseBounds(texts: readonly string[]): Bounds {
  if (texts.length === 0)
    throw new UsageFault('No bound was given; --bound NAME=1% gives one, --bound "*=1%" one to all.');
  // From entries, so that a variable may be called `__proto__`.
  return Object.fromEntries(texts.map(parseBound));
}

function parseBound(text: string): [string, Bound] {
  const at = text.lastIndexOf('=');
  const [name, value] = [text.slice(0, at), text.slice(at + 1).trim()];
  if (at < 1) throw faultIn(text, 'it has the form NAME=1%, NAME=0.2 or NAME=free');
  if (value === 'free') return [name, 'free'];
  const [, digits, percent] = /^(.*?)\s*(%?)$/.exec(value) ?? [];
  const number = digits ? Number(digits) : Number.NaN;
  if (Number.isNaN(number)) throw faultIn(text, `${quoted(value)} is not a number, a percentage or “free”`);
  if (!(number > 0 && Number.isFinite(number))) throw faultIn(text, 'it must be a finite number above zero');
  return [name, percent ? { relative: number / 100 } : { absolute: number }];
}

function faultIn(text: string, reason: string): UsageFault {
  return new UsageFault(`The bound ${quoted(text)} cannot be: ${reason}.`);
}

/** The bound that holds for a variable; none is free. */
export function boundOf(bounds: Bounds, name: string): Bound {
  if (Object.hasOwn(bounds, name)) return bounds[name];
  return Object.hasOwn(bounds, '*') ? bounds['*'] : 'free';
}

/** The variables of a mesh that no bound reaches, not even as free. */
export function unnamed(bounds: Bounds, { variables }: Mesh): string[] {
  const names = ['position', ...variables.map(({ name }) => name)];
  return Object.hasOwn(bounds, '*') ? [] : names.filter((name) => !Object.hasOwn(bounds, name));
}

/** Throws a Fault for names that no variable of the surface has. */
export function requireKnown(names: readonly string[], { path, mesh }: { path: string; mesh: Mesh }): void {
  const known = ['position', ...mesh.variables.map(({ name }) => name)];
  const missing = names.filter((name) => !known.includes(name));
  if (missing.length === 0) return;
  throw new Fault(`${path}: there is no variable ${listed(missing)}; the variables are ${listed(known)}.`);
}

/** The same, for the names of bounds. */
export function requireKnownBounds(bounds: Bounds, surface: { path: string; mesh: Mesh }): void {
  requireKnown(
    Object.keys(bounds).filter((name) => name !== '*'),
    surface,
  );
}
