import { describe, expect, test } from 'vitest';
import type { Report, VariableReport } from '../../wasm/types.ts';
import { guaranteeSentence, heldBackShares, roughShareText } from '../../web/element/result/guarantee-words.ts';
import { noDefects } from './no-defects.ts';

function variable(name: string, fraction: number, ratio: number, refused = 0): VariableReport {
  const bound = 200 * fraction;
  return {
    name,
    components: 1,
    extent: 200,
    magnitude: 500,
    constant: false,
    bound,
    error: bound * ratio,
    ratio,
    refused,
  };
}

function free(name: string): VariableReport {
  return { ...variable(name, 0, 0), bound: Infinity, error: 90 };
}

function report(variables: VariableReport[], refused: Partial<Report['refused']> = {}): Report {
  return {
    triangles: { before: 99980, after: 806 },
    vertices: { before: 49992, after: 405 },
    variables,
    candidates: 49992,
    refused: { nonManifold: 0, locked: 0, ring: 0, topology: 0, fold: 0, piercing: 0, ...refused },
    flippedNormals: { before: 0, after: 0 },
    defects: noDefects,
    dropped: { components: 0, triangles: 0 },
    unusedLockedBoxes: [],
    regions: [],
    nonManifoldVertices: 0,
    cells: 0,
    foldedCells: 0,
    termination: 'finished',
    errorsAreUpperBounds: false,
    seconds: 0.3,
  };
}

const plain = (text: string) => text.replace(/[\u202f\u00a0]/g, ' ');
const sentence = (variables: VariableReport[]) => plain(guaranteeSentence(report(variables), true));

describe('the guarantee', () => {
  test('states counts, every bound and the one that is used most', () => {
    expect(
      sentence([variable('position', 0.01, 0.9), variable('pressure', 0.03, 0.99), variable('density', 0.02, 0.3)]),
    ).toBe(
      '806 of 99 980 triangles. Every point within 1 % in space, 3 % in pressure, 2 % in density: proved; ' +
        'most used: pressure, 2.97 % (99 % of its bound).',
    );
  });

  test('counts a single triangle as one', () => {
    const single = { ...report([variable('position', 0.01, 0)]), triangles: { before: 1, after: 1 } };
    expect(plain(guaranteeSentence(single, true))).toContain('1 of 1 triangle. Every');
  });

  test('puts variables with one bound together', () => {
    expect(sentence([variable('position', 0.03, 0.1), variable('a', 0.03, 0), variable('b', 0.03, 0)])).toContain(
      'within 3 % in space, a and b: proved',
    );
  });

  test('claims nothing of free variables, and names them', () => {
    const text = sentence([free('position'), variable('a', 0.03, 0.5), free('b')]);
    expect(text).toContain(
      'within 3 % in a: proved; most used: a, 1.5 % (50 % of its bound). Free, so nothing guaranteed: space and b.',
    );
  });

  test('says of errors that were not measured that they are limits', () => {
    const propagated = plain(guaranteeSentence(report([variable('a', 0.03, 0.5)]), false));
    expect(propagated).toContain('within 3 % in a: proved; most used: a, at most 1.5 % (50 % of its bound).');
  });

  test('says of bounds that are multiplied that they are, and where the share is', () => {
    const multiplied = plain(guaranteeSentence(report([variable('a', 0.03, 0.5)]), true, true));
    expect(multiplied).toContain(
      'within 3 % in a, times the multiplier there: proved; most used: a, 50 % of its bound there; its largest error is 1.5 %.',
    );
  });

  test('guarantees nothing of parts that were left out, and counts them', () => {
    const all = report([variable('a', 0.03, 0.5)]);
    const dropped = (parts: number) =>
      plain(guaranteeSentence({ ...all, dropped: { components: parts, triangles: 9 } }, true));
    expect(dropped(0)).not.toContain('left out');
    expect(dropped(1)).toMatch(/ 1 small part left out: nothing guaranteed of it\.$/);
    expect(dropped(3)).toMatch(/ 3 small parts left out: nothing guaranteed of them\.$/);
  });

  test('proves nothing where everything is free', () => {
    expect(sentence([free('position'), free('a')])).not.toContain('proved');
  });

  test('takes the percentage of a constant variable from its magnitude', () => {
    const constant = { ...variable('density', 0, 0.5), constant: true, extent: 0, bound: 15, error: 7.5 };
    expect(sentence([constant])).toContain(
      'within 3 % in density: proved; most used: density, 1.5 % (50 % of its bound).',
    );
  });

  test('gives a bound in its unit where there is nothing to take a percentage of', () => {
    const nothing = { ...variable('density', 0, 0), extent: 0, magnitude: 0, bound: 0.03, error: 0 };
    expect(sentence([{ ...nothing, constant: true }])).toContain('within 0.03 in density: proved; no error at all.');
    expect(sentence([{ ...nothing, name: 'position' }])).toContain('within 0.03 in space');
  });

  test('says that all of a bound is used only where it is', () =>
    expect(sentence([variable('a', 0.03, 0.99999)])).toContain('most used: a, 3 % (99.9 % of its bound)'));

  test('says so where nothing was changed', () => {
    expect(sentence([variable('position', 0.01, 0)])).toContain('proved; no error at all.');
  });

  test('takes for no error what rounding leaves of none, and nothing larger', () => {
    expect(sentence([variable('position', 0.01, 1.25e-11)])).toContain('proved; no error beyond rounding.');
    expect(sentence([variable('position', 0.01, 2e-6)])).toContain('most used: space');
  });
});

describe('what holds a result back', () => {
  test('is listed with its share, the largest first', () => {
    const held = report([variable('position', 0.01, 1, 30), variable('t', 0.03, 1, 60)], { fold: 10 });
    expect(heldBackShares(held)).toEqual([
      { reason: 't', share: 0.6 },
      { reason: 'space', share: 0.3 },
      { reason: 'folds', share: 0.1 },
    ]);
    expect([0.6, 0.004, 1].map((share) => plain(roughShareText(share)))).toEqual(['60 %', '< 1 %', '100 %']);
  });

  test('is not mentioned where nothing does', () =>
    expect(heldBackShares(report([variable('t', 0.03, 0)]))).toEqual([]));
});
