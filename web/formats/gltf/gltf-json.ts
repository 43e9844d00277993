/** As much of glTF's JSON as is looked at before glTF-Transform reads it. */
export interface GltfJson {
  asset?: { version?: string };
  extensionsUsed?: string[];
  extensionsRequired?: string[];
  buffers?: { byteLength?: number; uri?: string }[];
  bufferViews?: { buffer?: number; byteOffset?: number; byteLength?: number; byteStride?: number }[];
  accessors?: GltfAccessor[];
  meshes?: { primitives?: GltfPrimitive[] }[];
  nodes?: { mesh?: number; children?: number[]; skin?: number; camera?: number }[];
  scenes?: { nodes?: number[] }[];
  scene?: number;
  [other: string]: unknown;
}

export interface GltfAccessor {
  bufferView?: number;
  byteOffset?: number;
  componentType?: number;
  count?: number;
  type?: string;
  sparse?: { count?: number; indices?: GltfAccessor; values?: GltfAccessor };
}

export interface GltfPrimitive {
  attributes?: Record<string, number>;
  indices?: number;
  mode?: number;
  material?: number;
  targets?: unknown[];
}
