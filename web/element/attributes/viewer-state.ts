import { english } from '../../words/english.ts';
import { type Attribute, type AttributeName, attributeName, attributes, properties } from './attributes.ts';

const stateProperties = properties.filter((property) => attributes[property].isState);

/**
 * What can be said of a viewer as attributes, in the order in which they are written. Data are never among them, only the
 * address that they come from.
 */
export const stateAttributes = stateProperties.map(attributeName);
export type StateAttribute = AttributeName;

/** What attributes are where nothing is said: a state need not say it. */
export const firstState: ViewerState = Object.fromEntries(
  stateProperties.flatMap((property) => {
    const { meaning }: Attribute<unknown> = attributes[property];
    return meaning === undefined ? [] : [[attributeName(property), meaning]];
  }),
);

/** The attributes of a viewer that are not as at first; those without a value are empty. */
export type ViewerState = Partial<Record<StateAttribute, string>>;

/** The part of an address behind `#` that stands for a state: `src=a.ply&bounds=position:+1%25`. */
export function stateFragment(state: ViewerState): string {
  const fragment = new URLSearchParams();
  for (const name of stateAttributes) {
    const value = state[name];
    if (value !== undefined) fragment.set(name, value);
  }
  return `${fragment}`;
}

/** The state that a fragment stands for; what it does not know it leaves out. */
export function stateFromFragment(fragment: string): ViewerState {
  const given = new URLSearchParams(fragment.replace(/^#/, ''));
  return knownState(Object.fromEntries(given));
}

/** A state as a file. */
export function stateJson(state: ViewerState): string {
  return `${JSON.stringify({ meshbound: 1, ...state }, undefined, 2)}\n`;
}

/** The state in a file. Throws where it holds none. */
export function stateFromJson(text: string): ViewerState {
  let given: unknown;
  try {
    given = JSON.parse(text);
  } catch {
    throw new Error(english.faults.stateNotJson);
  }
  if (typeof given !== 'object' || given === null || !('meshbound' in given)) {
    throw new Error(english.faults.stateMissing);
  }
  return knownState(given as Record<string, unknown>);
}

function knownState(given: Record<string, unknown>): ViewerState {
  const known = stateAttributes.filter((name) => Object.hasOwn(given, name) && typeof given[name] === 'string');
  return Object.fromEntries(known.map((name) => [name, given[name]]));
}

/** What to paste into a page to have this viewer there. */
export function embedSnippet(state: ViewerState, module: string): string {
  const attributes = stateAttributes.flatMap((name) => {
    const value = state[name];
    if (value === undefined) return [];
    return value === '' ? [name] : [`${name}="${escaped(value)}"`];
  });
  return `<script type="module" src="${escaped(module)}"></script>
<meshbound-viewer controls ${attributes.join('\n  ')}></meshbound-viewer>
`;
}

function escaped(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');
}
