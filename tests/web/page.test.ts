import { describe, expect, test } from 'vitest';
import { reducedFileName } from '../../web/element/file-name.ts';
import { firstView, settingsFor, showing, type ViewSettings } from '../../web/element/view-settings.ts';
import { fractionAt, placeOf } from '../../web/page/bound-place.ts';
import type { OpenSurface } from '../../web/session/session.ts';

describe('the slider', () => {
  test('reaches from 0.01 % to 20 %', () => {
    expect(fractionAt(0)).toBe(0.0001);
    expect(fractionAt(1)).toBe(0.2);
  });

  test('is logarithmic', () => {
    const third = placeOf(0.001) - placeOf(0.0001);
    expect(placeOf(0.01) - placeOf(0.001)).toBeCloseTo(third, 12);
    expect(placeOf(0.1) - placeOf(0.01)).toBeCloseTo(third, 12);
  });

  test('stands at its end for bounds beyond it', () => {
    expect(placeOf(0.5)).toBe(1);
    expect(placeOf(1e-6)).toBe(0);
  });
});

test.each([
  ['wing.ply', 'vtp', 'wing-reduced.vtp'],
  ['Fireballs, fine', 'ply', 'Fireballs-fine-reduced.ply'],
  ['../../etc/passwd', 'ply', 'etc-passwd-reduced.ply'],
  ['???.vtp', 'ply', 'surface-reduced.ply'],
  ['wing.obj.gz', 'ply', 'wing-reduced.ply'],
])('%j is saved as %s under the name %j', (opened, format, saved) =>
  expect(reducedFileName(opened, format)).toBe(saved),
);

describe('the view of a newly opened surface', () => {
  const extent = { components: 1, extent: 1, magnitude: 1, constant: false };
  const surface = (...variables: object[]) => ({ variables }) as unknown as OpenSurface;
  const position = { ...extent, name: 'position', components: 3 };

  test('shows the first variable that varies', () => {
    const opened = surface(position, { ...extent, name: 'density', constant: true }, { ...extent, name: 'pressure' });
    expect(settingsFor(opened, firstView)).toMatchObject({ variable: 'pressure', component: 0 });
  });

  test('shows the magnitude of a vector', () => {
    const opened = surface(position, { ...extent, name: 'velocity', components: 3 });
    expect(settingsFor(opened, firstView)).toMatchObject({ variable: 'velocity', component: 'magnitude' });
  });

  test('keeps the variable where the surface has it', () => {
    const settings: ViewSettings = { ...firstView, variable: 'b', component: 0, quantity: 'signed-error', edges: true };
    const opened = surface(position, { ...extent, name: 'a' }, { ...extent, name: 'b' });
    expect(settingsFor(opened, settings)).toEqual(settings);
  });

  test('drops a component that the variable has not', () => {
    const settings: ViewSettings = { ...firstView, variable: 'b', component: 2 };
    const opened = surface(position, { ...extent, name: 'b', components: 2 });
    expect(settingsFor(opened, settings).component).toBe('magnitude');
  });

  test('falls back on the geometry', () => expect(settingsFor(surface(position), firstView).variable).toBe('position'));
});

describe('signed errors', () => {
  const settings: ViewSettings = { ...firstView, quantity: 'signed-error' };

  test.each([
    ['pressure', 1, 'signed-error'],
    ['position', 3, 'signed-error'],
    ['velocity', 3, 'error'],
  ])('of %s with %d components are shown as %s', (name, components, quantity) => {
    expect(showing({ name, components }, settings).quantity).toBe(quantity);
  });
});
