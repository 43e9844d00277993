import { FormatError } from '../format-error.ts';
import { quoted } from '../text/wording.ts';
import type { GltfJson } from './gltf-json.ts';

type Item = Record<string, unknown>;

/** Checks the JSON for the lists, objects and references that glTF prescribes, as far as they matter here: nobody else does. */
export function checkShape(json: GltfJson): void {
  const [buffers, , accessors, meshes, nodes, scenes] = [
    'buffers',
    'bufferViews',
    'accessors',
    'meshes',
    'nodes',
    'scenes',
  ].map((name) => objectsIn(json[name], name));
  for (const name of ['extensionsUsed', 'extensionsRequired']) {
    if (!listIn(json[name], name).every(isText)) throw badShape(name, 'should be names');
  }
  for (const [index, { uri }] of buffers.entries()) {
    if (uri !== undefined && !isText(uri)) throw badShape(`buffer ${index}`, 'has a URI that is no text');
  }
  for (const [index, { primitives }] of meshes.entries()) {
    for (const primitive of objectsIn(primitives, `primitives of mesh ${index}`)) {
      checkPrimitive(primitive, accessors, `mesh ${index}`);
    }
  }
  for (const [index, node] of nodes.entries()) checkNode(node, meshes.length, `node ${index}`);
  checkForest(json.nodes ?? []);
  for (const [index, scene] of scenes.entries()) {
    for (const root of listIn(scene.nodes, `nodes of scene ${index}`)) {
      checkReference(root, nodes.length, 'node', `scene ${index}`);
    }
  }
  checkReference(json.scene, scenes.length, 'scene', 'the file');
}

/** The component types of whole numbers from 0 on. */
const unsigned: unknown[] = [5121, 5123, 5125];

function checkPrimitive({ attributes, indices, targets }: Item, accessors: Item[], where: string): void {
  if (!isObject(attributes)) throw badShape(where, 'has a primitive without attributes');
  for (const accessor of [...Object.values(attributes), indices]) {
    checkReference(accessor, accessors.length, 'accessor', where);
  }
  listIn(targets, `targets of ${where}`);
  const { type, componentType } = indices === undefined ? wholeNumbers : accessors[indices as number];
  if (type !== 'SCALAR' || !unsigned.includes(componentType)) {
    throw badShape(where, 'has indices that are no list of whole numbers');
  }
  requirePlaces(attributes, accessors, where);
}

const wholeNumbers: Item = { type: 'SCALAR', componentType: unsigned[0] };

/** An accessor of nothing is all zeros, which is what a reader sees who cannot unpack the extension that has the data. */
function requirePlaces({ POSITION: position }: Item, accessors: Item[], where: string): void {
  if (position === undefined) return;
  const { bufferView, sparse } = accessors[position as number];
  if (bufferView !== undefined || sparse !== undefined) return;
  throw new FormatError(
    'unsupported_feature',
    `The points of ${where} are not in the file, or packed in a way that is not read.`,
    where,
  );
}

/** How many numbers place a node. */
const transforms = { matrix: 16, translation: 3, rotation: 4, scale: 3 };

function checkNode(node: Item, meshes: number, where: string): void {
  checkReference(node.mesh, meshes, 'mesh', where);
  listIn(node.children, `children of ${where}`);
  for (const [name, count] of Object.entries(transforms)) {
    const numbers = listIn(node[name], `${name} of ${where}`);
    const good = node[name] === undefined || (numbers.length === count && numbers.every(Number.isFinite));
    if (!good) throw badShape(where, `has a ${name} that is not ${count} numbers`);
  }
}

function checkReference(value: unknown, count: number, noun: string, where: string): void {
  if (value === undefined || (Number.isInteger(value) && (value as number) >= 0 && (value as number) < count)) return;
  throw badShape(where, `names the ${noun} ${quoted(String(value))}, which does not exist`);
}

/** A list that may be missing. */
function listIn(value: unknown, where: string): unknown[] {
  if (value === undefined) return [];
  if (Array.isArray(value)) return value;
  throw badShape(where, 'should be a list');
}

function objectsIn(value: unknown, where: string): Item[] {
  const list = listIn(value, where);
  const wrong = list.findIndex((item) => !isObject(item));
  if (wrong >= 0) throw badShape(where, `should be objects, but number ${wrong} is none`);
  return list as Item[];
}

function isText(value: unknown): value is string {
  return typeof value === 'string';
}

function isObject(value: unknown): value is Item {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function badShape(where: string, fault: string): FormatError {
  return new FormatError('bad_header', `The JSON of the file does not follow glTF 2.0: ${where} ${fault}.`, where);
}

/** Nodes deeper than this would exhaust the stack of whoever follows them. */
const deepest = 256;

/** Every node has one parent at most and is not its own ancestor. */
function checkForest(nodes: { children?: number[] }[]): void {
  const parents = new Map<number, number>();
  for (const [parent, { children = [] }] of nodes.entries()) {
    for (const child of children) {
      if (!nodes[child]) throw badNode(child, 'is missing');
      if (parents.has(child)) throw badNode(child, 'has two parents');
      parents.set(child, parent);
    }
  }
  for (const start of nodes.keys()) {
    let [node, depth]: [number | undefined, number] = [start, 0];
    for (; node !== undefined && depth <= deepest; depth++) node = parents.get(node);
    if (node !== undefined) throw badNode(start, `is its own ancestor, or below more than ${deepest} others`);
  }
}

function badNode(node: number, fault: string): FormatError {
  return new FormatError('bad_header', `Node ${node} ${fault}.`, `node ${node}`);
}
