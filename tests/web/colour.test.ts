import { describe, expect, test } from 'vitest';
import {
  aboveBoundColour,
  aboveRangeColour,
  belowRangeColour,
  type Colormap,
  colourAt,
  colourTable,
  cssGradient,
  divergingColormaps,
  isDiverging,
  tableSize,
  valueColormaps,
} from '../../web/colour/colormaps.ts';
import {
  centredOnZero,
  chosenRange,
  dataRange,
  parseRange,
  placeIn,
  rangeText,
  roundTicks,
} from '../../web/colour/colour-range.ts';
import { flatPlaces, largerInSize, placeByShare, placeBySign, vertexPlaces } from '../../web/colour/error-places.ts';
import { componentsOf, cornerPlaces, fieldOf, fieldRange } from '../../web/colour/field.ts';

const maps: Colormap[] = ['viridis', 'cividis', 'magma', 'RdBu', 'PuOr', 'share'];

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

  test.each(valueColormaps)('%s stays far from the colours of values outside its range', (map) => {
    for (const place of Array.from({ length: 101 }, (_, step) => step / 100)) {
      for (const outside of [belowRangeColour, aboveRangeColour]) {
        const distance = Math.hypot(...colourAt(map, place).map((part, index) => part - outside[index]));
        expect(distance).toBeGreaterThan(120);
      }
    }
  });

  test.each(divergingColormaps)('%s is lightest in the middle, and warm where positive', (map) => {
    const sum = (place: number) => colourAt(map, place).reduce((total, part) => total + part, 0);
    expect(sum(0.5)).toBeGreaterThan(Math.max(sum(0.1), sum(0.9)) + 200);
    const [coldRed, , coldBlue] = colourAt(map, 0.1);
    const [warmRed, , warmBlue] = colourAt(map, 0.9);
    expect(warmRed - warmBlue).toBeGreaterThan(coldRed - coldBlue);
    expect(isDiverging(map)).toBe(true);
  });

  test.each(['viridis', 'cividis', 'magma'] as const)('%s grows lighter all the way', (map) => {
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

  test('lies between percentiles of the finite values', () => {
    const values = Float64Array.from({ length: 101 }, (_, index) => 100 - index);
    expect(chosenRange(values, { percentiles: [2, 98] })).toEqual({ lowest: 2, highest: 98 });
    expect(chosenRange([NaN, 5, Infinity, 7], { percentiles: [0, 100] })).toEqual({ lowest: 5, highest: 7 });
    expect(chosenRange([], { percentiles: [0, 100] })).toEqual({ lowest: 0, highest: 0 });
  });

  test('is the one that was typed, or that of the data', () => {
    expect(chosenRange([3, 9], { lowest: 0, highest: 5 })).toEqual({ lowest: 0, highest: 5 });
    expect(chosenRange([3, 9], 'data')).toEqual({ lowest: 3, highest: 9 });
  });

  test.each([
    ['data', 'data'],
    ['', 'data'],
    ['0…1.5', { lowest: 0, highest: 1.5 }],
    ['-2e3 .. 0', { lowest: -2000, highest: 0 }],
    ['\u22122, 3', { lowest: -2, highest: 3 }],
    ['1 to 2', { lowest: 1, highest: 2 }],
    ['1 2', { lowest: 1, highest: 2 }],
    ['2%…98%', { percentiles: [2, 98] }],
    ['2 % 98 %', { percentiles: [2, 98] }],
  ] as const)('is read from %j', (text, choice) => {
    expect(parseRange(text)).toEqual(choice);
    expect(parseRange(rangeText(choice as never))).toEqual(choice);
  });

  test.each(['3', '2…1', '1…1', 'a…b', '1…2…3', '2%…98', '-1%…50%', '2%…101%', '1…Infinity', '…2'])(
    'is not read from %j',
    (text) => expect(parseRange(text)).toBeNull(),
  );

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

  test('says how far outside the range a value lies', () => {
    const places = cornerPlaces(new Float32Array([-2, 4, 6]), new Uint32Array([0, 1, 2]), { lowest: 0, highest: 4 });
    expect([...places]).toEqual([-0.5, 1, 1.5]);
  });

  test('is missing on the whole of a triangle that has a corner without a number', () => {
    const field = new Float32Array([0, 1, NaN, 1]);
    const places = cornerPlaces(field, new Uint32Array([0, 1, 2, 0, 1, 3]), { lowest: 0, highest: 1 });
    expect([...places].map((place) => place < -1e20)).toEqual([true, true, true, false, false, false]);
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
