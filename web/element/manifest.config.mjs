/** What is for the element's own parts, and what the analyser takes for an event because events are sent in one place. */
function isPublic(member) {
  return member.privacy !== 'private' && member.name !== 'drawnOnce';
}

const publicOnly = {
  name: 'public-only',
  packageLinkPhase({ customElementsManifest }) {
    for (const element of customElementsManifest.modules.flatMap(({ declarations }) => declarations)) {
      element.members = element.members?.filter(isPublic);
      element.attributes = element.attributes?.filter(isPublic);
      element.events = element.events?.filter(({ description }) => description);
    }
  },
};

/** dist/element/custom-elements.json: what editors, and the page about the element, know of it. */
export default {
  globs: ['web/element/meshbound-viewer.ts'],
  outdir: 'dist/element',
  litelement: true,
  packagejson: false,
  plugins: [publicOnly],
};
