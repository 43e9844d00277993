import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import type { Bound } from '../../wasm/types.ts';
import { boundsText, readBounds } from '../../web/session/bounds/bound-text.ts';

describe('bounds as text', () => {
  test.each<[string, Record<string, Bound>]>([
    [
      'position: 1%; pressure: 3%; velocity: 0.2',
      { position: { relative: 0.01 }, pressure: { relative: 0.03 }, velocity: { absolute: 0.2 } },
    ],
    ['  *:free ;', { '*': 'free' }],
    ['', {}],
    ['"a: b; \\"c\\"": 1e-3', { 'a: b; "c"': { absolute: 0.001 } }],
    ['mean p: 0.5 %', { 'mean p': { relative: 0.005 } }],
    ['p: 1%; p: 2%', { p: { relative: 0.02 } }],
  ])('%j is understood', (text, bounds) => expect(readBounds(text)).toEqual(bounds));

  test.each([
    ['pressure', '“pressure” does not have the form'],
    ['p: 1%; 3%', '“3%” does not have the form'],
    [': 1%', 'does not have the form'],
    ['p: three', '“three” is not a number'],
    ['p:', '“” is not a number'],
    ['p: -1%', '“-1%” is not a finite number above zero'],
    ['p: 0', 'above zero'],
    ['p: Infinity', 'above zero'],
    ['"p: 1%', 'does not have the form'],
    ['"\\q": 1%', 'escape'],
  ])('%j is refused: %s', (text, reason) => expect(() => readBounds(text)).toThrow(reason));

  test('whatever is written is read back as it was', () => {
    const size = fc.double({ min: 1e-300, max: 1e300, noNaN: true });
    const bound = fc.oneof(
      fc.constant<Bound>('free'),
      size.map((absolute): Bound => ({ absolute })),
      fc.integer({ min: 1, max: 99_999 }).map((count): Bound => ({ relative: count / 1e7 })),
    );
    fc.assert(
      fc.property(fc.dictionary(fc.string({ minLength: 1, unit: 'binary' }), bound), (bounds) => {
        expect(readBounds(boundsText(bounds))).toEqual({ ...bounds });
      }),
    );
  });
});
