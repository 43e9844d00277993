import fc from 'fast-check';
import { expect, test } from 'vitest';
import { removedText as removedOnPage, tickText, valueText } from '../../web/element/number-text.ts';
import { numberText, placeText, rangeTexts, removedText } from '../../web/node-cli/output/text-table.ts';
import { rangeDigits, removedPercent, tellingDigits } from '../../web/session/bounds/rounding.ts';

const plain = (text: string) => text.replace(/[\u202f\u00a0]/g, ' ');

test.each([
  [320_000, 2, '99.999 %', '99.999 %'],
  [576, 42, '92.71 %', '92.7 %'],
  [4, 0, '100 %', '100 %'],
  [1_000_000, 1, '99.999 %', '99.999 %'],
  [10_000, 1, '99.99 %', '99.9 %'],
  [20_000, 1, '99.99 %', '99.99 %'],
  [2000, 1, '99.95 %', '99.9 %'],
  [100, 100, '0 %', '0 %'],
])('of %i triangles to %i are gone %s', (before, after, onLine, onPage) => {
  expect(removedText(before, after)).toBe(onLine);
  expect(plain(removedOnPage(before, after))).toBe(onPage);
});

test('a share that is gone is never 100 % where something is left, nor more than it is by its digits', () => {
  const counts = fc.tuple(fc.integer({ min: 2, max: 2 ** 31 }), fc.integer({ min: 1, max: 2 ** 31 }));
  fc.assert(
    fc.property(counts, fc.integer({ min: 3, max: 6 }), ([one, other], digits) => {
      const [after, before] = [Math.min(one, other), Math.max(one, other) + 1];
      const percent = removedPercent(before, after, digits);
      const exact = 100 - (100 * after) / before;
      expect(percent).toBeLessThan(100);
      expect(Math.abs(percent - exact)).toBeLessThanOrEqual(
        Math.max((100 * after) / before, exact * 10 ** (1 - digits)),
      );
    }),
  );
});

test('the ends of a range never read alike where they differ', () => {
  const finite = fc.double({ noNaN: true, noDefaultInfinity: true, min: -1e300, max: 1e300 });
  fc.assert(
    fc.property(finite, fc.double({ min: 1e-12, max: 1, noNaN: true }), (lowest, share) => {
      const highest = lowest + Math.abs(lowest) * share;
      fc.pre(highest > lowest);
      const [low, high] = rangeTexts([lowest, highest]);
      expect(low).not.toBe(high);
      expect(Math.abs(Number(low) - lowest)).toBeLessThanOrEqual(0.02 * (highest - lowest));
      const digits = rangeDigits(lowest, highest, 4);
      expect(valueText(lowest, digits)).not.toBe(valueText(highest, digits));
    }),
  );
});

test.each([
  [6_000_000, 6_000_123.4, '6000000', '6000123.4'],
  [1e7, 1e7 + 1, '10000000', '10000001'],
  [0, 1, '0', '1'],
  [-1.6483e-7, 0.5, '-1.648e-7', '0.5'],
  [300, 300, '300', '300'],
  [1e20, 2e20, '1e+20', '2e+20'],
])('%d to %d reads %s to %s', (lowest, highest, low, high) =>
  expect(rangeTexts([lowest, highest])).toEqual([low, high]),
);

test('a place is told from others in its box, and a number from one beside it', () => {
  const box = [500_000, 6_000_000, 0].map((lowest) => ({ lowest, highest: lowest + 10 }));
  expect(placeText([500_003.25, 6_000_003.25, 3.25], box)).toBe('(500003.25, 6000003.25, 3.25)');
  expect(numberText(12_345_678)).toBe('1.235e+7');
  expect(tellingDigits(4_100_123, 0.02, 4)).toBe(12);
  expect(plain(valueText(4_100_123.456, tellingDigits(4_100_123.456, 0.02, 4)))).toBe('4 100 123.456');
  expect(plain(tickText(4_100_000.5, { lowest: 4_100_000, highest: 4_100_001 }))).toBe('4 100 000.5');
});
