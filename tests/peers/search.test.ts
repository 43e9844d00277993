import { expect, test } from 'vitest';

import type { Setting } from './peer.ts';
import { Search } from './search.ts';

const original = { triangles: 10_000, variables: 2 };

/** A peer whose results pass with the given number of triangles or more; `fault` says which variable is beyond if not. */
function search(needed: (setting: Setting) => number, fault: (setting: Setting) => number, allowance = 200) {
  let run = { setting: { weights: [1, 1], options: [] } as Setting, triangles: 0 };
  const simplify = async (setting: Setting, target: number) => {
    run = { setting, triangles: target };
    return target;
  };
  const beyond = async () => (run.triangles >= needed(run.setting) ? undefined : fault(run.setting));
  return new Search(simplify, beyond, 'nowhere', original, allowance);
}

test('bisects the number of triangles', async () => {
  const found = await search(
    () => 777,
    () => 1,
  ).fewest([], [[]]);
  expect(found.triangles).toBeGreaterThanOrEqual(777);
  expect(found.triangles).toBeLessThan(777 * 1.04);
});

test('finds the options that help and drops those that hurt', async () => {
  const needed = ({ options }: Setting) =>
    800 - 200 * Number(options.includes('good')) + 300 * Number(options.includes('bad'));
  const found = await search(needed, () => 1).fewest(['bad', 'good', 'idle'], [['bad']]);
  expect(found.setting.options).toContain('good');
  expect(found.setting.options).not.toContain('bad');
  expect(found.triangles).toBeLessThan(600 * 1.04);
});

test('shifts weight to the variable at fault', async () => {
  // Best where the second variable weighs eight times as much as the first.
  const imbalance = ({ weights }: Setting) => Math.log(weights[1] / weights[0] / 8);
  const found = await search(
    (setting) => 500 + 300 * Math.abs(imbalance(setting)),
    (setting) => (imbalance(setting) < 0 ? 2 : 1),
  ).fewest([], [[]]);
  expect(Math.abs(imbalance(found.setting))).toBeLessThan(0.2);
});

test('keeps to its allowance, and goes on from an earlier search', async () => {
  const [needed, fault] = [() => 777, () => 1];
  const short = await search(needed, fault, 3).fewest([], [[]]);
  expect(short.runs).toBe(3);
  expect(short.triangles).toBeGreaterThan(1000);
  const longer = await search(needed, fault, 8).fewest([], [[]], [short]);
  expect(longer.triangles).toBeLessThan(short.triangles);
});

test('leaves the original where nothing passes', async () => {
  const found = await search(
    () => Number.POSITIVE_INFINITY,
    () => 0,
    20,
  ).fewest(['option'], [[]]);
  expect(found.triangles).toBe(original.triangles);
  expect(found.target).toBe(original.triangles);
});
