/** What the page shows of an entry of the manifest. */
interface Entry {
  name: string;
  description?: string;
  kind?: string;
  attribute?: string;
  type?: { text: string };
  parameters?: { name: string; type?: { text: string } }[];
  return?: { type?: { text: string } };
}

interface Declaration {
  members: Entry[];
  events: Entry[];
  slots: Entry[];
  cssParts: Entry[];
  cssProperties: Entry[];
}

export interface Manifest {
  modules: { declarations: Declaration[] }[];
}

/** Tables of everything that the element has, from its custom-elements manifest. */
export function referenceOf({ modules }: Manifest): DocumentFragment {
  const { members, events, slots, cssParts, cssProperties } = modules[0].declarations[0];
  const methods = members.filter(({ kind }) => kind === 'method');
  const others = members.filter(({ kind, attribute }) => kind === 'field' && !attribute);
  const page = document.createDocumentFragment();
  const tables: [string, Entry[], (entry: Entry) => string][] = [
    [
      'Attributes, and below them the properties that are named otherwise',
      members.filter(({ attribute }) => attribute),
      typeOf,
    ],
    ['Further properties', others, typeOf],
    ['Methods', methods, signatureOf],
    ['Events', events, typeOf],
    ['Slots', slots, typeOf],
    ['Parts', cssParts, typeOf],
    ['Custom properties', cssProperties, typeOf],
  ];
  for (const [title, entries, about] of tables) page.append(heading(title), table(entries, about));
  return page;
}

/** What HTML calls it, and what JavaScript does. */
function namesOf({ name, attribute = name }: Entry): string[] {
  return attribute === name ? [name] : [attribute, name];
}

function typeOf({ type }: Entry): string {
  return type?.text ?? '';
}

function signatureOf({ parameters = [], return: given }: Entry): string {
  const list = parameters.map(({ name, type }) => `${name}: ${type?.text ?? 'unknown'}`).join(', ');
  return `(${list}): ${given?.type?.text ?? 'void'}`;
}

function heading(text: string): HTMLElement {
  const heading = document.createElement('h2');
  heading.textContent = text;
  return heading;
}

function table(entries: Entry[], about: (entry: Entry) => string): HTMLElement {
  const frame = document.createElement('div');
  frame.className = 'table';
  // It can be wider than the page, and must be reached from the keyboard then.
  frame.tabIndex = 0;
  const rows = document.createElement('table');
  for (const entry of entries) {
    const row = rows.insertRow();
    row.insertCell().append(...namesOf(entry).map(code));
    row.insertCell().append(...(about(entry) ? [code(about(entry))] : []));
    row.insertCell().append(...prose(entry.description ?? ''));
  }
  frame.append(rows);
  return frame;
}

function code(text: string): HTMLElement {
  const element = document.createElement('code');
  element.textContent = text;
  return element;
}

/** Text with `code` in it. */
function prose(text: string): (string | HTMLElement)[] {
  return text.split('`').map((part, index) => (index % 2 === 1 ? code(part) : part));
}
