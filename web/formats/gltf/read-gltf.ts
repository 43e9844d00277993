import {
  type Accessor,
  type Document,
  type JSONDocument,
  Logger,
  type Node,
  type Primitive,
  WebIO,
} from '@gltf-transform/core';
import type { Mesh } from '../../../wasm/types.ts';
import { expansionLimit } from '../bytes/expansion-limit.ts';
import { joined } from '../bytes/joined-arrays.ts';
import { weldedSurface } from '../cracks/welded-surface.ts';
import { checkIndices } from '../faces/polygons.ts';
import { FormatError } from '../format-error.ts';
import type { Beside, Surface } from '../surface.ts';
import { counted, foreign, listed } from '../text/wording.ts';
import { asFloatingPoint } from '../variables/precision.ts';
import { checkAccessors } from './gltf-accessors.ts';
import { readBuffers } from './gltf-buffers.ts';
import { openGltf } from './gltf-container.ts';
import type { GltfJson } from './gltf-json.ts';
import { neededOnly } from './gltf-needed.ts';
import {
  extrasOf,
  type GltfAttribute,
  type GltfExtras,
  joinAttributes,
  namedAttributes,
  safeName,
  withSafeNames,
} from './gltf-variables.ts';
import { localOrigin } from './local-origin.ts';

/** The modes of a primitive that are triangles. */
const modes = { triangles: 4, strip: 5, fan: 6 };

/** A primitive where a node of the scene puts it. */
interface Placed {
  primitive: Primitive;
  /** Column by column. */
  matrix: number[];
}

interface Part {
  /** In double precision where a node moved it. */
  position: Float32Array | Float64Array;
  triangles: Uint32Array;
  attributes: GltfAttribute[];
  /** What the extras say of places. */
  labels: Partial<GltfExtras>;
  /** Semantics that are not carried. */
  lost: string[];
  /** Corners of no whole triangle. */
  leftOver: number;
}

/**
 * Reads a GLB file, or a glTF file with its buffers inside or in files that `beside` gives. All triangles of the default scene become one mesh, put where
 * their nodes put them and welded. NORMAL, COLOR_0 and TEXCOORD_0 become `normal`, `color` and `uv`; `_NAME` becomes NAME,
 * or whatever the writer of this project noted as its name. Places that nodes
 * move are read in double precision, all other numbers are single.
 */
export async function readGltf(bytes: Uint8Array, beside?: Beside): Promise<Surface> {
  const opened = openGltf(bytes);
  const file = { ...opened, json: neededOnly(opened.json) };
  const buffers = await readBuffers(file, beside);
  const fileSize = bytes.length + [...new Set(buffers)].reduce((sum, { length }) => sum + length, 0);
  checkAccessors(file.json, buffers, fileSize);
  const document = await readDocument(file.json, buffers);
  const notes = lossNotes(file.json);
  const placed = placedPrimitives(document);
  const drawn = placed.filter(({ primitive }) => isTriangles(primitive));
  if (placed.length > drawn.length)
    notes.push(`Not carried: ${counted(placed.length - drawn.length, 'primitive')} of points or lines.`);
  checkExpansion(drawn, fileSize);
  const parts = drawn.map((each, index) => readPart(each, index));
  const full = parts.filter((part) => part.position.length > 0 && part.triangles.length > 0);
  if (full.length === 0) throw new FormatError('no_triangles', 'The scene of the file has no triangles.');
  const odd = full.reduce((sum, { leftOver }) => sum + leftOver, 0);
  if (odd > 0) notes.push(`Not carried: ${counted(odd, 'corner')} after the last whole triangle.`);
  const lost = new Set(full.flatMap((part) => part.lost));
  if (lost.size > 0) notes.push(`Not carried: the attributes ${listed([...lost])}.`);
  const { variables, labels } = joinAttributes(
    full.map((part) => part.attributes),
    notes,
  );
  const surface = weldedSurface({ ...joinShapes(full), variables }, notes);
  const { unit, componentNames } = full[0].labels;
  if (unit) labels.units.position = unit;
  if (componentNames?.length === 3) labels.componentNames.position = componentNames;
  return { ...surface, ...labels };
}

/** glTF-Transform does not expect hostile files: what it throws at them is an error of the file. */
async function readDocument(json: GltfJson, buffers: Uint8Array[]): Promise<Document> {
  const resources = Object.fromEntries(
    buffers.map((bytes, index) => [resourceName(index), bytes as Uint8Array<ArrayBuffer>]),
  );
  try {
    const plain = geometryOnly(json) as unknown as JSONDocument['json'];
    return await new WebIO().setLogger(new Logger(Logger.Verbosity.SILENT)).readJSON({ json: plain, resources });
  } catch (error) {
    throw new FormatError(
      'bad_header',
      `The JSON of the file does not follow glTF 2.0 (${foreign((error as Error).message)}).`,
    );
  }
}

/** What glTF-Transform knows a buffer by, wherever its bytes came from. */
function resourceName(index: number): string {
  return `buffer-${index}`;
}

/** The JSON without all that does not concern the surface and could name other files. */
function geometryOnly({ buffers, bufferViews, accessors, meshes, nodes, scenes, scene }: GltfJson): GltfJson {
  const plainBuffers = buffers?.map(({ byteLength }, index) => ({ byteLength, uri: resourceName(index) }));
  const plainMeshes = meshes?.map(({ primitives }) => ({
    primitives: primitives?.map(({ attributes, indices, mode }) => ({
      attributes: withSafeNames(attributes ?? {}),
      indices,
      mode,
    })),
  }));
  const plainNodes = nodes?.map((node) => ({ ...node, skin: undefined, camera: undefined, extensions: undefined }));
  const plain = {
    bufferViews,
    accessors,
    nodes: plainNodes,
    scenes,
    scene,
    buffers: plainBuffers,
    meshes: plainMeshes,
  };
  return JSON.parse(JSON.stringify({ ...plain, asset: { version: '2.0' } })) as GltfJson;
}

function lossNotes(json: GltfJson): string[] {
  const kinds = ['materials', 'textures', 'animations', 'skins', 'cameras'];
  const lost = kinds.filter((kind) => Array.isArray(json[kind]) && json[kind].length > 0);
  const primitives = (json.meshes ?? []).flatMap((mesh) => mesh.primitives ?? []);
  if (primitives.some(({ targets }) => targets && targets.length > 0)) lost.push('morph targets');
  const notes = lost.length > 0 ? [`Not carried: ${lost.join(', ')}.`] : [];
  const extensions = (json.extensionsUsed ?? []).filter((name) => name !== 'KHR_mesh_quantization');
  return extensions.length > 0 ? [...notes, `Extensions passed over: ${listed(extensions)}.`] : notes;
}

/** What the default scene shows, or the first one; all meshes as they are if there is no scene. */
function placedPrimitives(document: Document): Placed[] {
  const root = document.getRoot();
  const scene = root.getDefaultScene() ?? root.listScenes()[0];
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  if (!scene)
    return root
      .listMeshes()
      .flatMap((mesh) => mesh.listPrimitives().map((primitive) => ({ primitive, matrix: identity })));
  const placed: Placed[] = [];
  scene.traverse((node: Node) => {
    const matrix = node.getWorldMatrix();
    for (const primitive of node.getMesh()?.listPrimitives() ?? []) placed.push({ primitive, matrix });
  });
  return placed;
}

function isTriangles(primitive: Primitive): boolean {
  return Object.values(modes).includes(primitive.getMode());
}

/** Many nodes may show one mesh; a small file must not become a large mesh that way. */
function checkExpansion(placed: Placed[], fileSize: number): void {
  const bytesOf = (accessor: Accessor | null) => (accessor ? 4 * accessor.getCount() * accessor.getElementSize() : 0);
  const sizes = placed.map(({ primitive }) =>
    [...primitive.listAttributes(), primitive.getIndices()].reduce((sum, accessor) => sum + bytesOf(accessor), 0),
  );
  if (sizes.reduce((sum, size) => sum + size, 0) <= expansionLimit(fileSize)) return;
  throw new FormatError('too_large', 'The nodes repeat their meshes far more often than a file of this size should.');
}

function readPart({ primitive, matrix }: Placed, index: number): Part {
  const where = `primitive ${index}`;
  const accessor = primitive.getAttribute(safeName('POSITION'));
  if (accessor?.getElementSize() !== 3) throw new FormatError('no_points', `The ${where} has no POSITION.`, where);
  const position = numbersOf(accessor);
  const { attributes, lost } = namedAttributes(primitive, where, position.length / 3, numbersOf);
  const corners = cornersOf(primitive, position.length / 3);
  checkIndices(corners, position.length / 3, where);
  const triangles = trianglesOf(corners, primitive.getMode());
  const leftOver = primitive.getMode() === modes.triangles ? corners.length - triangles.length : 0;
  return place({ position, attributes, triangles, labels: extrasOf(accessor), lost, leftOver }, matrix);
}

/** The numbers of an accessor; glTF-Transform turns normalised integers back into what they mean. */
function numbersOf(accessor: Accessor): Float32Array {
  const array = accessor.getArray();
  if (array instanceof Float32Array) return array;
  const size = accessor.getElementSize();
  const numbers = new Float32Array(accessor.getCount() * size);
  const element: number[] = [];
  for (let i = 0; i < accessor.getCount(); i++) numbers.set(accessor.getElement(i, element).slice(0, size), i * size);
  return numbers;
}

function cornersOf(primitive: Primitive, points: number): Uint32Array {
  const array = primitive.getIndices()?.getArray();
  return array ? Uint32Array.from(array) : new Uint32Array(points).map((_, point) => point);
}

function trianglesOf(corners: Uint32Array, mode: number): Uint32Array {
  if (mode === modes.triangles) return corners.slice(0, corners.length - (corners.length % 3));
  const list = new Uint32Array(3 * Math.max(0, corners.length - 2));
  for (let i = 0; 3 * i < list.length; i++) {
    const turned = mode === modes.strip ? i % 2 : 0;
    const first = mode === modes.fan ? corners[0] : corners[i];
    list.set([first, corners[i + 1 + turned], corners[i + 2 - turned]], 3 * i);
  }
  return list;
}

/** Moves a part to where its node puts it; a reflection turns its triangles round, so that outside stays outside. */
function place(part: Part, m: number[]): Part {
  const moves = m.some((value, i) => value !== (i % 5 === 0 ? 1 : 0));
  if (!moves) return part;
  const position = Float64Array.from(part.position);
  for (let at = 0; at < position.length; at += 3) {
    const [x, y, z] = part.position.subarray(at, at + 3);
    for (let row = 0; row < 3; row++) position[at + row] = m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row];
  }
  const cofactors = cofactorsOf(m);
  const determinant = m[0] * cofactors[0] + m[4] * cofactors[3] + m[8] * cofactors[6];
  const attributes = part.attributes.map((attribute) =>
    attribute.semantic === 'NORMAL'
      ? { ...attribute, values: turnNormals(attribute.values, cofactors, Math.sign(determinant)) }
      : attribute,
  );
  const corners = part.triangles.slice();
  if (determinant < 0) for (let at = 0; at < corners.length; at += 3) corners.subarray(at, at + 3).reverse();
  return { ...part, position, attributes, triangles: corners };
}

/** Of the upper left 3 × 3 of a matrix, column by column: they turn normals as the matrix turns the surface. */
function cofactorsOf(m: number[]): number[] {
  const columns = [0, 4, 8];
  return columns.flatMap((_, i) => {
    const [a, b] = [columns[(i + 1) % 3], columns[(i + 2) % 3]];
    return [0, 1, 2].map((row) => {
      const [r, s] = [(row + 1) % 3, (row + 2) % 3];
      return m[a + r] * m[b + s] - m[a + s] * m[b + r];
    });
  });
}

function turnNormals(normals: GltfAttribute['values'], cofactors: number[], sign: number): GltfAttribute['values'] {
  const turned = normals.slice();
  for (let at = 0; at < normals.length; at += 3) {
    const [x, y, z] = normals.subarray(at, at + 3);
    const normal = [0, 1, 2].map(
      (row) => sign * (cofactors[row] * x + cofactors[3 + row] * y + cofactors[6 + row] * z),
    );
    const length = Math.hypot(...normal);
    if (length > 0)
      turned.set(
        normal.map((part) => part / length),
        at,
      );
  }
  return turned;
}

function joinShapes(parts: Part[]): Pick<Mesh, 'position' | 'triangles'> {
  let points = 0;
  const triangles = parts.map((part) => {
    const shift = points;
    points += part.position.length / 3;
    return part.triangles.map((corner) => corner + shift);
  });
  return { position: joinPlaces(parts.map((part) => part.position)), triangles: joined(triangles, Uint32Array) };
}

/**
 * Places that a node moved are doubles. Where several nodes move their parts, rounding differs from part to part, and points
 * where parts meet would not be found to be one; so all are in single precision then, as seen from near the surface.
 */
function joinPlaces(parts: Part['position'][]): Mesh['position'] {
  if (parts.every((part) => part instanceof Float32Array)) return joined(parts, Float32Array);
  const position = joined(parts, Float64Array);
  if (parts.length === 1) return asFloatingPoint(position);
  const triangles = Uint32Array.from({ length: position.length / 3 }, (_, point) => point);
  const origin = localOrigin({ position, triangles });
  return asFloatingPoint(position.map((value, i) => origin[i % 3] + Math.fround(value - origin[i % 3])));
}
