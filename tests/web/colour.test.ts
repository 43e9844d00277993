import { describe, expect, test } from 'vitest';
import {
  aboveBoundColour,
  type Colormap,
  colourAt,
  colourTable,
  cssGradient,
  tableSize,
} from '../../web/colour/colormaps.ts';
import { centredOnZero, dataRange, placeIn, roundTicks } from '../../web/colour/colour-range.ts';
import { flatPlaces, largerInSize, placeByShare, placeBySign, vertexPlaces } from '../../web/colour/error-places.ts';
import { componentsOf, cornerPlaces, fieldOf, fieldRange } from '../../web/colour/field.ts';

const maps: Colormap[] = ['viridis', 'cividis', 'diverging', 'share'];

describe('colour maps', () => {
  test('are the ones that their names say', () => {
    // The ends and the middle of viridis as published by Matplotlib.
    expect(colourAt('viridis', 0)).toEqual([68, 1, 84]);
    expect(colourAt('viridis', 0.5)).toEqual([33, 145, 140]);
    expect(colourAt('viridis', 1)).toEqual([253, 231, 37]);
  });

  test.each(maps)('%s as bytes is the map from end to end', (map) => {
    const table = colourTable(map);
    expect(table).toHaveLength(4 * tableSize);
    for (const entry of [0, 100, tableSize - 1]) {
      const colour = colourAt(map, entry / (tableSize - 1)).map(Math.round);
      expect([...table.subarray(4 * entry, 4 * entry + 4)]).toEqual([...colour, 255]);
    }
  });

  test.each(maps)('%s stays far from the colour of a broken bound', (map) => {
    const table = colourTable(map);
    for (let entry = 0; entry < table.length; entry += 4) {
      const distance = Math.hypot(...aboveBoundColour.map((part, index) => part - table[entry + index]));
      expect(distance).toBeGreaterThan(120);
    }
  });

  test.each(['viridis', 'cividis'] as const)('%s grows lighter all the way', (map) => {
    const lightness = (place: number) => {
      const [red, green, blue] = colourAt(map, place);
      return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    };
    for (let step = 0; step < 20; step++) expect(lightness((step + 1) / 20)).toBeGreaterThan(lightness(step / 20));
  });

  test('a gradient runs from one end of the map to the other', () => {
    expect(cssGradient('viridis', 'to right')).toMatch(
      /^linear-gradient\(to right, rgb\(68, 1, 84\),.*rgb\(253, 231, 37\)\)$/,
    );
  });
});

describe('the colour range', () => {
  test('spans the finite values', () => {
    expect(dataRange([3, NaN, -1, Infinity, 2])).toEqual({ lowest: -1, highest: 3 });
    expect(dataRange([NaN])).toEqual({ lowest: 0, highest: 0 });
  });

  test('is symmetric where zero is the middle', () => {
    expect(centredOnZero({ lowest: -1, highest: 3 })).toEqual({ lowest: -3, highest: 3 });
    expect(centredOnZero({ lowest: 2, highest: 3 })).toEqual({ lowest: -3, highest: 3 });
  });

  test('has round ticks that lie inside it', () => {
    expect(roundTicks({ lowest: 0.02618, highest: 0.1413 }, 4)).toEqual([0.04, 0.06, 0.08, 0.1, 0.12, 0.14]);
    expect(roundTicks({ lowest: 5, highest: 5 }, 4)).toEqual([5]);
    expect(placeIn({ lowest: 5, highest: 5 }, 5)).toBe(0.5);
  });
});

describe('a field', () => {
  const velocity = { name: 'velocity', components: 3, values: new Float32Array([3, 4, 0, 0, 0, -2]) };

  test('is a component or the magnitude of a variable', () => {
    expect([...fieldOf(velocity, 'magnitude')]).toEqual([5, 2]);
    expect([...fieldOf(velocity, 2)]).toEqual([0, -2]);
  });

  test('offers every component under the name that the file gives it', () => {
    expect(componentsOf(1)).toHaveLength(1);
    expect(componentsOf(3).map(({ label }) => label)).toEqual(['magnitude', 'x', 'y', 'z']);
    expect(componentsOf(2, ['re', 'im']).map(({ label }) => label)).toEqual(['magnitude', 're', 'im']);
    expect(componentsOf(4).map(({ label }) => label)).toEqual(['magnitude', '1', '2', '3', '4']);
  });

  test('ranges over the vertices that triangles use', () => {
    expect(fieldRange(new Float32Array([1, 2, 3, 99]), new Uint32Array([0, 1, 2]))).toEqual({ lowest: 1, highest: 3 });
  });

  test('shows a small variation on a large number', () => {
    const field = new Float64Array([1e9, 1e9 + 1, 1e9 + 2]);
    const triangles = new Uint32Array([0, 1, 2]);
    expect([...cornerPlaces(field, triangles, fieldRange(field, triangles))]).toEqual([0, 0.5, 1]);
  });

  test('that is constant stands in the middle of the map', () => {
    const triangles = new Uint32Array([0, 0, 0]);
    expect([...cornerPlaces(new Float32Array([7]), triangles, { lowest: 7, highest: 7 })]).toEqual([0.5, 0.5, 0.5]);
  });
});

describe('error / bound', () => {
  test('is the share of the bound that an error uses', () => {
    expect([0, 0.25, 0.5].map(placeByShare(0.5))).toEqual([0, 0.5, 1]);
  });

  test('does not call rounding up to single precision a broken bound', () => {
    const bound = 0.1;
    expect(Math.fround(bound)).toBeGreaterThan(bound);
    expect(placeByShare(bound)(Math.fround(bound))).toBe(1);
  });

  test('shows a broken bound', () => expect(placeByShare(0.1)(0.1001)).toBeGreaterThan(1));

  test('shows nothing where there is no bound', () => expect(placeByShare(Infinity)(5)).toBeLessThan(0));
});

describe('a signed error', () => {
  test('stands in the middle of the map where there is none, and at the ends where it reaches the bound', () => {
    expect([-0.5, -0.25, 0, 0.25, 0.5].map(placeBySign(0.5))).toEqual([0, 0.25, 0.5, 0.75, 1]);
  });

  test('is shown as broken beyond either end, and not for rounding', () => {
    const place = placeBySign(0.1);
    expect([-0.1001, 0.1001].map(place).every((found) => found > 1)).toBe(true);
    expect([-0.1, 0.1].map(Math.fround).map(place)).toEqual([0, 1]);
  });

  test('is no error where nothing has one', () => expect(placeBySign(0)(0)).toBe(0.5));

  test('of a triangle is the larger in size of its lowest and highest', () => {
    const [lowest, highest] = [new Float32Array([-3, -1, 0, -2]), new Float32Array([1, 2, 0, 2])];
    expect([...largerInSize(lowest, highest)]).toEqual([-3, 2, 0, 2]);
  });
});

describe('errors on a surface', () => {
  test('of triangles are the same at the three corners of each', () => {
    expect([...flatPlaces(new Float32Array([0.5, 0.25]), placeByShare(0.5))]).toEqual([1, 1, 1, 0.5, 0.5, 0.5]);
  });

  test('of vertices stand at the corners where the vertices are', () => {
    const triangles = new Uint32Array([2, 1, 0, 2, 0, 3]);
    const errors = new Float32Array([0, 1, 2, 4]);
    expect([...vertexPlaces(errors, triangles, placeByShare(4))]).toEqual([0.5, 0.25, 0, 0.5, 0, 1]);
  });
});
