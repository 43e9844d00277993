import { expect, test } from 'vitest';
import { readOptionsFrom } from '../../web/element/attributes/read-options.ts';

test.each([
  [null, {}],
  ['', {}],
  ['1e-6', { weld: 1e-6 }],
  [' 0.0001% ', { weld: 1e-6 }],
  ['.01', { weld: 0.01 }],
])('weld=%j reads a surface with %o', (weld, options) => expect(readOptionsFrom(weld)).toEqual(options));

test.each(['0', '-1e-6', '1', 'yes', '1e-6 m', '..1'])('weld=%j is refused', (weld) => {
  expect(() => readOptionsFrom(weld)).toThrow(
    expect.objectContaining({ code: 'bad_option', message: expect.stringContaining(`weld cannot be “${weld}”`) }),
  );
});
