// The page about the element: examples that are what they show, and tables made from the element's manifest.
import '../element/index.ts';
import type { MeshboundViewer } from '../element/meshbound-viewer.ts';
import { referenceOf } from './reference.ts';

const script = '<script type="module" src="element/meshbound-viewer.js"></script>';
for (const place of document.querySelectorAll('pre.script')) place.textContent = script;

for (const figure of document.querySelectorAll<HTMLElement>('figure.example:not(.told)')) {
  const code = document.createElement('pre');
  code.textContent = sourceOf(figure.querySelector('meshbound-viewer') as Element);
  figure.append(code);
}

const viewer = document.querySelector('meshbound-viewer') as MeshboundViewer;
const said = document.querySelector('#said') as HTMLOutputElement;
viewer.addEventListener('reduce', () => {
  if (viewer.report) said.textContent = `${viewer.report.triangles.after} triangles`;
});
document.querySelector('#loosen')?.addEventListener('click', () => {
  viewer.bounds = 'position: 5%; *: 5%';
});

const manifest = await fetch('element/custom-elements.json');
document.querySelector('#reference')?.append(referenceOf(await manifest.json()));

/** An element as its author wrote it. */
function sourceOf(element: Element): string {
  const attributes = [...element.attributes].map(({ name, value }) => (value ? `${name}="${value}"` : name));
  const inside = element.innerHTML.trim();
  return `<meshbound-viewer\n  ${attributes.join('\n  ')}\n>${inside ? `\n  ${inside}\n` : ''}</meshbound-viewer>`;
}
