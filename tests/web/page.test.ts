import { describe, expect, test } from 'vitest';
import { fractionAt, placeOf } from '../../web/element/controls/bound-place.ts';
import { savedFileName } from '../../web/element/saving/file-name.ts';

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
  expect(savedFileName(opened, 'reduced', format)).toBe(saved),
);
