import { type Accessor, Document, type Extension, Logger, type Node, Primitive, WebIO } from '@gltf-transform/core';
import type { Mesh, Variable } from '../../../wasm/types.ts';
import type { WriteOptions } from '../surface.ts';
import { areBytes } from '../variables/colours.ts';
import { byRole, type Role } from '../variables/roles.ts';
import { type GltfExtras, isTexture, semanticFor } from './gltf-variables.ts';
import { localOrigin } from './local-origin.ts';
import { upsideDown } from './texture-direction.ts';

const types = new Map<number, 'SCALAR' | 'VEC2' | 'VEC3' | 'VEC4'>([
  [1, 'SCALAR'],
  [2, 'VEC2'],
  [3, 'VEC3'],
  [4, 'VEC4'],
]);

/**
 * Writes a GLB file in single precision; a surface far from the origin is moved near to it, and its node back (in doubles).
 * Normals, colours and texture coordinates take the places that glTF has for them if their values fit; all else becomes
 * attributes `_NAME`. Names, units and component names stand in the extras. A variable of more than four components becomes
 * an attribute for each.
 */
export async function writeGlb(mesh: Mesh, options: WriteOptions = {}): Promise<Uint8Array> {
  const document = emptyDocument();
  return glbOf(document, addNode(document, mesh, options));
}

export function emptyDocument(): Document {
  const document = new Document().setLogger(new Logger(Logger.Verbosity.SILENT));
  document.createBuffer();
  return document;
}

/** The bytes of a file whose scene is one node; its extensions are among those given. */
export async function glbOf(
  document: Document,
  node: Node,
  extensions: (typeof Extension)[] = [],
): Promise<Uint8Array> {
  document.getRoot().setDefaultScene(document.createScene().addChild(node));
  document.getRoot().getAsset().generator = 'Meshbound';
  return new WebIO().registerExtensions(extensions).setLogger(document.getLogger()).writeBinary(document);
}

/** Adds a mesh to a document as a node that no scene shows yet. */
export function addNode(document: Document, mesh: Mesh, options: WriteOptions): Node {
  const [buffer] = document.getRoot().listBuffers();
  const primitive = document.createPrimitive().setMode(Primitive.Mode.TRIANGLES);
  const add = (semantic: string, values: Float32Array | Uint8Array, components: number, extras?: GltfExtras) => {
    const accessor = document
      .createAccessor()
      .setBuffer(buffer)
      .setArray(values as Float32Array<ArrayBuffer> | Uint8Array<ArrayBuffer>)
      .setNormalized(values instanceof Uint8Array);
    accessor.setType(types.get(components) ?? 'SCALAR');
    if (extras) accessor.setExtras({ meshbound: extras });
    primitive.setAttribute(semantic, accessor);
  };
  const origin = options.origin ?? localOrigin(mesh);
  const unit = labelsOf('position', options);
  add(
    'POSITION',
    Float32Array.from(mesh.position, (value, i) => value - origin[i % 3]),
    3,
    Object.keys(unit).length > 0 ? { name: 'position', ...unit } : undefined,
  );
  const used = new Set(['POSITION']);
  const roles = new Map([...byRole(mesh.variables, options)].map(([role, variable]) => [variable, role]));
  for (const variable of mesh.variables) addVariable(variable, roles.get(variable), used, options, add);
  primitive.setIndices(document.createAccessor().setBuffer(buffer).setType('SCALAR').setArray(indicesOf(mesh)));
  const node = document.createNode().setMesh(document.createMesh().addPrimitive(primitive));
  return origin.some((value) => value !== 0) ? node.setTranslation(origin) : node;
}

function labelsOf(name: string, { units = {}, componentNames = {} }: WriteOptions): Omit<GltfExtras, 'name'> {
  return {
    ...(Object.hasOwn(units, name) ? { unit: units[name] } : {}),
    ...(Object.hasOwn(componentNames, name) ? { componentNames: componentNames[name] } : {}),
  };
}

type Add = (semantic: string, values: Float32Array | Uint8Array, components: number, extras: GltfExtras) => void;

function addVariable(
  variable: Variable,
  role: Role | undefined,
  used: Set<string>,
  options: WriteOptions,
  add: Add,
): void {
  const { name, components } = variable;
  const extras = { name, ...labelsOf(name, options) };
  const semantic = semanticFor({ ...variable, values: Float32Array.from(variable.values) }, role);
  const free = types.has(components) ? unique(nextOfItsKind(variable, used) ?? semantic, used) : semantic;
  const values = Float32Array.from(isTexture(free) ? upsideDown(variable.values) : variable.values);
  const isBytes = /^COLOR_\d+$/.test(free) && areBytes(variable.values);
  if (types.has(components)) add(free, isBytes ? Uint8Array.from(values) : values, components, extras);
  for (let component = 0; !types.has(components) && component < components; component++) {
    const part = values.filter((_, i) => i % components === component);
    add(unique(`${semantic}_${component}`, used), part, 1, { ...extras, component });
  }
}

/** Further texture coordinates, as they were read: glTF numbers them without a gap. */
function nextOfItsKind({ name, components }: Variable, used: Set<string>): string | undefined {
  const number = components === 2 ? Number(/^uv_([1-9]\d*)$/.exec(name)?.[1]) : Number.NaN;
  return used.has(`TEXCOORD_${number - 1}`) ? `TEXCOORD_${number}` : undefined;
}

function unique(semantic: string, used: Set<string>): string {
  // Copies are names of this project's own, which begin with an underscore.
  const own = semantic.startsWith('_') ? semantic : `_${semantic}`;
  let free = semantic;
  for (let copy = 2; used.has(free); copy++) free = `${own}__${copy}`;
  used.add(free);
  return free;
}

/** In 16 bits where that is enough; the largest index is reserved. */
function indicesOf({ position, triangles }: Mesh): NonNullable<ReturnType<Accessor['getArray']>> {
  return position.length / 3 < 2 ** 16 ? Uint16Array.from(triangles) : Uint32Array.from(triangles);
}
