// The image of any point and the preimages of any point, by the pieces of the segmentation.
import { beforeAll, expect, test } from 'vitest';
import { reduce, segment } from '../../wasm/index.ts';
import type { MappedReduction, Reduction, Segmentation, SurfaceMap } from '../../wasm/types.ts';
import { Correspondence } from '../../web/probe/correspondence.ts';
import { distance, type Place, type Shares, valuesAt, variablesOf } from '../../web/probe/place.ts';
import { bumpyPlate } from '../wasm/bumpy-plate.ts';

const mesh = bumpyPlate(24);
const bounds = { position: { relative: 0.02 }, '*': { relative: 0.05 } };
/** Of places in triangles, which are added up from a few products. */
const rounding = 1e-9;

let reduction: Reduction;
let segmentation: Segmentation;
let correspondence: Correspondence;

beforeAll(async () => {
  reduction = await reduce(mesh, { bounds });
  segmentation = await segment(mesh, reduction);
  correspondence = new Correspondence(mesh, reduction as MappedReduction, segmentation);
});

/** Points all over a surface, some of them at corners and on edges; the same in every run. */
function pointsOn(triangles: number, perTriangle: number): Place[] {
  const shares: Shares[] = [
    [1 / 3, 1 / 3, 1 / 3],
    [0.05, 0.9, 0.05],
    [0.51, 0.02, 0.47],
    [0.5, 0.5, 0],
    [0, 0, 1],
    [0.123, 0.456, 0.421],
  ];
  return Array.from({ length: triangles * perTriangle }, (_, index) => ({
    triangle: Math.floor(index / perTriangle),
    barycentric: shares[index % shares.length],
  }));
}

const position = (place: Place, of = mesh) => valuesAt(variablesOf(of)[0], of.triangles, place);

test('the pieces cover every triangle of the original', () => {
  expect(segmentation.original).toHaveLength(segmentation.pieces.length / 3);
  expect(segmentation.reduced).toHaveLength(segmentation.pieces.length / 3);
  expect(new Set(segmentation.original).size).toBe(mesh.triangles.length / 3);
  expect(new Set(segmentation.reduced).size).toBe(reduction.mesh.triangles.length / 3);
});

test('a vertex goes where the map says', () => {
  const { triangle, barycentric } = reduction.map as SurfaceMap;
  mesh.triangles.forEach((vertex, corner) => {
    const shares = [0, 1, 2].map((each) => (each === corner % 3 ? 1 : 0)) as unknown as Shares;
    const image = correspondence.image({ triangle: Math.floor(corner / 3), barycentric: shares }) as Place;
    const [a, b, c] = barycentric.subarray(3 * vertex, 3 * vertex + 3);
    const expected = position({ triangle: triangle[vertex], barycentric: [a, b, c] }, reduction.mesh);
    expect(distance(position(image, reduction.mesh), expected)).toBeLessThan(rounding);
  });
});

test('on every point of the original all bounds hold, between vertices too', () => {
  const largest = reduction.report.variables.map(() => 0);
  for (const place of pointsOn(mesh.triangles.length / 3, 6)) {
    const image = correspondence.image(place) as Place;
    variablesOf(mesh).forEach((variable, index) => {
      const there = valuesAt(variablesOf(reduction.mesh)[index], reduction.mesh.triangles, image);
      largest[index] = Math.max(largest[index], distance(valuesAt(variable, mesh.triangles, place), there));
    });
  }
  reduction.report.variables.forEach(({ error, bound }, index) => {
    expect(largest[index]).toBeLessThanOrEqual(error * (1 + 1e-6));
    expect(largest[index]).toBeGreaterThan(0.3 * bound);
  });
});

test('every point of the reduced surface comes from points that are mapped to it, but for few that the map opens', () => {
  const places = pointsOn(reduction.mesh.triangles.length / 3, 6);
  let opened = 0;
  for (const place of places) {
    const preimages = correspondence.preimages(place);
    expect(preimages.length).toBeGreaterThan(0);
    for (const preimage of preimages) {
      const back = correspondence.image(preimage) as Place;
      const missed = distance(position(back, reduction.mesh), position(place, reduction.mesh));
      if (missed < 1e-6) continue;
      // On a line of the original that becomes an area: its points go to more than one, of which the image is another one.
      opened++;
      const again = correspondence.preimages(back).map((each) => distance(position(each), position(preimage)));
      expect(Math.min(...again)).toBeLessThan(1e-6);
    }
  }
  expect(opened).toBeLessThan(places.length / 50);
});

test('a point of the original is among those that its image comes from, unless it was squeezed into a line', () => {
  let squeezed = 0;
  const places = pointsOn(mesh.triangles.length / 3, 3);
  for (const place of places) {
    const image = correspondence.image(place) as Place;
    const nearest = Math.min(
      ...correspondence.preimages(image).map((each) => distance(position(each), position(place))),
    );
    if (nearest < 1e-6) continue;
    // What was kept within a reduced triangle lies on its border.
    expect(Math.min(...image.barycentric)).toBeLessThan(rounding);
    squeezed++;
  }
  expect(squeezed).toBeLessThan(places.length / 100);
});

test('where the map folds nothing, a point comes from one point', () => {
  const places = pointsOn(reduction.mesh.triangles.length / 3, 3);
  const several = places.filter((place) => correspondence.preimages(place).length > 1);
  if (segmentation.foldedPieces === 0) expect(several).toEqual([]);
  expect(several.length).toBeLessThan(places.length / 2);
});
