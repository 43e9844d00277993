/**
 * Times one reduction by the WebAssembly module, in a process of its own; prints a Measurement:
 *
 *     npx tsx tests/bench/module-run.ts MESH.ply VARIABLE,... tracked|propagated
 */
import { loadCore } from '../../wasm/load-core.ts';
import { bounds, type Errors, type Measurement, sizes } from './cases.ts';
import { readMesh } from './read-mesh.ts';
import { timed } from './timing.ts';

/** Learns of the module's memory as it is instantiated; the module keeps it to itself. */
function watchMemory(): () => number {
  const { instantiate } = WebAssembly;
  let memory: WebAssembly.Memory | undefined;
  WebAssembly.instantiate = (async (...given: Parameters<typeof instantiate>) => {
    const source = (await instantiate(...given)) as unknown as WebAssembly.WebAssemblyInstantiatedSource;
    const exported = Object.values(source.instance.exports);
    memory = exported.find((value) => value instanceof WebAssembly.Memory);
    return source;
  }) as unknown as typeof instantiate;
  return () => memory?.buffer.byteLength ?? 0;
}

const [path = '', names = '', errors = 'tracked'] = process.argv.slice(2);
const variables = names.split(',').filter(Boolean);
const memoryBytes = watchMemory();
const core = await loadCore();

function reduce(mesh: ReturnType<typeof readMesh>): number {
  const outcome = core.reduce(mesh, { bounds, errors: errors as Errors }, () => true);
  if (!outcome.ok) throw new Error(outcome.failure.message);
  return outcome.value.report.triangles.after;
}

// The engine compiles what runs often once more, and better: let it have done so.
reduce(readMesh({ path: sizes[0].path, variables }));

const mesh = readMesh({ path, variables });
let left = 0;
const times = timed(() => {
  left = reduce(mesh);
});
const measurement: Measurement = { ...times, triangles: mesh.triangles.length / 3, left, peakBytes: memoryBytes() };
console.log(JSON.stringify(measurement));
