import type { Accessor, Primitive } from '@gltf-transform/core';
import type { Variable } from '../../../wasm/types.ts';
import { joined } from '../bytes/joined-arrays.ts';
import { FormatError } from '../format-error.ts';
import { type Labels, noLabels } from '../surface.ts';
import { listed, quoted } from '../text/wording.ts';
import { isByteColour, isColour } from '../variables/colours.ts';

/** An attribute of a primitive as a variable; all numbers of glTF are single precision. */
export interface GltfAttribute {
  name: string;
  components: number;
  values: Float32Array;
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

const semantics = new Map([
  ['NORMAL', 'normal'],
  ['COLOR_0', 'color'],
  ['TEXCOORD_0', 'uv'],
]);

/** The variable that a semantic stands for; undefined for what is not carried (tangents, joints, weights). */
function variableName(semantic: string): string | undefined {
  const more = /^(COLOR|TEXCOORD)_(\d+)$/.exec(semantic);
  if (semantics.has(semantic)) return semantics.get(semantic);
  if (more) return `${semantics.get(`${more[1]}_0`)}_${more[2]}`;
  return semantic.startsWith('_') && semantic.length > 1 ? semantic.slice(1) : undefined;
}

/** The semantic for a variable as glTF prescribes it: an underscore and capitals, or one of its own where the values fit it. */
export function semanticFor({ name, components, values }: Variable): string {
  const all = (isGood: (value: number) => boolean) => values.every(isGood);
  if (name === 'uv' && components === 2) return 'TEXCOORD_0';
  const fractions = () => name === 'color' && isColour({ name, components }) && all((v) => v >= 0 && v <= 1);
  if (isByteColour({ name, components, values }) || fractions()) return 'COLOR_0';
  if (name === 'normal' && components === 3 && areUnitVectors(values)) return 'NORMAL';
  return `_${name.toUpperCase().replace(/[^A-Z0-9]+/g, '_')}`;
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
    const part = {
      extras,
      size: accessor.getElementSize(),
      values: byteColours(accessor, semantic) ?? numbersOf(accessor),
    };
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
  size: number;
  values: Float32Array;
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
  const { unit, componentNames } = first.extras;
  if (parts.length === 1) return { name, components: first.size, values: first.values, unit, componentNames };
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
  return { name, components, values, unit, componentNames };
}

/** The variables that all primitives have, one primitive after the other. */
export function joinAttributes(parts: GltfAttribute[][], notes: string[]): { variables: Variable[]; labels: Labels } {
  const labels = noLabels();
  const partial = new Set(parts.flatMap((part) => part.map(({ name }) => name)));
  const attributesOf = parts.map((part) => new Map(part.map((attribute) => [attribute.name, attribute])));
  const variables = parts[0].flatMap(({ name, components, unit, componentNames }): Variable[] => {
    const matching = attributesOf.flatMap((attributes) => attributes.get(name) ?? []);
    const found = matching.filter((other) => other.components === components);
    if (found.length < parts.length) return [];
    partial.delete(name);
    if (unit) labels.units[name] = unit;
    if (componentNames?.length === components) labels.componentNames[name] = componentNames;
    const values = found.map((each) => each.values);
    return [{ name, components, values: joined(values, Float32Array) }];
  });
  if (partial.size > 0) notes.push(`Not carried, since not every primitive has them: ${listed([...partial])}.`);
  return { variables, labels };
}
