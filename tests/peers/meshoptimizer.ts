import { readFileSync } from 'node:fs';
import { writeFile } from 'node:fs/promises';
import { MeshoptSimplifier, type SimplifierFlags } from 'meshoptimizer';

import type { Mesh } from '../../wasm/types.ts';
import { writePly } from '../../web/formats/ply/write-ply.ts';
import type { Peer, Setting, Simplify, Task } from './peer.ts';

const flags: SimplifierFlags[] = [
  'LockBorder',
  'Prune',
  'Regularize',
  'RegularizeLight',
  'PreserveFolds',
  'ErrorClamped',
  'Permissive',
];
/** Moves the vertices that are left, and changes their attributes, so that errors shrink. */
const update = 'update';
/** Runs until no collapse is below an error, instead of until a number of triangles is reached. */
const byError = 'by error';
const noErrorLimit = 1e30;
/** Errors, as fractions of the largest side of the mesh, between which `byError` looks for the number of triangles. */
const errors = { lowest: 1e-5, highest: 1 };
const errorSteps = 10;

/** The arrays as meshoptimizer takes them. */
interface Input {
  indices: Uint32Array;
  position: Float32Array;
  attributes: Float32Array;
  count: number;
  /** What a weight of 1 is in meshoptimizer's scale, one a variable. */
  unitWeights: number[];
}

export async function meshoptimizer(): Promise<Peer> {
  await MeshoptSimplifier.ready;
  const manifest = new URL('package.json', import.meta.resolve('meshoptimizer'));
  return {
    name: 'meshoptimizer',
    version: JSON.parse(readFileSync(manifest, 'utf8')).version,
    options: [update, byError, ...flags],
    starts: [[update], [update, 'LockBorder'], [], ['LockBorder']],
    pace: 150_000,
    open: async (task) => simplifier(inputOf(task), task.mesh),
    close() {},
  };
}

function inputOf({ mesh, bounds }: Task): Input {
  const vertices = mesh.position.length / 3;
  const count = mesh.variables.length;
  const position = Float32Array.from(mesh.position);
  const attributes = new Float32Array(vertices * count);
  for (const [column, { values }] of mesh.variables.entries()) {
    for (let vertex = 0; vertex < vertices; vertex++) attributes[vertex * count + column] = values[vertex];
  }
  // Inside, positions are divided by this scale, and attributes are multiplied by their weights.
  const positionBound = bounds[0] / MeshoptSimplifier.getScale(position, 3);
  const unitWeights = bounds.slice(1).map((bound) => positionBound / bound);
  return { indices: mesh.triangles, position, attributes, count, unitWeights };
}

function simplifier(input: Input, mesh: Mesh): Simplify {
  return async (setting, target, output) => {
    const result = setting.options.includes(byError)
      ? runByError(input, setting, target)
      : run(input, setting, target, noErrorLimit);
    await writeFile(output, writePly(compacted(result, mesh)));
    return result.indices.length / 3;
  };
}

/** The run with the least error limit that leaves at most `target` triangles. */
function runByError(input: Input, setting: Setting, target: number): Input {
  let { lowest, highest } = errors;
  let best = run(input, setting, 0, highest);
  for (let step = 0; step < errorSteps; step++) {
    const middle = Math.sqrt(lowest * highest);
    const result = run(input, setting, 0, middle);
    if (result.indices.length / 3 > target) {
      lowest = middle;
    } else {
      highest = middle;
      best = result;
    }
  }
  return best;
}

function run(input: Input, setting: Setting, target: number, error: number): Input {
  const weights = input.unitWeights.map((unit, variable) => unit * setting.weights[variable]);
  const chosen = flags.filter((flag) => setting.options.includes(flag));
  const { position, attributes, count } = input;
  if (!setting.options.includes(update)) {
    const [indices] = MeshoptSimplifier.simplifyWithAttributes(
      input.indices,
      position,
      3,
      attributes,
      count,
      weights,
      null,
      3 * target,
      error,
      chosen,
    );
    return { ...input, indices };
  }
  const updated = { indices: input.indices.slice(), position: position.slice(), attributes: attributes.slice() };
  const [left] = MeshoptSimplifier.simplifyWithUpdate(
    updated.indices,
    updated.position,
    3,
    updated.attributes,
    count,
    weights,
    null,
    3 * target,
    error,
    chosen,
  );
  return { ...input, ...updated, indices: updated.indices.subarray(0, left) };
}

/** The result as a mesh without the vertices that no triangle uses. */
function compacted({ indices, position, attributes, count }: Input, original: Mesh): Mesh {
  const used = [...new Set(indices)];
  const places = new Map(used.map((vertex, place) => [vertex, place]));
  return {
    position: Float32Array.from(used.flatMap((vertex) => [...position.subarray(3 * vertex, 3 * vertex + 3)])),
    triangles: indices.map((vertex) => places.get(vertex) ?? 0),
    variables: original.variables.map((variable, column) => ({
      ...variable,
      values: Float32Array.from(used, (vertex) => attributes[vertex * count + column]),
    })),
  };
}
