/**
 * Times one simplification by meshoptimizer's WebAssembly module, in a process of its own; prints a Measurement:
 *
 *     npx tsx tests/bench/meshoptimizer-run.ts MESH.ply VARIABLE,... TRIANGLES
 */
import { MeshoptSimplifier } from 'meshoptimizer';
import { type Attributed, attributed } from './attributed.ts';
import { type Measurement, sizes } from './cases.ts';
import { readMesh } from './read-mesh.ts';
import { timed } from './timing.ts';

const noErrorLimit = 1e30;

function simplify({ triangles, position, attributes, weights }: Attributed, target: number): number {
  const [left] =
    weights.length === 0
      ? MeshoptSimplifier.simplify(triangles, position, 3, 3 * target, noErrorLimit)
      : MeshoptSimplifier.simplifyWithAttributes(
          triangles,
          position,
          3,
          attributes,
          weights.length,
          weights,
          null,
          3 * target,
          noErrorLimit,
        );
  return left.length / 3;
}

const [path = '', names = '', target = ''] = process.argv.slice(2);
const variables = names.split(',').filter(Boolean);
await MeshoptSimplifier.ready;

// The engine compiles what runs often once more, and better: let it have done so.
simplify(attributed(readMesh({ path: sizes[0].path, variables })), 1000);

const mesh = attributed(readMesh({ path, variables }));
let left = 0;
const times = timed(() => {
  left = simplify(mesh, Number(target));
});
const measurement: Measurement = { ...times, triangles: mesh.triangles.length / 3, left, peakBytes: 0 };
console.log(JSON.stringify(measurement));
