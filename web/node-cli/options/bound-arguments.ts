import type { Bound, Mesh } from '../../../wasm/index.ts';
import { listed, quoted } from '../../formats/text/wording.ts';
import { type Bounded, type Bounds, readBound } from '../../session/bounds/bound-text.ts';
import { messageOf } from '../../session/reading/failure.ts';
import { Fault, UsageFault } from '../fault.ts';

export { type Bounded, type Bounds, boundOf } from '../../session/bounds/bound-text.ts';

/** The bounds of a command line, `NAME=1%`, `NAME=0.2` or `NAME=free` each; of two with one name the later one holds. */
export function parseBounds(texts: readonly string[]): Bounds {
  if (texts.length === 0)
    throw new UsageFault('No bound was given; --bound NAME=1% gives one, --bound "*=1%" one to all.');
  // From entries, so that a variable may be called `__proto__`.
  return Object.fromEntries(texts.map(parseBound));
}

function parseBound(text: string): [string, Bound] {
  const at = text.lastIndexOf('=');
  const name = text.slice(0, at);
  if (at < 1) throw faultIn(text, 'it has the form NAME=1%, NAME=0.2 or NAME=free.');
  try {
    return [name, readBound(text.slice(at + 1))];
  } catch (error) {
    throw faultIn(text, messageOf(error));
  }
}

function faultIn(text: string, reason: string): UsageFault {
  return new UsageFault(`The bound ${quoted(text)} cannot be: ${reason}`);
}

/** The variables of a mesh that no bound reaches, not even as free. */
export function unnamed(bounds: Bounds, { variables }: Mesh): Bounded[] {
  const all: Bounded[] = [{ name: 'position' }, ...variables];
  const reached = ({ kind }: Bounded) => kind !== 'identifier' && Object.hasOwn(bounds, '*');
  return all.filter((variable) => !reached(variable) && !Object.hasOwn(bounds, variable.name));
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
