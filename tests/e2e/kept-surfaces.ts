/** Surfaces with regions, small parts and parts near each other, as meshes and as VTP files. */
import type { Mesh } from '../../wasm/types.ts';
import { writeSurface } from '../../web/formats/write.ts';

export async function vtp(mesh: Mesh, regionName = 'material'): Promise<Buffer> {
  return Buffer.from(await writeSurface('vtp', mesh, { regionName }));
}

function grid(side: number): { across: number[][]; triangles: number[] } {
  const across = Array.from({ length: side * side }, (_, i) => [
    (i % side) / (side - 1),
    Math.floor(i / side) / (side - 1),
  ]);
  const triangles = across.flatMap((_, i) =>
    i % side < side - 1 && i + side < side * side ? [i, i + 1, i + side + 1, i, i + side + 1, i + side] : [],
  );
  return { across, triangles };
}

/** From where to where across the sheet of `patches` each region reaches. */
export const strips = new Map([
  [1, [0, 0.35]],
  [2, [0.35, 0.7]],
  [5, [0.7, 1]],
]);

/**
 * A wavy sheet of 41 × 41 vertices with `heat`, and `sharpness` from 0.2 at its left end to 3 at its right one; in three
 * regions side by side; over it a tetrahedron 0.004 wide.
 */
export function patches(): Mesh {
  const side = 41;
  const { across, triangles } = grid(side);
  const regions = Array.from({ length: triangles.length / 3 }, (_, triangle) => {
    const middle = ((triangles[3 * triangle] % side) + 0.5) / (side - 1);
    return [...strips].find(([, [from, to]]) => middle > from && middle < to)?.[0] ?? 0;
  });
  const tip = across.length;
  const small = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1].map((each) => 0.5 + 0.004 * each);
  const all = [...across, ...[0, 0, 0, 0].map(() => [0.5, 0.5])];
  const variable = (name: string, value: (x: number, y: number) => number) => ({
    name,
    components: 1,
    values: Float64Array.from(all, ([x, y]) => value(x, y)),
  });
  return {
    position: Float64Array.from([
      ...across.flatMap(([x, y]) => [x, y, 0.1 * Math.sin(7 * x) * Math.cos(5 * y)]),
      ...small,
    ]),
    triangles: Uint32Array.from([...triangles, ...[0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3].map((corner) => tip + corner)]),
    variables: [
      variable('heat', (x, y) => 300 + 40 * Math.sin(9 * x + 4 * y)),
      variable('sharpness', (x) => 0.2 + 2.8 * x),
    ],
    regions: Int32Array.from([...regions, 2, 2, 2, 2]),
  };
}

/** A plate with a hump of height 0.1, into which the tip of a tetrahedron reaches from below: 0.05 under the hump's top. */
export function humpAndSpike(): Mesh {
  const plate = [0, 0.5, 1].flatMap((y) => [0, 0.5, 1].flatMap((x) => [x, y, x === 0.5 && y === 0.5 ? 0.1 : 0]));
  const spike = [0.5, 0.5, 0.05, 0.48, 0.48, -0.1, 0.52, 0.48, -0.1, 0.5, 0.52, -0.1];
  const cells = [0, 1, 3, 4].flatMap((at) => [at, at + 1, at + 4, at, at + 4, at + 3]);
  const tetrahedron = [9, 11, 10, 9, 12, 11, 9, 10, 12, 10, 11, 12];
  return {
    position: Float64Array.from([...plate, ...spike]),
    triangles: Uint32Array.from([...cells, ...tetrahedron]),
    variables: [],
  };
}

/** A sheet of which one triangle faces the other side. */
export function oneTurned(): Mesh {
  const { across, triangles } = grid(5);
  const turned = triangles.map((corner, i) => (i === 30 ? triangles[31] : i === 31 ? triangles[30] : corner));
  return {
    position: Float64Array.from(across.flatMap(([x, y]) => [x, y, 0])),
    triangles: Uint32Array.from(turned),
    variables: [],
  };
}
