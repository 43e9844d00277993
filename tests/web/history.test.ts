import { expect, test } from 'vitest';
import { changed, historyOf, redone, settled, undone } from '../../web/session/history.ts';

const three = changed(changed(historyOf('a'), 'b', null), 'c', null);

test('steps are undone one by one, and redone', () => {
  expect(undone(three).present).toBe('b');
  expect(undone(undone(three)).present).toBe('a');
  expect(undone(undone(undone(three))).present).toBe('a');
  expect(redone(undone(undone(three))).present).toBe('b');
  expect(redone(redone(undone(undone(three))))).toEqual(three);
  expect(redone(three)).toEqual(three);
});

test('a change after an undo leaves nothing to redo', () => {
  const other = changed(undone(three), 'd', null);
  expect(redone(other).present).toBe('d');
  expect(undone(other).present).toBe('b');
});

test('a slider that is dragged gives one step; another slider, or the same one again, another', () => {
  let history = historyOf(0);
  for (const value of [1, 2, 3]) history = changed(history, value, 'heat');
  history = changed(history, 4, 'wind');
  history = changed(settled(history), 5, 'wind');
  expect(history.past).toEqual([0, 3, 4]);
});
