import { nameOf, type Role, spellings } from '../variables/roles.ts';

/** A variable and the properties that hold its components, in their order. */
export interface PlyVariable {
  name: string;
  properties: string[];
}

const fixedGroups: PlyVariable[] = (Object.keys(spellings) as Role[]).flatMap((role) =>
  (spellings[role].ply ?? []).map((properties) => ({ name: nameOf(role), properties: [...properties] })),
);
/** Properties that may be texture coordinates as well as two quantities, as s and t; what beside them says that they are none. */
const otherwise = new Map([['u', 'w']]);
const axes = ['x', 'y', 'z'];

/**
 * Which properties make up which variable. PLY knows numbers only, so vectors are told by their usual names: nx ny nz, red
 * green blue (alpha), name_x name_y name_z, name_0 name_1 …; or by a comment `variable "name" property property …`, which
 * the writer leaves where the names alone would mislead. Any other property is a scalar variable.
 */
export function groupProperties(properties: string[], comments: string[] = []): PlyVariable[] {
  const free = new Set(properties);
  const groups = declaredGroups(comments).filter((group) => take(group, free));
  const taken = new Set(groups.map(({ name }) => name));
  for (const group of [...fixedGroups, ...suffixGroups(properties)]) {
    const isOther = free.has(otherwise.get(group.properties[0]) ?? '');
    if (isOther || free.has(group.name) || taken.has(group.name) || !take(group, free)) continue;
    groups.push(group);
    taken.add(group.name);
  }
  for (const name of free) groups.push({ name, properties: [name] });
  const byFirst = new Map(groups.map((group) => [group.properties[0], group]));
  return properties.flatMap((name) => byFirst.get(name) ?? []);
}

function take(group: PlyVariable, free: Set<string>): boolean {
  const whole = group.properties.every((name) => free.has(name));
  if (whole) for (const name of group.properties) free.delete(name);
  return whole;
}

function suffixGroups(properties: string[]): PlyVariable[] {
  const bases = new Map<string, Set<string>>();
  for (const property of properties) {
    const match = /^(.+)_([xyz]|0|[1-9]\d*)$/.exec(property);
    if (match) bases.set(match[1], (bases.get(match[1]) ?? new Set()).add(match[2]));
  }
  return [...bases].flatMap(([name, suffixes]) => {
    const hasAxes = axes.every((axis) => suffixes.has(axis));
    const found = hasAxes ? axes : numberedFromZero(suffixes);
    return found.length > 1 ? [{ name, properties: found.map((suffix) => `${name}_${suffix}`) }] : [];
  });
}

function numberedFromZero(suffixes: Set<string>): string[] {
  const numbers: string[] = [];
  while (suffixes.has(String(numbers.length))) numbers.push(String(numbers.length));
  return numbers;
}

/** Comments of the form `variable "name" property …`. Anyone may write a comment, so whatever is not one is passed over. */
function declaredGroups(comments: string[]): PlyVariable[] {
  return comments.flatMap((comment) => {
    const declared = parseNamed(comment, 'variable');
    const properties = declared?.rest.split(/\s+/).filter(Boolean) ?? [];
    const differ = new Set(properties).size === properties.length;
    return declared && properties.length > 0 && differ ? [{ name: declared.name, properties }] : [];
  });
}

/** Units from comments of the form `unit NAME UNIT` or `unit "NAME" UNIT`. */
export function declaredUnits(comments: string[]): [name: string, unit: string][] {
  return comments.flatMap((comment) => {
    const declared = parseNamed(comment, 'unit');
    return declared?.rest ? [[declared.name, declared.rest] as [string, string]] : [];
  });
}

/** Names of labels from comments of the form `regions "NAME" property`, by the property of the faces that holds them. */
export function declaredRegions(comments: string[]): Map<string, string> {
  return new Map(
    comments.flatMap((comment) => {
      const declared = parseNamed(comment, 'regions');
      return declared?.rest ? [[declared.rest, declared.name] as [string, string]] : [];
    }),
  );
}

/** Component names from comments of the form `components "NAME" ["u","v","w"]`. */
export function declaredComponentNames(comments: string[]): [name: string, names: string[]][] {
  return comments.flatMap((comment) => {
    const declared = parseNamed(comment, 'components');
    const names = declared && parseJson(declared.rest);
    const valid = Array.isArray(names) && names.every((name) => typeof name === 'string');
    return declared && valid ? [[declared.name, names] as [string, string[]]] : [];
  });
}

function parseNamed(comment: string, keyword: string): { name: string; rest: string } | undefined {
  const match = /^(\w+)\s+("(?:[^"\\]|\\.)*"|[^\s"]\S*)\s*(.*)$/.exec(comment);
  if (match?.[1] !== keyword) return undefined;
  const name = match[2].startsWith('"') ? parseJson(match[2]) : match[2];
  return typeof name === 'string' ? { name, rest: match[3] } : undefined;
}

function parseJson(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

/** The names of the properties that hold a variable of a mesh, before they are made unique; `role` is that whose place it takes. */
export function propertyNames(name: string, components: number, role?: Role): readonly string[] {
  const fixed = role && spellings[role].ply?.find((properties) => properties.length === components);
  if (fixed) return fixed;
  if (components === 1) return [name];
  const suffixes = components === axes.length ? axes : Array.from({ length: components }, (_, index) => String(index));
  return suffixes.map((suffix) => `${name}_${suffix}`);
}
