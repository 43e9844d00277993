import { Extension, type Node, type WriterContext } from '@gltf-transform/core';
import type { Mesh } from '../../../wasm/types.ts';
import { gzip } from '../bytes/gzip.ts';
import { withinMemory } from '../bytes/within-memory.ts';
import type { WriteOptions } from '../surface.ts';
import { addNode, emptyDocument, glbOf } from './write-glb.ts';

/** A level of detail and how far it lies from the original. */
export interface GlbLevel {
  mesh: Mesh;
  /** The largest geometric error, as a fraction of the surface's extent; none where it is not known. */
  error?: number;
}

/** Coarser levels of nodes, as the extension MSFT_lod has them: the finest node names the others, finest first. */
class LevelsOfDetail extends Extension {
  static override readonly EXTENSION_NAME = 'MSFT_lod';
  override readonly extensionName = 'MSFT_lod';
  private readonly coarser = new Map<Node, Node[]>();

  set(node: Node, coarser: Node[]): void {
    this.coarser.set(node, coarser);
  }

  override read(): this {
    return this;
  }

  override write({ jsonDoc, nodeIndexMap }: WriterContext): this {
    const indexOf = (node: Node) => nodeIndexMap.get(node) as number;
    for (const [node, coarser] of this.coarser) {
      const written = jsonDoc.json.nodes?.[indexOf(node)];
      if (written) written.extensions = { ...written.extensions, MSFT_lod: { ids: coarser.map(indexOf) } };
    }
    return this;
  }
}

/**
 * Writes nested levels of detail, finest first, as one GLB file with the extension MSFT_lod: programs that know it choose
 * among the levels, all others show the finest. Otherwise as writeGlb does. Where every error is known, MSFT_screencoverage
 * hints at when to switch.
 */
export async function writeGlbLevels(levels: GlbLevel[], options: WriteOptions = {}): Promise<Uint8Array> {
  const document = emptyDocument();
  const [finest, ...coarser] = levels.map(({ mesh }, i) => addNode(document, mesh, options).setName(`LOD${i}`));
  document.createExtension(LevelsOfDetail).set(finest, coarser);
  const coverages = screenCoverages(levels.map(({ error }) => error));
  if (coverages) finest.setExtras({ MSFT_screencoverage: coverages });
  const file = await withinMemory(() => glbOf(document, finest, [LevelsOfDetail]));
  return options.gzip ? gzip(file) : file;
}

/** Lines of the screen for which levels are switched, and how many of them an error may span to go unseen. */
const screenLines = 1080;
const unseen = 1;

/**
 * For each level the share of the screen's area below which the next one serves: there the error of that one is at most one
 * pixel. The last one is never left, so its share is 0. Undefined where an error is not known.
 */
export function screenCoverages(errors: (number | undefined)[]): number[] | undefined {
  const known = errors.filter((error) => error !== undefined);
  if (known.length < errors.length) return undefined;
  return [...known.slice(1).map((error) => Math.min(1, (unseen / (error * screenLines)) ** 2)), 0];
}
