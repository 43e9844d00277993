import type { Variable } from '../../../wasm/types.ts';
import { quoted } from '../text/wording.ts';

/** Names that no variable can have, since bounds mean something else by them. */
const reserved = new Map([
  ['position', 'is the geometry'],
  ['*', 'stands for all variables'],
]);

export const reservedNames: readonly string[] = [...reserved.keys()];

export interface Renamed {
  variables: Variable[];
  /** The new names, by the old ones; empty where nothing was renamed. */
  names: ReadonlyMap<string, string>;
  notes: string[];
}

/** Variables with names that they may have; one that may not gets another one, which is said. */
export function renamedVariables(variables: Variable[]): Renamed {
  const taken = new Set(variables.map(({ name }) => name));
  const names = new Map<string, string>();
  for (const { name } of variables) {
    if (!reserved.has(name)) continue;
    let free = `${name}_2`;
    for (let copy = 3; taken.has(free); copy++) free = `${name}_${copy}`;
    taken.add(free);
    names.set(name, free);
  }
  const notes = [...names].map(
    ([name, free]) =>
      `The variable ${quoted(name)} is called ${quoted(free)} from here on: ${quoted(name)} ${reserved.get(name)}.`,
  );
  return { variables: variables.map((each) => ({ ...each, name: names.get(each.name) ?? each.name })), names, notes };
}

/** What is said of variables, by their new names. */
export function renamedKeys<Said>(
  labels: Record<string, Said>,
  names: ReadonlyMap<string, string>,
): Record<string, Said> {
  const entries = Object.entries(labels).map(([name, said]): [string, Said] => [names.get(name) ?? name, said]);
  // As in noLabels: a variable may be called as what every object has.
  return Object.assign(Object.create(null), Object.fromEntries(entries));
}
