import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { LevelMotion } from '../../web/element/level-motion.ts';
import type { LevelSession } from '../../web/session/reducing/level-session.ts';

/** The most that one frame may move, in levels: what is farther is seen as a jump. */
const smooth = 0.2;

let frames: FrameRequestCallback[] = [];
let now = 0;
let position = 0;
let pixels: number | null = 1;
let drawn = true;
let reducedMotion = false;

beforeEach(() => {
  [frames, now, position, pixels, drawn, reducedMotion] = [[], 1000, 0, 1, true, false];
  vi.stubGlobal('requestAnimationFrame', (callback: FrameRequestCallback) => frames.push(callback));
  vi.stubGlobal('cancelAnimationFrame', () => frames.splice(0));
  vi.stubGlobal('matchMedia', () => ({ matches: reducedMotion }));
  vi.spyOn(performance, 'now').mockImplementation(() => now);
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

function motion(): LevelMotion {
  const levels = {
    get state() {
      return { position, pixels };
    },
    arriveAt(where: number) {
      position = where;
    },
  };
  return new LevelMotion(levels as unknown as LevelSession, () => drawn);
}

/** Lets frames pass, of so many milliseconds each, until nothing moves or there were `most` of them; where each arrived. */
function pass(milliseconds: number, most = 1000): number[] {
  const seen: number[] = [];
  while (frames.length > 0 && seen.length < most) {
    now += milliseconds;
    for (const frame of frames.splice(0)) frame(now);
    seen.push(position);
  }
  return seen;
}

function largestStep(positions: number[]): number {
  return Math.max(...positions.map((each, i) => Math.abs(each - (positions[i - 1] ?? 0))));
}

test.each([5, 16, 300, 5000])('moves smoothly to a level and rests there, with frames of %i ms', (milliseconds) => {
  motion().towards(3);
  const seen = pass(milliseconds);
  expect(seen.at(-1)).toBe(3);
  expect(largestStep(seen)).toBeLessThan(smooth);
  expect(seen).toEqual(seen.toSorted((a, b) => a - b));
});

test('waits until what is to be seen is drawn', () => {
  motion().towards(2);
  const [before] = pass(16, 1);
  drawn = false;
  expect(new Set(pass(16, 50))).toEqual(new Set([before]));
  drawn = true;
  const after = pass(16);
  expect(after[0] - before).toBeLessThan(smooth);
  expect(after.at(-1)).toBe(2);
});

test('turns back where it is when another level is wanted', () => {
  const moving = motion();
  moving.towards(3);
  const there = pass(16, 40);
  moving.towards(0);
  const back = pass(16);
  expect(Math.abs(back[0] - (there.at(-1) ?? 0))).toBeLessThan(smooth);
  expect(back.at(-1)).toBe(0);
});

test('stays where the user takes the slider', () => {
  motion().towards(3);
  pass(16, 10);
  [position, pixels] = [1.5, null];
  pass(16);
  expect(position).toBe(1.5);
});

test('a frame that began before it was asked for moves nothing back', () => {
  motion().towards(1);
  expect(pass(-8, 1)).toEqual([0]);
});

test('is there at once for those who want less motion', () => {
  reducedMotion = true;
  motion().towards(3);
  expect(position).toBe(3);
  expect(frames).toEqual([]);
});
