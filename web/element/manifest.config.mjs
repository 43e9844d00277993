const element = 'web/element/meshbound-viewer.ts';
const table = 'web/element/attributes/attributes.ts';

/** What is for the element's own parts, and what the analyser takes for an event because events are sent in one place. */
function isPublic(member) {
  return member.privacy !== 'private' && member.name !== 'drawnOnce';
}

const types = { text: 'string | null', choice: 'string | null', flag: 'boolean', number: 'number | null' };

/** The entries of the table of attributes: what documents them, and by which of its functions they are made. */
const declared = [];

const attributesFromTable = {
  name: 'attributes-from-table',
  analyzePhase({ ts, node, moduleDoc }) {
    if (!moduleDoc.path.endsWith(table) || !ts.isVariableDeclaration(node) || node.name.getText() !== 'attributes')
      return;
    for (const entry of node.initializer.properties) {
      const property = entry.name.getText();
      const kind = /\b(text|choice|flag|number)\b/.exec(entry.initializer.getText())[1];
      const attribute = property.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
      const description = entry.jsDoc.at(-1).comment;
      const value = { type: { text: types[kind] }, description, default: kind === 'flag' ? 'false' : 'null' };
      declared.push({ property, attribute, value });
    }
  },
};

const publicOnly = {
  name: 'public-only',
  packageLinkPhase({ customElementsManifest }) {
    customElementsManifest.modules = customElementsManifest.modules.filter(({ path }) => path.endsWith(element));
    for (const declaration of customElementsManifest.modules.flatMap(({ declarations }) => declarations)) {
      const names = new Set(declared.map(({ property }) => property));
      const others = declaration.members?.filter((member) => isPublic(member) && !names.has(member.name)) ?? [];
      const fields = declared.map(({ property: name, attribute, value }) => {
        return { kind: 'field', name, privacy: 'public', ...value, attribute };
      });
      declaration.members = [...fields, ...others];
      declaration.attributes = declared.map(({ property, attribute, value }) => {
        return { name: attribute, ...value, fieldName: property };
      });
      declaration.events = declaration.events?.filter(({ description }) => description);
      declaration.superclass = { name: 'LitElement', package: 'lit' };
    }
  },
};

/** dist/element/custom-elements.json: what editors, and the page about the element, know of it. */
export default {
  globs: [element, table],
  outdir: 'dist/element',
  litelement: true,
  packagejson: false,
  plugins: [attributesFromTable, publicOnly],
};
