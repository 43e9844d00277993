import type { GltfJson } from './gltf-json.ts';

/**
 * The JSON with nothing in place of the accessors, views and buffers that no primitive uses: pictures, animations and the like
 * can be damaged, packed or elsewhere, and do not matter to the surface. All others keep their numbers.
 */
export function neededOnly(json: GltfJson): GltfJson {
  const primitives = (json.meshes ?? []).flatMap((mesh) => mesh.primitives ?? []);
  const accessors = new Set(
    primitives.flatMap(({ attributes, indices }) => [...Object.values(attributes ?? {}), indices]),
  );
  const used = (json.accessors ?? []).filter((_, index) => accessors.has(index));
  const views = new Set(
    used.flatMap(({ bufferView, sparse }) => [bufferView, sparse?.indices?.bufferView, sparse?.values?.bufferView]),
  );
  const buffers = new Set((json.bufferViews ?? []).flatMap(({ buffer }, index) => (views.has(index) ? [buffer] : [])));
  return {
    ...json,
    accessors: json.accessors?.map((each, index) => (accessors.has(index) ? each : noAccessor)),
    bufferViews: json.bufferViews?.map((each, index) => (views.has(index) ? each : { buffer: 0, byteLength: 0 })),
    buffers: json.buffers?.map((each, index) => (buffers.has(index) ? each : { byteLength: 0 })),
  };
}

const noAccessor = { componentType: 5121, count: 1, type: 'SCALAR' };
