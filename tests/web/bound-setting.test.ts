import { describe, expect, test } from 'vitest';
import {
  areFirst,
  asBounds,
  boundsThatFit,
  defaultBounds,
  largestFraction,
  moveAll,
  parsePercent,
  settingsFrom,
} from '../../web/session/bounds/bound-setting.ts';
import { fieldText } from '../../web/session/bounds/rounding.ts';

describe('bound settings', () => {
  test('begin at 1 % in space and 3 % in every variable', () => {
    expect(asBounds(defaultBounds([{ name: 'position' }, { name: 'pressure' }]))).toEqual({
      position: { relative: 0.01 },
      pressure: { relative: 0.03 },
    });
  });

  test('leave free what is no number somewhere, by presets too, unless a bound names it', () => {
    const variable = { components: 1, extent: 9, magnitude: 9, constant: false };
    const sst = { ...variable, name: 'sst', nonFinite: { vertices: 1, first: 0 } };
    const pressure = { ...variable, name: 'pressure' };
    expect(asBounds(defaultBounds([pressure, sst]))).toEqual({ pressure: { relative: 0.03 }, sst: 'free' });
    const preset = { '*': { relative: 0.05 } };
    const fitting = boundsThatFit(preset, [pressure, sst]);
    expect(asBounds(settingsFrom(fitting, [pressure, sst]))).toEqual({ pressure: { relative: 0.05 }, sst: 'free' });
    const named = { ...preset, sst: { relative: 0.1 } };
    expect(boundsThatFit(named, [pressure, sst])).toEqual(named);
    expect(boundsThatFit(preset, [pressure])).toEqual(preset);
  });

  test('leave identifiers free, unless a bound names them', () => {
    const variable = { components: 1, extent: 9, magnitude: 9, constant: false };
    const ids = { ...variable, name: 'ids', kind: 'identifier' } as const;
    const pressure = { ...variable, name: 'pressure' };
    const first = defaultBounds([pressure, ids]);
    expect(asBounds(first)).toEqual({ pressure: { relative: 0.03 }, ids: 'free' });
    expect(areFirst(first, [pressure, ids])).toBe(true);
    expect(areFirst({ ...first, ids: { ...first.ids, free: false } }, [pressure, ids])).toBe(false);

    const all = { '*': { relative: 0.05 } };
    expect(asBounds(settingsFrom(all, [pressure, ids]))).toEqual({ pressure: { relative: 0.05 }, ids: 'free' });
    expect(asBounds(settingsFrom({ ...all, ids: { absolute: 2 } }, [pressure, ids])).ids).toEqual({ absolute: 2 });
  });

  test('survive variables with names that objects have a meaning for', () => {
    const settings = defaultBounds(['position', '__proto__', 'constructor'].map((name) => ({ name })));
    expect(Object.keys(settings)).toEqual(['position', '__proto__', 'constructor']);
    expect(Object.keys(asBounds(moveAll(settings, 0.1)))).toEqual(['position', '__proto__', 'constructor']);
  });

  test('a free variable has no bound, and has its old one again when it is bounded', () => {
    const settings = { ...defaultBounds([{ name: 'position' }, { name: 't' }]), t: { fraction: 0.05, free: true } };
    expect(asBounds(settings).t).toBe('free');
    expect(asBounds({ ...settings, t: { ...settings.t, free: false } }).t).toEqual({ relative: 0.05 });
  });

  test('moving all keeps their proportions and brings the largest to the given one', () => {
    const moved = moveAll(defaultBounds([{ name: 'position' }, { name: 't' }]), 0.06);
    expect(asBounds(moved)).toEqual({ position: { relative: 0.02 }, t: { relative: 0.06 } });
    expect(asBounds(moveAll(moved, 0.03))).toEqual(asBounds(defaultBounds([{ name: 'position' }, { name: 't' }])));
  });

  test('the largest one is looked for among those that hold', () => {
    const settings = { position: { fraction: 0.01, free: false }, t: { fraction: 0.2, free: true } };
    expect(largestFraction(settings)).toBe(0.01);
    expect(largestFraction({ t: settings.t })).toBe(0.2);
  });
});

describe('a typed percentage', () => {
  test.each([
    ['3', 0.03],
    [' 0.5 ', 0.005],
    ['25 %', 0.25],
    ['1e-3', 0.00001],
    ['1.0049', 0.010049],
    ['0.0123456', 0.000123456],
    ['0,5', 0.005],
    ['1,5 %', 0.015],
    ['0,001', 0.00001],
  ])('%j is taken, digit by digit', (text, fraction) => {
    expect(parsePercent(text)).toMatchObject({ value: fraction });
  });

  test.each([
    ['', 'needs a number'],
    ['three', '“three” is not a number'],
    ['1,000', '“1,000” can be read in two ways: write 1000 or 1.000'],
    ['1,2,3', '“1,2,3” is not a number'],
    ['1.000,5', '“1.000,5” is not a number'],
    ['-3', 'cannot be negative'],
    ['0', 'cannot be zero'],
    ['5e-324', 'cannot be zero'],
    ['Infinity', 'must be finite'],
  ])('%j is refused with a reason', (text, reason) => {
    expect(parsePercent(text)).toEqual({ fault: expect.stringContaining(reason) });
  });
});

describe('a bound in a field', () => {
  test.each([
    [0.000968, '0.000968'],
    [0.0033333333, '0.003333'],
    [1.2345678e-10, '1.235e-10'],
    [123456789.123, '123500000'],
    [12345678912345, '1.235e13'],
    [0.00001234567, '1.235e-5'],
    [3, '3'],
  ])('%d reads %s, which has room', (value, text) => {
    expect(fieldText(value)).toBe(text);
    expect(text.length).toBeLessThanOrEqual(9);
    expect(Math.abs(Number(text) / value - 1)).toBeLessThan(1e-3);
  });
});
