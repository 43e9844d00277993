const element = 'web/element/meshbound-viewer.ts';

/** What is for the element's own parts, and what the analyser takes for an event because events are sent in one place. */
function isPublic(member) {
  return member.privacy !== 'private' && member.name !== 'drawnOnce';
}

/** From which file of its own the element has something is nobody's concern; what is asked of it comes first. */
function asOwn(members = []) {
  const [inherited, own] = [members.filter(isInherited), members.filter((member) => !isInherited(member))];
  return [...inherited.map(({ inheritedFrom, ...member }) => member), ...own];
}

function isInherited({ inheritedFrom }) {
  return inheritedFrom !== undefined;
}

const publicOnly = {
  name: 'public-only',
  packageLinkPhase({ customElementsManifest }) {
    customElementsManifest.modules = customElementsManifest.modules.filter(({ path }) => path.endsWith(element));
    for (const declaration of customElementsManifest.modules.flatMap(({ declarations }) => declarations)) {
      declaration.members = asOwn(declaration.members?.filter(isPublic));
      declaration.attributes = asOwn(declaration.attributes?.filter(isPublic));
      declaration.events = declaration.events?.filter(({ description }) => description);
      declaration.superclass = { name: 'LitElement', package: 'lit' };
    }
  },
};

/** dist/element/custom-elements.json: what editors, and the page about the element, know of it. */
export default {
  globs: [element, 'web/element/attributes/viewer-properties.ts'],
  outdir: 'dist/element',
  litelement: true,
  packagejson: false,
  plugins: [publicOnly],
};
