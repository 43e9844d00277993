import { describe, expect, it } from 'vitest';
import { weld } from '../../web/formats/cracks/weld.ts';

/** Two triangles that share an edge in place, each with points of its own. */
function torn(values: number[]) {
  return {
    position: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, -0, 1, 1, 0, 0, 1, 0),
    triangles: Uint32Array.of(0, 1, 2, 3, 4, 5),
    variables: [{ name: 'p', components: 1, values: Float64Array.from(values) }],
  };
}

describe('welding', () => {
  it('makes one point of those that agree in everything', () => {
    const { mesh, welded } = weld(torn([1, 2, Number.NaN, 2, 4, Number.NaN]));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 1, 3, 2]);
    expect(Array.from(mesh.variables[0].values)).toEqual([1, 2, Number.NaN, 4]);
    expect(mesh.position).toEqual(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0));
    expect(welded).toBe(2);
  });

  it('leaves points apart whose values differ', () => {
    const { mesh, welded } = weld(torn([1, 2, 3, 2, 4, 3.0000000001]));
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 1, 3, 4]);
    expect(welded).toBe(1);
  });

  it('tells almost equal places apart', () => {
    const mesh = {
      ...torn([0, 0, 0, 0, 0, 0]),
      position: Float64Array.from({ length: 18 }, (_, i) => 1 + (i >= 9 ? 2 ** -52 : 0)),
    };
    expect(weld(mesh).welded).toBe(4);
  });

  it('takes a mesh without points', () => {
    expect(weld({ position: new Float32Array(), triangles: new Uint32Array(), variables: [] }).welded).toBe(0);
  });
});
