// A hill that carries a temperature, reduced to several bounds: npx tsx examples/node/reduce.ts
import { type Mesh, MeshboundError, reduce } from '../../wasm/index.ts'; // later: from 'meshbound'

function hill(cells: number): Mesh {
  const side = cells + 1;
  const at = (vertex: number) => [(2 * (vertex % side)) / cells - 1, (2 * Math.floor(vertex / side)) / cells - 1];
  const vertices = Array.from({ length: side * side }, (_, vertex) => vertex);
  const corners = vertices.filter((vertex) => vertex % side < cells && vertex < side * cells);
  const position = vertices.flatMap((vertex) => {
    const [x, y] = at(vertex);
    return [x, y, 0.4 / (1 + 4 * (x * x + y * y))];
  });
  const triangles = corners.flatMap((v) => [v, v + 1, v + side + 1, v, v + side + 1, v + side]);
  const temperature = vertices.map((vertex) => 300 + 20 * at(vertex)[0]);
  return {
    position: Float64Array.from(position),
    triangles: Uint32Array.from(triangles),
    variables: [{ name: 'temperature', components: 1, values: Float64Array.from(temperature) }],
  };
}

const mesh = hill(64);
for (const share of [0.001, 0.01, 0.05]) {
  try {
    const { report } = await reduce(mesh, {
      bounds: { position: { relative: share }, temperature: { absolute: 0.5 } },
    });
    const [position, temperature] = report.variables;
    console.log(
      `${100 * share} % of the size: ${report.triangles.before} triangles became ${report.triangles.after};`,
      `moved by at most ${position.error.toFixed(5)}, the temperature by ${temperature.error.toFixed(3)}`,
    );
  } catch (error) {
    // What is wrong with a mesh or a bound comes with a code, a sentence and a place.
    if (!(error instanceof MeshboundError)) throw error;
    console.error(error.code, error.message);
    process.exitCode = 1;
  }
}
