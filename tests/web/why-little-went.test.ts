import { describe, expect, test } from 'vitest';
import type { Report } from '../../wasm/types.ts';
import { guaranteeSentence } from '../../web/element/result/guarantee-words.ts';
import { type Reason, whyLittleWent } from '../../web/session/report/why-little-went.ts';
import { littleWentSentence } from '../../web/words/little-went.ts';
import { noDefects } from './no-defects.ts';

function report(after: number, byBound: number, refused: Partial<Report['refused']>): Report {
  return {
    triangles: { before: 180, after: 2 * after },
    vertices: { before: 120, after },
    variables: [
      {
        name: 'position',
        components: 3,
        extent: 1,
        magnitude: 1,
        constant: false,
        bound: 0.01,
        error: 0.005,
        ratio: 0.5,
        refused: byBound,
      },
    ],
    candidates: 100,
    refused: { nonManifold: 0, locked: 0, ring: 0, topology: 0, fold: 0, piercing: 0, ...refused },
    flippedNormals: { before: 0, after: 0 },
    defects: { ...noDefects, unusedVertices: 20 },
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

describe('why little went', () => {
  test.each<Reason>(['nonManifold', 'locked', 'ring', 'topology', 'fold', 'piercing'])(
    'names what kept most: %s',
    (reason) => {
      const held = report(80, 16, { locked: 1, fold: 1, [reason]: 62 });
      const why = whyLittleWent(held);
      expect(why?.reason).toBe(reason);
      expect(guaranteeSentence(held, true)).toContain('Why so little went: ');
    },
  );

  test('says its share of the vertices that are left', () => {
    expect(whyLittleWent(report(100, 22, { nonManifold: 78 }))).toEqual({ reason: 'nonManifold', share: 0.78 });
    expect(littleWentSentence({ reason: 'nonManifold', share: 0.78 })).toMatch(
      /^Why so little went: 78\u00a0% of the vertices left stand where curves meet or end: where three or more triangles share/,
    );
  });

  test('is not said where the bounds keep as many', () => {
    expect(whyLittleWent(report(80, 40, { fold: 40 }))).toBeUndefined();
    expect(whyLittleWent(report(80, 80, {}))).toBeUndefined();
    expect(guaranteeSentence(report(80, 60, { fold: 20 }), true)).not.toContain('little');
  });

  test('is not said where half of the candidates went, whatever points no triangle uses', () => {
    expect(whyLittleWent(report(50, 0, { fold: 50 }))).toBeUndefined();
    expect(whyLittleWent(report(51, 0, { fold: 51 }))?.share).toBe(1);
  });

  test('is not known of what was cancelled', () => {
    expect(whyLittleWent({ ...report(100, 0, {}), termination: 'cancelled' })).toBeUndefined();
  });

  test('never claims all where it is not all', () => {
    expect(littleWentSentence({ reason: 'fold', share: 0.999 })).toContain(' 99\u00a0%');
    expect(littleWentSentence({ reason: 'fold', share: 1 })).toContain(' 100\u00a0%');
  });
});
