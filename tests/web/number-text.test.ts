import { expect, test } from 'vitest';
import {
  countText,
  lowerPercentText,
  percentText,
  placeErrorText,
  secondsText,
  upperText,
  usedShareText,
  valueText,
  withUnit,
} from '../../web/element/number-text.ts';
import { roundedUp } from '../../web/session/bounds/rounding.ts';

/** Narrow spaces that do not break, as plain ones. */
const plain = (text: string) => text.replace(/[\u202f\u00a0]/g, ' ');

test.each([
  [0, '0'],
  [8578, '8 578'],
  [1234567, '1 234 567'],
])('the count %d reads %j', (count, text) => expect(plain(countText(count))).toBe(text));

test.each([
  [0, '0'],
  [0.012345, '0.0123'],
  [-1234.5, '−1230'],
  [101325, '101 000'],
  [-4.5e-7, '−4.5e−7'],
  [1.354e10, '1.35e10'],
  [Infinity, '∞'],
  [NaN, '–'],
])('the value %d reads %j', (value, text) => expect(plain(valueText(value))).toBe(text));

test('a value has the digits that were asked for', () => expect(plain(valueText(12345.678, 5))).toBe('12 346'));

test('a percentage is rounded to three digits', () => expect(plain(percentText(0.0297499))).toBe('2.97 %'));

test.each([
  [0, 0],
  [0.0297001, 0.0298],
  [0.03, 0.03],
  [0.0299999, 0.03],
  [123456, 124000],
  [1.2345e-300, 1.24e-300],
])('the error %d is rounded up to %d', (error, up) => expect(roundedUp(error, 3)).toBe(up));

test('an error is never written smaller than it is, nor more than one digit larger', () => {
  for (let error = 1e-9; error < 1e9; error *= 1.37) {
    const up = roundedUp(error, 3);
    expect(up).toBeGreaterThanOrEqual(error * (1 - 1e-9));
    expect(up).toBeLessThanOrEqual(error * 1.0100001);
  }
});

test('an error within its bound is not written above it, nor smaller than it is', () => {
  expect(plain(upperText(2437.1))).toBe('2440');
  expect(plain(upperText(2437.4))).toBe('2440');
  expect(upperText(0.029701)).toBe('0.0298');
});

test('a share reads 100 % only where it is all', () => {
  expect(plain(lowerPercentText(0.99999))).toBe('99.9 %');
  expect(plain(lowerPercentText(1))).toBe('100 %');
  expect(plain(lowerPercentText(0.3))).toBe('30 %');
});

test('no unit is written where there is none', () => {
  expect(plain(withUnit('3', 'Pa'))).toBe('3 Pa');
  expect(withUnit('3', undefined)).toBe('3');
  expect(withUnit('3', '1')).toBe('3');
});

test('times are short', () => {
  expect(plain(secondsText(0.314))).toBe('0.31 s');
  expect(plain(secondsText(12.4))).toBe('12 s');
  expect(plain(secondsText(0.0001))).toBe('less than 0.01 s');
});

test.each([
  [0, '0 %', '0'],
  [1e-12, '≈ 0 %', '≈ 0'],
  [0.621, '62.1 %', '0.0621'],
  [0.99999, '99.9 %', '0.1'],
  [1, '100 %', '0.1'],
])('at a place that uses %d of a bound of 0.1 stand %j and the error %j', (share, used, error) => {
  expect(plain(usedShareText(share))).toBe(used);
  expect(plain(placeErrorText(0.1 * share, share))).toBe(error);
});

test('the error of a free variable is written whatever it is', () =>
  expect(plain(placeErrorText(1e-12, null))).toBe('1e−12'));
