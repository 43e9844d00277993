import { describe, expect, test } from 'vitest';
import { firstView, settingsFor, type WantedView } from '../../web/element/attributes/view-settings.ts';
import type { OpenSurface } from '../../web/session/reading/open-surface.ts';

const extent = { components: 1, extent: 1, magnitude: 1, constant: false };
const position = { ...extent, name: 'position', components: 3 };
const surface = (variables: object[], componentNames: Record<string, string[]> = {}) =>
  ({ variables, labels: { units: {}, componentNames } }) as unknown as OpenSurface;

const nothing: WantedView = {
  variable: null,
  component: null,
  show: null,
  colormap: null,
  range: null,
  view: null,
  edges: false,
  flat: false,
  cull: false,
  orthographic: false,
  clip: null,
  unlinked: false,
};

describe('the view of a surface, where nothing is asked for', () => {
  test('is that of the first variable that varies', () => {
    const density = { ...extent, name: 'density', constant: true };
    const opened = surface([position, density, { ...extent, name: 'pressure' }]);
    expect(settingsFor(opened, nothing)).toMatchObject({ ...firstView, variable: 'pressure', component: 0 });
  });

  test('is the magnitude of a vector', () => {
    const opened = surface([position, { ...extent, name: 'velocity', components: 3 }]);
    expect(settingsFor(opened, nothing)).toMatchObject({ variable: 'velocity', component: 'magnitude' });
  });

  test('is that of the geometry where there are no variables', () =>
    expect(settingsFor(surface([position]), nothing).variable).toBe('position'));
});

describe('what is asked for', () => {
  const opened = surface(
    [
      position,
      { ...extent, name: 'a' },
      { ...extent, name: 'b', components: 2 },
      { ...extent, name: 'c', components: 9 },
    ],
    { c: ['xx', 'xy', 'xz', 'yx', 'yy', 'yz', 'zx', 'zy', 'zz'] },
  );

  test('is shown', () => {
    const view = {
      range: '0…1',
      view: 'reduced',
      flat: true,
      cull: true,
      orthographic: true,
      clip: 'x < 0.5',
      unlinked: true,
    };
    const wanted = { ...nothing, variable: 'b', component: 'y', show: 'error', colormap: 'cividis', ...view };
    expect(settingsFor(opened, wanted)).toEqual({
      variable: 'b',
      component: 1,
      quantity: 'error',
      colormap: 'cividis',
      range: '0…1',
      view: 'reduced',
      edges: false,
      flat: true,
      doubleSided: false,
      orthographic: true,
      clip: 'x < 0.5',
      linked: false,
    });
  });

  test('may be a component by the name that the file gives it', () =>
    expect(settingsFor(opened, { ...nothing, variable: 'c', component: 'yz' }).component).toBe(5));

  test('is left to the viewer where it does not exist', () => {
    const wanted = {
      ...nothing,
      variable: 'none',
      component: 'w',
      show: 'all',
      colormap: 'jet',
      range: '1…0',
      clip: 'w',
    };
    expect(settingsFor(opened, wanted)).toEqual({ ...firstView, variable: 'a', component: 0 });
  });

  test.each([
    ['a', 'signed-error'],
    ['position', 'signed-error'],
    ['b', 'error'],
  ])('of the signed errors of %s is %s: those of a vector have none', (variable, quantity) =>
    expect(settingsFor(opened, { ...nothing, variable, show: 'signed-error' }).quantity).toBe(quantity),
  );
});
