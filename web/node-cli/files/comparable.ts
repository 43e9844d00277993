import type { Mesh, Variable } from '../../../wasm/types.ts';
import { counted, quoted } from '../../formats/text/wording.ts';
import { usedPoints } from '../../surface/used-points.ts';
import { scaleOf, spanOf } from '../../surface/value-span.ts';
import { Fault, UsageFault, unboundedAdvice } from '../fault.ts';
import { type Bounds, boundOf, requireKnownBounds } from '../options/bound-arguments.ts';
import type { OpenedSurface } from './surface-files.ts';

/** Two surfaces with what has a bound, in one order, and no other variable. */
export interface Comparable {
  one: Mesh;
  other: Mesh;
  /** Of position, then of the variables. */
  names: string[];
  /** Their bounds in their units, Infinity for a free position. */
  limits: number[];
}

/**
 * Two surfaces as the judge takes them; percentages are of the extents in `original`. Throws a Fault for what cannot be
 * compared.
 */
export function comparable(original: OpenedSurface, reduced: OpenedSurface, bounds: Bounds): Comparable {
  requireKnownBounds(bounds, original);
  const bounded = original.mesh.variables.filter((variable) => boundOf(bounds, variable) !== 'free');
  const names = bounded.map(({ name }) => name);
  if (names.length === 0 && boundOf(bounds, { name: 'position' }) === 'free')
    throw new UsageFault('Every variable is free.');
  const [one, other] = [onlyWith(names, original), onlyWith(names, reduced)];
  requireSameComponents(one, other, reduced.path);
  const limits = [positionOf(one), ...one.variables].map((variable) => absoluteBound(bounds, variable, one.triangles));
  return { one, other, names: ['position', ...names], limits };
}

/**
 * What multiplies the bounds at each point: the values of a variable. Throws a Fault where it is missing, has several
 * components, or is not above zero everywhere.
 */
export function multipliersOf({ path, mesh }: OpenedSurface, name: string): Variable['values'] {
  const boundMultiplier = mesh.variables.find((variable) => variable.name === name);
  if (!boundMultiplier) throw new Fault(`${path}: there is no variable “${name}” to multiply the bounds.`);
  if (boundMultiplier.components !== 1) {
    throw new Fault(
      `${path}: “${name}” has ${boundMultiplier.components} components; what multiplies the bounds has one.`,
    );
  }
  const used = usedPoints(mesh.triangles, boundMultiplier.values.length);
  const bad = boundMultiplier.values.findIndex(
    (value, point) => used[point] === 1 && !(value > 0 && Number.isFinite(value)),
  );
  // The judge wants a number at every point, that of an unused one counts for nothing.
  if (bad < 0) return boundMultiplier.values.map((value, point) => (used[point] === 1 ? value : 1));
  throw new Fault(
    `${path}: “${name}” cannot multiply the bounds: it is ${boundMultiplier.values[bad]} at point ${bad}.`,
  );
}

/** The surface with these variables alone, in this order. Throws a Fault where one is missing or not finite. */
function onlyWith(names: readonly string[], { path, mesh }: OpenedSurface): Mesh {
  const variables = names.map((name) => {
    const variable = mesh.variables.find((each) => each.name === name);
    if (!variable) throw new Fault(`${path}: there is no variable “${name}”, so its bound cannot be checked.`);
    return variable;
  });
  for (const variable of [positionOf(mesh), ...variables]) requireFinite(path, variable, mesh.triangles);
  if (!hasSurface(mesh)) throw new Fault(`${path}: there is no triangle with three distinct vertices.`);
  return { ...mesh, variables };
}

function positionOf({ position }: Mesh): Variable {
  return { name: 'position', components: 3, values: position };
}

function requireFinite(path: string, variable: Variable, triangles: Uint32Array): void {
  const { nonFinite } = spanOf(variable, triangles);
  if (!nonFinite) return;
  const { name, components, values } = variable;
  const here = values.subarray(nonFinite.first * components, (nonFinite.first + 1) * components);
  const fault = here.some(Number.isNaN) ? 'not a number' : 'infinite';
  const held = `${path}: ${quoted(name)} is ${fault} at point ${nonFinite.first}`;
  if (name === 'position') throw new Fault(`${held}.`);
  throw new Fault(`${held}; so it can have no bound.${unboundedAdvice(name)}`);
}

function hasSurface({ triangles }: Mesh): boolean {
  for (let corner = 0; corner < triangles.length; corner += 3) {
    const [a, b, c] = [triangles[corner], triangles[corner + 1], triangles[corner + 2]];
    if (a !== b && b !== c && c !== a) return true;
  }
  return false;
}

function requireSameComponents(original: Mesh, reduced: Mesh, path: string): void {
  for (const [i, { name, components }] of reduced.variables.entries()) {
    const wanted = original.variables[i].components;
    if (components === wanted) continue;
    throw new Fault(`${path}: “${name}” has ${counted(components, 'component')}, that of the original ${wanted}.`);
  }
}

/** In the variable's unit. */
function absoluteBound(bounds: Bounds, variable: Variable, triangles: Uint32Array): number {
  const bound = boundOf(bounds, variable);
  if (bound === 'free') return Number.POSITIVE_INFINITY;
  return 'absolute' in bound ? bound.absolute : bound.relative * scaleOf(spanOf(variable, triangles));
}
