import { describe, expect, test } from 'vitest';
import {
  embedSnippet,
  stateFragment,
  stateFromFragment,
  stateFromJson,
  stateJson,
  type ViewerState,
} from '../../web/element/attributes/viewer-state.ts';

const state: ViewerState = {
  src: 'https://example.org/a b.ply?x=1&y=#2',
  bounds: 'position: 1%; "a; b": free',
  variable: '<b>"&"</b>',
  edges: '',
};

describe('the state of a viewer', () => {
  test('survives an address', () => expect(stateFromFragment(`#${stateFragment(state)}`)).toEqual(state));

  test('survives a file', () => expect(stateFromJson(stateJson(state))).toEqual(state));

  test('knows nothing that it was not made for', () => {
    expect(stateFromFragment('#variable=a&onload=alert(1)&__proto__=x')).toEqual({ variable: 'a' });
    expect(stateFromJson('{"meshbound":1,"variable":"a","edges":true,"data":[1]}')).toEqual({ variable: 'a' });
  });

  test.each(['', '{}', '[1]', 'null', 'ply\nformat'])('is not read from %j', (text) =>
    expect(() => stateFromJson(text)).toThrow('This is no state of the viewer'),
  );

  test('becomes an element to paste into a page', () => {
    const snippet = embedSnippet(state, 'https://example.org/meshbound-viewer.js');
    expect(snippet).toContain('<script type="module" src="https://example.org/meshbound-viewer.js"></script>');
    expect(snippet).toContain('variable="&lt;b>&quot;&amp;&quot;&lt;/b>"');
    expect(snippet).toMatch(/\n {2}edges><\/meshbound-viewer>/);
  });
});
