import { expect, test } from 'vitest';
import { portOr } from './port.ts';

test('PORT is taken where it is given', () => {
  expect(portOr(4317, { PORT: '8080' })).toBe(8080);
  expect(portOr(4317, { PORT: '65535' })).toBe(65_535);
  expect(portOr(4317, {})).toBe(4317);
});

test.for(['abc', '', ' ', '0', '65536', '80.5', '-1', '1e3', '0x50', '4317 '])('PORT=%j is refused by name', (PORT) => {
  expect(() => portOr(4317, { PORT })).toThrow(`PORT: "${PORT}" is no port: a whole number from 1 to 65535.`);
});
