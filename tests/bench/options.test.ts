import { expect, test } from 'vitest';
import { benchOptions, pathOptions } from './options.ts';

test('--quick takes the two small surfaces with seven variables, once', () => {
  const { sizes, variables, rounds, out } = benchOptions(['--quick']);
  expect(sizes.map(({ name }) => name)).toEqual(['7k', '100k']);
  expect(variables.map(({ length }) => length)).toEqual([7]);
  expect([rounds, out]).toEqual([1, undefined]);
  expect(pathOptions(['--quick']).sizes).toEqual(sizes);
});

test('without options everything is measured, as often as the sizes ask for; on the page all but the largest', () => {
  const { sizes, variables, rounds } = benchOptions([]);
  expect(sizes.map(({ name }) => name)).toEqual(['7k', '100k', '1m', '4m']);
  expect(variables.map(({ length }) => length)).toEqual([0, 2, 7]);
  expect(rounds).toBeUndefined();
  expect(pathOptions([]).sizes.map(({ name }) => name)).toEqual(['7k', '100k', '1m']);
});

test('what is chosen counts more than --quick', () => {
  const { sizes, variables, rounds } = benchOptions([
    '--quick',
    '--sizes',
    '1m',
    '--variables',
    '2,0',
    '--rounds',
    '3',
  ]);
  expect(sizes.map(({ name }) => name)).toEqual(['1m']);
  expect(variables.map(({ length }) => length)).toEqual([2, 0]);
  expect(rounds).toBe(3);
});

test.for([
  [['--sizes', '5m'], '--sizes: no "5m". There are: 7k, 100k, 1m, 4m.'],
  [['--sizes', '7k,constructor'], '--sizes: no "constructor". There are: 7k, 100k, 1m, 4m.'],
  [['--sizes', ''], '--sizes: no "". There are: 7k, 100k, 1m, 4m.'],
  [['--out', 'nowhere/speed.md'], 'nowhere'],
  [['--fast'], '--fast'],
] as [string[], string][])('both commands refuse %j, and say why', ([given, says]) => {
  expect(() => benchOptions(given)).toThrow(says);
  expect(() => pathOptions(given)).toThrow(says);
});

test.for([
  [['--variables', '3'], '--variables: no "3". There are: 0, 2, 7.'],
  [['--rounds', 'many'], '--rounds: "many" is no whole number above zero.'],
  [['--rounds', '0'], '--rounds: "0" is no whole number above zero.'],
  [['--rounds', '1.5'], '--rounds: "1.5" is no whole number above zero.'],
] as [string[], string][])('%j is refused, and why is said', ([given, says]) => {
  expect(() => benchOptions(given)).toThrow(says);
});
