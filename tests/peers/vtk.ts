import { spawnSync } from 'node:child_process';
import { join } from 'node:path';

import { LineServer } from './line-server.ts';
import type { Peer } from './peer.ts';
import { places } from './places.ts';

const volumePreservation = 'volume preservation';
/** Debian's packages serve its own Python; another one may come first on the path. */
const interpreters = ['/usr/bin/python3', 'python3'];
const printVersion = 'from vtkmodules.vtkCommonCore import vtkVersion; import numpy; print(vtkVersion.GetVTKVersion())';

/** vtkQuadricDecimation with attribute errors; undefined where no Python with VTK is installed. */
export function vtk(): Peer | undefined {
  for (const python of interpreters) {
    const { status, stdout } = spawnSync(python, ['-c', printVersion], { encoding: 'utf8' });
    if (status === 0) return peer(python, stdout.trim());
  }
  return undefined;
}

function peer(python: string, version: string): Peer {
  const server = new LineServer(python, [join(places.nativeSources, 'vtk_decimate.py')]);
  return {
    name: 'VTK',
    version,
    options: [volumePreservation],
    starts: [[]],
    pace: 60_000,
    async open({ path, mesh, bounds }) {
      await server.ask(JSON.stringify({ open: path }));
      const size = extent(mesh.position);
      return async (setting, target, output) => {
        // As large as the box of position, where VTK's own thresholds are made for; only their proportions matter else.
        const unit = bounds[0] / size;
        const scales = [
          1 / size,
          ...bounds.slice(1).map((bound, variable) => (unit * setting.weights[variable]) / bound),
        ];
        const volume = setting.options.includes(volumePreservation);
        return Number(await server.ask(JSON.stringify({ scales, triangles: target, volume, out: output })));
      };
    },
    close: () => server.close(),
  };
}

/** The diagonal of the box. */
function extent(position: ArrayLike<number>): number {
  const lowest = [Infinity, Infinity, Infinity];
  const highest = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < position.length; i++) {
    lowest[i % 3] = Math.min(lowest[i % 3], position[i]);
    highest[i % 3] = Math.max(highest[i % 3], position[i]);
  }
  return Math.hypot(...highest.map((high, axis) => high - lowest[axis]));
}
