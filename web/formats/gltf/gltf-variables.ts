import type { Accessor, Primitive } from '@gltf-transform/core';
import type { Mesh, Variable } from '../../../wasm/types.ts';
import { joined } from '../bytes/joined-arrays.ts';
import { FormatError } from '../format-error.ts';
import { type Labels, noLabels, type WriteOptions } from '../surface.ts';
import { listed, quoted } from '../text/wording.ts';
import { areBytes } from '../variables/colours.ts';
import { asFloatingPoint } from '../variables/precision.ts';
import { byRole, declareRole, nameOf, type Role, roleSpelled, spellings } from '../variables/roles.ts';
import { upsideDown } from './texture-direction.ts';

/** An attribute of a primitive as a variable. Numbers of glTF are single precision; texture coordinates are so no more when v is turned round. */
export interface GltfAttribute {
  name: string;
  semantic: string;
  components: number;
  values: Float32Array | Float64Array;
  unit: string | undefined;
  componentNames: string[] | undefined;
}

/**
 * What the project's writer keeps in the extras of an accessor, since glTF has no place for it: names in any letters, units,
 * and which component of a variable this is where glTF has no type of so many components.
 */
export interface GltfExtras {
  name: string;
  unit?: string;
  componentNames?: string[];
  component?: number;
}

/** The variable that a semantic stands for; undefined for what is not carried (tangents, joints, weights). */
function variableName(semantic: string): string | undefined {
  const more = /^((?:COLOR|TEXCOORD)_)([1-9]\d*)$/.exec(semantic);
  const role = roleSpelled('gltf', more ? `${more[1]}0` : semantic);
  if (role) return more ? `${nameOf(role)}_${more[2]}` : nameOf(role);
  return semantic.startsWith('_') && semantic.length > 1 ? semantic.slice(1) : undefined;
}

/**
 * The semantic for a variable: that of its role, where it has one and its values fit that; else, as glTF prescribes it, an
 * underscore and capitals.
 */
export function semanticFor(variable: Variable, role: Role | undefined): string {
  const semantic = role && spellings[role].gltf;
  if (semantic && fits(variable, role)) return semantic;
  return `_${variable.name.toUpperCase().replace(/[^A-Z0-9]+/g, '_')}`;
}

/** The variables whose values glTF does not allow in the places of their roles. */
export function unfitInGltf({ variables }: Pick<Mesh, 'variables'>, options: Pick<WriteOptions, 'roles'>): Variable[] {
  const unfit = [...byRole(variables, options)].filter(([role, each]) => spellings[role].gltf && !fits(each, role));
  return unfit.map(([, variable]) => variable);
}

/** Whether glTF allows such values in the place of a role. */
function fits(variable: Variable, role: Role): boolean {
  const { values } = variable;
  if (role === 'normal') return areUnitVectors(values);
  if (role === 'colour') return areBytes(values) || values.every((value: number) => value >= 0 && value <= 1);
  return true;
}

/** Whether an attribute is texture coordinates, whose v falls in glTF. */
export function isTexture(semantic: string): boolean {
  return /^TEXCOORD_\d+$/.test(semantic);
}

function areUnitVectors(values: ArrayLike<number>): boolean {
  // As the validator of the Khronos Group has it.
  const tolerance = 0.00674;
  for (let at = 0; at < values.length; at += 3) {
    const length = Math.hypot(values[at], values[at + 1], values[at + 2]);
    if (!(Math.abs(length - 1) <= tolerance)) return false;
  }
  return true;
}

/** Before the semantics of attributes while glTF-Transform has them: it stumbles over one that is named `__proto__`. */
const guard = 'attribute ';

export function safeName(semantic: string): string {
  return guard + semantic;
}

/** The attributes of a primitive under names that nothing in JavaScript has. */
export function withSafeNames(attributes: Record<string, number>): Record<string, number> {
  return Object.fromEntries(Object.entries(attributes).map(([semantic, accessor]) => [safeName(semantic), accessor]));
}

/** The attributes of a primitive that become variables, and the semantics of those that do not. */
export function namedAttributes(
  primitive: Primitive,
  where: string,
  points: number,
  numbersOf: (accessor: Accessor) => Float32Array,
): { attributes: GltfAttribute[]; lost: string[] } {
  const parts = new Map<string, Part[]>();
  const lost: string[] = [];
  for (const safe of primitive.listSemantics()) {
    const accessor = primitive.getAttribute(safe);
    const semantic = safe.slice(guard.length);
    if (semantic === 'POSITION' || !accessor) continue;
    const extras = extrasOf(accessor);
    const name = extras.name ?? variableName(semantic);
    if (name === undefined) lost.push(semantic);
    if (name === undefined) continue;
    if (accessor.getCount() !== points) {
      const message = `The attribute ${quoted(semantic)} of ${where} has ${accessor.getCount()} elements, but POSITION ${points}.`;
      throw new FormatError('count_mismatch', message, where);
    }
    const numbers = byteColours(accessor, semantic) ?? numbersOf(accessor);
    const values = isTexture(semantic) ? asFloatingPoint(upsideDown(numbers)) : numbers;
    const part = { extras, semantic, size: accessor.getElementSize(), values };
    const others = parts.get(name);
    if (others) others.push(part);
    else parts.set(name, [part]);
  }
  return { attributes: [...parts].map(([name, list]) => assemble(name, list, where)), lost };
}

/** A colour of normalised bytes as these, 0…255; undefined for all else. */
function byteColours(accessor: Accessor, semantic: string): Float32Array | undefined {
  const bytes = accessor.getArray();
  const isBytes = bytes instanceof Uint8Array && accessor.getNormalized();
  return isBytes && /^COLOR_\d+$/.test(semantic) ? Float32Array.from(bytes) : undefined;
}

interface Part {
  extras: Partial<GltfExtras>;
  semantic: string;
  size: number;
  values: Float32Array | Float64Array;
}

/** What the project's writer left in the extras, as far as it is what it should be. */
export function extrasOf(accessor: Accessor): Partial<GltfExtras> {
  const { name, unit, componentNames, component } = (accessor.getExtras().meshbound ?? {}) as Partial<GltfExtras>;
  const isString = (value: unknown) => typeof value === 'string';
  const isText = (value: unknown) => isString(value) && value !== '';
  return {
    ...(isText(name) ? { name } : {}),
    ...(isText(unit) ? { unit } : {}),
    ...(Array.isArray(componentNames) && componentNames.every(isString) ? { componentNames } : {}),
    ...(Number.isSafeInteger(component) ? { component } : {}),
  };
}

/** A variable from one attribute, or from several that are a component each. */
function assemble(name: string, parts: Part[], where: string): GltfAttribute {
  const [first] = parts;
  const { semantic } = first;
  const { unit, componentNames } = first.extras;
  const said = { name, semantic, unit, componentNames };
  if (parts.length === 1) return { ...said, components: first.size, values: first.values };
  const byComponent = new Map(parts.filter(({ size }) => size === 1).map((part) => [part.extras.component, part]));
  const complete = parts.flatMap((_, index) => byComponent.get(index) ?? []);
  if (complete.length < parts.length) {
    throw new FormatError('duplicate_name', `The ${where} has two attributes named ${quoted(name)}.`, where);
  }
  const components = parts.length;
  const values = new Float32Array(first.values.length * components);
  for (const [component, part] of complete.entries()) {
    for (let point = 0; point < part.values.length; point++)
      values[point * components + component] = part.values[point];
  }
  return { ...said, components, values };
}

/** The variables that all primitives have, one primitive after the other. */
export function joinAttributes(parts: GltfAttribute[][], notes: string[]): { variables: Variable[]; labels: Labels } {
  const labels = noLabels();
  const partial = new Set(parts.flatMap((part) => part.map(({ name }) => name)));
  const attributesOf = parts.map((part) => new Map(part.map((attribute) => [attribute.name, attribute])));
  const roles: Record<string, Role> = Object.create(null);
  const variables = parts[0].flatMap(({ name, semantic, components, unit, componentNames }): Variable[] => {
    const matching = attributesOf.flatMap((attributes) => attributes.get(name) ?? []);
    const found = matching.filter((other) => other.components === components);
    if (found.length < parts.length) return [];
    partial.delete(name);
    declareRole(roles, { name, components }, roleSpelled('gltf', semantic));
    if (unit) labels.units[name] = unit;
    if (componentNames?.length === components) labels.componentNames[name] = componentNames;
    const values = found.map((each) => each.values);
    const single = values.every((each) => each instanceof Float32Array);
    return [{ name, components, values: single ? joined(values, Float32Array) : joined(values, Float64Array) }];
  });
  if (partial.size > 0) notes.push(`Not carried, since not every primitive has them: ${listed([...partial])}.`);
  return { variables, labels: { ...labels, roles } };
}
