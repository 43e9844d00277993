// What the app does itself (a reduction of a mesh that it has made), and what it leaves to the viewer (a file).
import '../../web/element/index.ts'; // later: 'meshbound/viewer'
import { type Mesh, reduce } from '../../wasm/index.ts'; // later: from 'meshbound'

const result = document.querySelector('#result') as HTMLElement;
const viewer = document.querySelector('meshbound-viewer') as HTMLElementTagNameMap['meshbound-viewer'];
const files = document.querySelector('input') as HTMLInputElement;

function hill(cells: number): Mesh {
  const side = cells + 1;
  const position = new Float32Array(3 * side * side);
  const triangles: number[] = [];
  for (let vertex = 0; vertex < side * side; ++vertex) {
    const [column, row] = [vertex % side, Math.floor(vertex / side)];
    const [x, y] = [(2 * column) / cells - 1, (2 * row) / cells - 1];
    position.set([x, y, 0.4 / (1 + 4 * (x * x + y * y))], 3 * vertex);
    if (column === cells || row === cells) continue;
    triangles.push(vertex, vertex + 1, vertex + side + 1, vertex, vertex + side + 1, vertex + side);
  }
  return { position, triangles: Uint32Array.from(triangles), variables: [] };
}

files.addEventListener('change', () => {
  const [file] = files.files ?? [];
  if (file) void viewer.open(file);
});

try {
  const { report } = await reduce(hill(64), {
    bounds: { position: { relative: 0.01 } },
    onProgress: (share) => {
      result.textContent = `A hill is being reduced: ${Math.round(100 * share)} %`;
    },
  });
  result.textContent = `A hill of ${report.triangles.before} triangles became one of ${report.triangles.after}.`;
} catch (error) {
  result.textContent = error instanceof Error ? error.message : String(error);
}
