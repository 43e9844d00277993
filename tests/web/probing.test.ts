import { beforeAll, describe, expect, test, vi } from 'vitest';
import { reduce, segment } from '../../wasm/index.ts';
import type { Reduction } from '../../wasm/types.ts';
import type { Place } from '../../web/probe/place.ts';
import { Probing } from '../../web/session/probing.ts';
import { bumpyPlate } from '../wasm/bumpy-plate.ts';

const mesh = bumpyPlate(12);
const names = ['position', ...mesh.variables.map(({ name }) => name)];
const bounds = { position: { relative: 0.02 }, '*': { relative: 0.05 } };
const somewhere: Place = { triangle: 7, barycentric: [0.2, 0.5, 0.3] };

let tracked: Reduction;
let looser: Reduction;
let propagated: Reduction;

beforeAll(async () => {
  tracked = await reduce(mesh, { bounds });
  looser = await reduce(mesh, { bounds: { '*': { relative: 0.2 }, position: { relative: 0.1 } } });
  propagated = await reduce(mesh, { bounds, errors: 'propagated' });
});

function setUp(reduction: Reduction | null = tracked) {
  const cut = vi.fn(segment);
  const report = vi.fn();
  const probing = new Probing(cut, report);
  probing.follow(mesh, reduction);
  const known = () => vi.waitFor(() => expect(probing.state.pending).toBe(false));
  return { probing, cut, report, known };
}

describe('a place that is pointed at', () => {
  test('is known on its own surface at once, on the other when the map has been looked at, once', async () => {
    const { probing, cut, known } = setUp();
    expect(cut).not.toHaveBeenCalled();
    probing.point('original', somewhere);
    expect(probing.state).toMatchObject({ pinned: false, pending: true });
    expect(probing.state.probe?.original).toMatchObject(somewhere);
    expect(probing.state.probe?.reduced).toBeNull();
    await known();
    const { probe } = probing.state;
    expect(probe?.variables.map(({ name }) => name)).toEqual(names);
    for (const { ratio } of probe?.variables ?? []) expect(ratio).toBeLessThanOrEqual(1);
    probing.point('reduced', { triangle: 0, barycentric: [1, 0, 0] });
    expect(probing.state.pending).toBe(false);
    expect(probing.state.probe?.original).not.toBeNull();
    expect(cut).toHaveBeenCalledTimes(1);
    probing.point('original', null);
    expect(probing.state.probe).toBeNull();
  });

  test('waits for a reduction that runs', async () => {
    const { probing, cut, known } = setUp();
    probing.mayCut = false;
    probing.point('original', somewhere);
    expect(probing.state.pending).toBe(true);
    expect(cut).not.toHaveBeenCalled();
    probing.mayCut = true;
    await known();
    expect(probing.state.probe?.reduced).not.toBeNull();
  });

  test('stays known on its surface where the map cannot be looked at, which is said once', async () => {
    const { probing, cut, report, known } = setUp();
    cut.mockRejectedValue(new Error('out of memory'));
    probing.point('original', somewhere);
    await known();
    expect(probing.state.probe?.original).not.toBeNull();
    expect(probing.state.probe?.reduced).toBeNull();
    probing.point('original', { ...somewhere, triangle: 8 });
    await known();
    expect(report).toHaveBeenCalledTimes(1);
  });

  test('has values where nothing was reduced, and limits where errors were propagated', () => {
    const bare = setUp(null);
    bare.probing.point('original', somewhere);
    expect(bare.probing.state).toMatchObject({ pending: false, probe: { reduced: null } });
    expect(bare.probing.state.probe?.variables[1]).toMatchObject({ reduced: null, error: null, ratio: null });

    const limited = setUp(propagated);
    limited.probing.point('reduced', { triangle: 3, barycentric: [0.2, 0.2, 0.6] });
    expect(limited.cut).not.toHaveBeenCalled();
    expect(limited.probing.state.probe?.original).toBeNull();
    expect(limited.probing.state.probe?.variables[1].error).toBe(propagated.triangleErrors[1].largest[3]);
  });
});

test('a share of a bound is that of the bound as it is multiplied there', async () => {
  const multiplier = Float64Array.from({ length: mesh.position.length / 3 }, (_, vertex) => 1 + vertex);
  const { probing, known } = setUp(Object.assign({}, tracked, { multiplier }));
  probing.point('original', somewhere);
  await known();
  const corners = [...mesh.triangles.subarray(3 * somewhere.triangle, 3 * somewhere.triangle + 3)];
  const here = corners.reduce((sum, vertex, i) => sum + somewhere.barycentric[i] * (1 + vertex), 0);
  const { bound, error, ratio } = probing.state.probe?.variables[1] ?? {};
  expect(bound).toBeCloseTo(here * tracked.report.variables[1].bound, 12);
  expect(ratio).toBe((error as number) / (bound as number));

  const limited = setUp(Object.assign({}, propagated, { multiplier }));
  limited.probing.point('reduced', { triangle: 3, barycentric: [0.2, 0.2, 0.6] });
  expect(limited.probing.state.probe?.variables[1].ratio).toBe(propagated.triangleErrors[1].ratio[3]);
});

describe('a place that is pinned', () => {
  test('stays while others are pointed at, until it is let go', () => {
    const { probing } = setUp();
    probing.pin('original', somewhere);
    probing.point('original', { ...somewhere, triangle: 9 });
    probing.point('original', null);
    expect(probing.state).toMatchObject({ pinned: true, probe: { original: somewhere } });
    probing.pin('original', null);
    expect(probing.state).toMatchObject({ pinned: false, probe: null });
  });

  test('stays on the original when other bounds give another reduction, and goes with the surface', async () => {
    const { probing, known } = setUp();
    probing.pin('reduced', { triangle: 5, barycentric: [0.3, 0.3, 0.4] });
    await known();
    const before = probing.state.probe?.original;
    expect(before).not.toBeNull();
    probing.follow(mesh, looser);
    await known();
    expect(probing.state.pinned).toBe(true);
    expect(probing.state.probe?.original?.triangle).toBe(before?.triangle);
    expect(probing.state.probe?.reduced?.triangle).toBeLessThan(looser.mesh.triangles.length / 3);
    probing.follow(bumpyPlate(10), null);
    expect(probing.state).toMatchObject({ pinned: false, probe: null });
  });

  test('can be the worst of each variable, in the reported size', async () => {
    for (const [reduction, digits] of [
      [tracked, 5],
      [propagated, 5],
    ] as const) {
      const { probing } = setUp(reduction);
      names.forEach((name, index) => {
        probing.pinWorst(name);
        expect(probing.state.pinned).toBe(true);
        const { ratio } = reduction.report.variables[index];
        expect(probing.state.probe?.variables[index].ratio).toBeCloseTo(ratio, digits);
      });
    }
    const { probing } = setUp();
    probing.pinWorst('no such variable');
    expect(probing.state.probe).toBeNull();
  });
});
