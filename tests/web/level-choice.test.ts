import { describe, expect, test } from 'vitest';
import { chooseLevel, hysteresis } from '../../web/viewer/level-choice.ts';

const errors = [0, 1, 2, 4];

describe('the level by size on screen', () => {
  test('is the coarsest whose error spans no more pixels than allowed', () => {
    expect(chooseLevel(errors, 0.1, 1, 0)).toBe(3);
    expect(chooseLevel(errors, 0.3, 1, 0)).toBe(2);
    expect(chooseLevel(errors, 0.6, 1, 0)).toBe(1);
    expect(chooseLevel(errors, 5, 1, 3)).toBe(0);
    expect(chooseLevel(errors, 5, 20, 0)).toBe(2);
  });

  test('is the original where nothing else will do, from however near one looks', () => {
    expect(chooseLevel(errors, Infinity, 1, 3)).toBe(0);
    expect(chooseLevel([0], 1, 1, 0)).toBe(0);
  });

  test('changes at another size on the way in than on the way out', () => {
    const limit = 1 / errors[2]; // where the error of level 2 is a pixel
    expect(chooseLevel(errors, limit, 1, 2)).toBe(2);
    expect(chooseLevel(errors, limit, 1, 1)).toBe(1);
    expect(chooseLevel(errors, limit / hysteresis, 1, 1)).toBe(2);
    expect(chooseLevel(errors, limit * 1.001, 1, 2)).toBe(1);
  });

  test('rests where it has arrived', () => {
    for (let size = 0.01; size < 3; size *= 1.03) {
      for (const current of errors.keys()) {
        const chosen = chooseLevel(errors, size, 1, current);
        expect(chooseLevel(errors, size, 1, chosen)).toBe(chosen);
      }
    }
  });
});
