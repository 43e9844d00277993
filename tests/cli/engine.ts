import type { Mesh } from '../../wasm/types.ts';
import { bumpyPlate } from '../wasm/bumpy-plate.ts';

/** A bumpy plate with pressure (double), velocity (three components) and temperature (single precision). */
export function engine(side = 16): Mesh {
  const { position, triangles, variables } = bumpyPlate(side);
  const [height, flow] = variables;
  const temperature = Float32Array.from(height.values, (value) => 300 + 20 * value);
  return {
    position,
    triangles,
    variables: [
      { ...height, name: 'pressure' },
      { ...flow, name: 'velocity' },
      { name: 'temperature', components: 1, values: temperature },
    ],
  };
}
