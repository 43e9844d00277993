import { expect, test } from 'vitest';
import { ballSegments, boxSegments } from '../../web/viewer/outline.ts';

function segmentsOf(numbers: Float64Array): { from: number[]; to: number[] }[] {
  return Array.from({ length: numbers.length / 6 }, (_, i) => ({
    from: [...numbers.subarray(6 * i, 6 * i + 3)],
    to: [...numbers.subarray(6 * i + 3, 6 * i + 6)],
  }));
}

test('a box is drawn by its twelve edges, each along one axis', () => {
  const segments = segmentsOf(boxSegments({ lowest: [0, 1, 2], highest: [10, 21, 32] }));
  expect(new Set(segments.map(({ from, to }) => `${from} ${to}`)).size).toBe(12);
  for (const { from, to } of segments) {
    expect(from.filter((place, axis) => place !== to[axis])).toHaveLength(1);
    for (const end of [from, to]) {
      expect(end.filter((place, axis) => place !== axis && place !== axis + 10 * (axis + 1))).toEqual([]);
    }
  }
});

test('a ball is drawn by three closed circles of its radius, one across each axis', () => {
  const segments = segmentsOf(ballSegments({ point: [1, 2, 3], radius: 0.5 }));
  for (const { from } of segments) expect(Math.hypot(from[0] - 1, from[1] - 2, from[2] - 3)).toBeCloseTo(0.5, 12);
  const across = [0, 1, 2].map((circle) => {
    const steps = segments.slice((circle * segments.length) / 3, ((circle + 1) * segments.length) / 3);
    for (const [i, { to }] of steps.entries()) {
      const { from } = steps[(i + 1) % steps.length];
      expect(Math.hypot(...to.map((place, axis) => place - from[axis]))).toBeCloseTo(0, 12);
    }
    return [0, 1, 2].findIndex((axis) => steps.every(({ from }) => from[axis] === axis + 1));
  });
  expect(across.sort()).toEqual([0, 1, 2]);
});
