import { describe, expect, test } from 'vitest';
import type { Mesh, Reduction, TriangleErrors, VariableReport, VertexErrors } from '../../wasm/types.ts';
import { missingPlace } from '../../web/colour/missing-place.ts';
import { firstView, type Quantity, type ViewSettings } from '../../web/element/attributes/view-settings.ts';
import { originalErrors, reducedErrors } from '../../web/element/stage/error-colouring.ts';

const labels = { units: { t: 'K' }, componentNames: {} };
const mesh: Mesh = { position: new Float32Array(9), triangles: Uint32Array.of(0, 1, 2), variables: [] };

const plain = (text = '') => text.replaceAll('\u00a0', ' ');
const view = (variable: string, quantity: Quantity): ViewSettings => ({ ...firstView, variable, quantity });

interface Reached {
  bound?: number;
  errors?: number[];
  signed?: number[];
  interval?: [number, number];
}

/** A reduction of a triangle to itself, whose position and variable `t` both have the given errors. */
function reduction(
  { bound = 4, errors = [0, 1, 2], signed = [0, -1, 2], interval = [-1, 2] }: Reached,
  tracked = true,
): Reduction {
  const largest = Math.max(...interval.map(Math.abs));
  const variables = ['position', 't'].map((name) => ({ name, bound, error: largest }) as VariableReport);
  const ofTriangles: TriangleErrors = {
    largest: Float32Array.of(largest),
    lowest: Float32Array.of(interval[0]),
    highest: Float32Array.of(interval[1]),
    ratio: Float32Array.of(largest / bound),
  };
  const ofVertices: VertexErrors = { error: Float32Array.from(errors), signedError: Float32Array.from(signed) };
  return {
    mesh,
    report: { variables },
    triangleErrors: [ofTriangles, ofTriangles],
    vertexErrors: tracked ? [ofVertices, ofVertices] : undefined,
  } as Reduction;
}

const propagated = (reached: Reached) => reduction(reached, false);

describe('error / bound', () => {
  const settings = view('t', 'error');

  test('of the original is that of every vertex', () => {
    const colouring = originalErrors(mesh, reduction({}), labels, settings);
    expect([...(colouring?.places ?? [])]).toEqual([0, 0.25, 0.5]);
    expect(colouring?.meaning).toMatchObject({
      title: 'error / bound: t',
      detail: 'true error at each vertex',
      unit: undefined,
      map: 'share',
      range: { lowest: 0, highest: 1 },
    });
  });

  test('of the reduced surface is the largest in each triangle, flat', () => {
    const { places, meaning } = reducedErrors(reduction({}), labels, settings);
    expect([...places]).toEqual([0.5, 0.5, 0.5]);
    expect(meaning).toMatchObject({ title: 'error / bound: t', detail: 'largest error in each triangle' });
  });

  test('with propagated errors is not known of the original, and a limit on the reduced surface', () => {
    expect(originalErrors(mesh, propagated({}), labels, settings)).toBeNull();
    expect(reducedErrors(propagated({}), labels, settings).meaning.detail).toBe('limit of the error in each triangle');
  });

  test('counts against the bound as it is multiplied at each place, and says so', () => {
    const multiplied = { ...reduction({ errors: [0, 1, 8] }), multiplier: Float64Array.of(1, 0.5, 2) };
    const original = originalErrors(mesh, multiplied, labels, settings);
    expect([...(original?.places ?? [])]).toEqual([0, 0.5, 1]);
    expect(original?.meaning.detail).toContain('of the bound as it is multiplied there');
    multiplied.triangleErrors[1].ratio[0] = 0.75;
    const reduced = reducedErrors(multiplied, labels, settings);
    expect([...reduced.places]).toEqual([0.75, 0.75, 0.75]);
    expect(reduced.meaning.detail).toContain('of the bound as it is multiplied there');
  });

  test('of a free variable is nothing', () => {
    const { places, meaning } = reducedErrors(reduction({ bound: Infinity }), labels, settings);
    expect(Math.max(...places)).toBeLessThan(0);
    expect(meaning).toMatchObject({ title: 'error / bound: t (free: no bound)', free: true, bounded: false });
  });
});

describe('signed errors', () => {
  const settings = view('t', 'signed-error');

  test('range from −bound to +bound on both sides, in the unit of the variable', () => {
    const original = originalErrors(mesh, reduction({}), labels, settings);
    const reduced = reducedErrors(reduction({}), labels, settings);
    expect([...(original?.places ?? [])]).toEqual([0.5, 0.375, 0.75]);
    expect([...reduced.places]).toEqual([0.75, 0.75, 0.75]);
    for (const meaning of [original?.meaning, reduced.meaning]) {
      expect(meaning).toMatchObject({
        title: 'signed error: t',
        unit: 'K',
        map: 'RdBu',
        range: { lowest: -4, highest: 4 },
        ends: ['−bound', '+bound'],
      });
      expect(plain(meaning?.detail)).toContain('original − reduced');
    }
  });

  test('of a triangle are the larger in size', () => {
    const { places } = reducedErrors(reduction({ interval: [-4, 2] }), labels, settings);
    expect([...places]).toEqual([0, 0, 0]);
  });

  test('of a free variable reach as far as the largest', () => {
    const { meaning } = reducedErrors(reduction({ bound: Infinity }), labels, settings);
    expect(meaning).toMatchObject({ range: { lowest: -2, highest: 2 }, ends: ['−largest', '+largest'] });
  });

  test('reach as far as the largest where the bound is not the same everywhere', () => {
    const multiplied = { ...reduction({}), multiplier: Float64Array.of(1, 0.5, 2) };
    const { meaning } = reducedErrors(multiplied, labels, settings);
    expect(meaning).toMatchObject({
      range: { lowest: -2, highest: 2 },
      ends: ['−largest', '+largest'],
      bounded: false,
    });
  });

  test('of position say which side is positive', () => {
    const { meaning } = reducedErrors(reduction({}), labels, view('position', 'signed-error'));
    expect(meaning.detail).toContain('+ where the reduced surface is outside');
  });

  test('of position, propagated, are no broken guarantee where their sum exceeds the bound', () => {
    const { places, meaning } = reducedErrors(
      propagated({ interval: [-7, 1] }),
      labels,
      view('position', 'signed-error'),
    );
    expect([...places]).toEqual([0, 0, 0]);
    expect(meaning).toMatchObject({ range: { lowest: -7, highest: 7 }, bounded: false });
  });
});

describe('where an error is not known, there is nothing to show', () => {
  const unknown = reduction({ bound: Infinity, errors: [0, Number.NaN, 1], signed: [0, Number.NaN, 1] });
  unknown.report.variables[1].error = Number.NaN;
  const [first] = unknown.triangleErrors;
  const two = { ...first, lowest: Float32Array.of(Number.NaN, -3), highest: Float32Array.of(Number.NaN, 2) };
  const free = { ...unknown, triangleErrors: [first, { ...two, ratio: Float32Array.of(0, 0) }] };

  test('on the original in the whole triangle, with a legend as far as errors are known', () => {
    const colouring = originalErrors(mesh, free, labels, view('t', 'signed-error'));
    expect([...(colouring?.places ?? [])]).toEqual(Array(3).fill(Math.fround(missingPlace)));
    expect(colouring?.meaning.range).toEqual({ lowest: -3, highest: 3 });
  });

  test('on the reduced surface in that triangle alone', () => {
    const { places } = reducedErrors(free, labels, view('t', 'signed-error'));
    expect([...places]).toEqual([...Array(3).fill(Math.fround(missingPlace)), 0, 0, 0]);
  });

  test('and nothing at all of a share, since the variable is free', () => {
    const { places, meaning } = reducedErrors(free, labels, view('t', 'error'));
    expect([...places]).toEqual(Array(6).fill(Math.fround(missingPlace)));
    expect(meaning.free).toBe(true);
  });
});
