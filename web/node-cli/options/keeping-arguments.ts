import type { Box } from '../../../wasm/index.ts';
import { withoutRegionNotes } from '../../formats/regions/region-notes.ts';
import { listed, quoted } from '../../formats/text/wording.ts';
import { boxText, readBox } from '../../session/constraints/box-text.ts';
import { type PointRange, pointsOf, readPoints } from '../../session/constraints/point-list.ts';
import { messageOf } from '../../session/reading/failure.ts';
import { Fault, UsageFault } from '../fault.ts';
import type { OpenedSurface } from '../files/surface-files.ts';

/** What a command line wants to stay, and where it wants finer bounds. */
export interface Keeping {
  /** The cell-data array whose values part the surface into regions. */
  region: string | undefined;
  boundMultiplier: string | undefined;
  /** Whether parts smaller than the bound of position go. */
  dropSmallComponents: boolean;
  points: PointRange[];
  /** Their numbers, or what they are called. */
  regionsToLock: (number | string)[];
  lockedBoxes: Box[];
}

/** The points of a list, `3,17,20-40`. Throws a UsageFault. */
export function parsePoints(list: string): PointRange[] {
  try {
    return readPoints(list);
  } catch (error) {
    throw new UsageFault(`--lock-points ${quoted(list)} cannot be: ${messageOf(error)}`);
  }
}

/** The number of a region, or else its name. */
export function parseRegion(text: string): number | string {
  const label = Number(text);
  return text.trim() !== '' && Number.isInteger(label) && Math.abs(label) < 2 ** 31 ? label : text;
}

/** A box, `0,0,0,1,1,1`. Throws a UsageFault. */
export function parseBox(text: string): Box {
  try {
    return readBox(text);
  } catch (error) {
    throw new UsageFault(`--lock-box ${quoted(text)} cannot be: ${messageOf(error)}`);
  }
}

/** The one variable that multiplies the bounds, if any. Throws a UsageFault for several. */
export function parseBoundMultiplier(names: string[]): string | undefined {
  if (names.length > 1)
    throw new UsageFault(`--bound-multiplier was given ${listed(names)}; one variable multiplies the bounds.`);
  return names.at(0);
}

/** Throws a Fault for a multiplier that the surface has not. */
export function requireBoundMultiplier(
  { boundMultiplier }: Keeping,
  { path, mesh }: { path: string; mesh: { variables: { name: string }[] } },
): void {
  if (boundMultiplier === undefined || mesh.variables.some(({ name }) => name === boundMultiplier)) return;
  throw new Fault(`${path}: there is no variable ${quoted(boundMultiplier)} to multiply the bounds.`);
}

/**
 * What the core is to keep: what the surface itself needs, and what the command line adds. Throws a Fault for a point or the
 * name of a region that the surface has not.
 */
export function settingsOf({ points, region, regionsToLock, ...settings }: Keeping, surface: OpenedSurface) {
  const { path, mesh, locked = new Uint32Array() } = surface;
  const added = lockedPoints(points, path, mesh.position.length / 3);
  const all = new Uint32Array(locked.length + added.length);
  all.set(locked);
  all.set(added, locked.length);
  const lockedRegions = Int32Array.from(regionsToLock, (each) => labelOf(each, surface));
  return { ...settings, locked: all, lockedRegions };
}

function labelOf(wanted: number | string, { path, regionName = '', regionNames }: OpenedSurface): number {
  if (typeof wanted === 'number') return wanted;
  const names = [...(regionNames?.get(regionName) ?? [])];
  const found = names.find(([, name]) => name === wanted);
  if (found) return found[0];
  const known = names.length > 0 ? `they are ${listed(names.map(([, name]) => name))}` : 'they are numbers';
  throw new Fault(`${path}: there is no region ${quoted(wanted)} in ${quoted(regionName)}; ${known}.`);
}

function lockedPoints(ranges: readonly PointRange[], path: string, count: number): number[] {
  try {
    return pointsOf(ranges, count);
  } catch (error) {
    throw new Fault(`${path}: ${messageOf(error)}`);
  }
}

/** A sentence for each box that meets no triangle, so that it locks nothing. */
export function unmetBoxNotes(boxes: readonly Box[], unmet: readonly number[]): string[] {
  return unmet.map((index) => `--lock-box=${boxText(boxes[index])} meets no triangle: nothing stays because of it.`);
}

/**
 * The surface with the labels of a cell-data array as its regions, if one is asked for. Its notes say which others could be.
 * Throws a Fault where it has no such array.
 */
export function withRegions<Labelled extends OpenedSurface>({ region }: Keeping, surface: Labelled): Labelled {
  const names = [...(surface.regions?.keys() ?? [])];
  const notes = [
    ...withoutRegionNotes(surface.notes, surface.regions),
    ...unusedNotes(names.filter((name) => name !== region)),
  ];
  if (region === undefined) return { ...surface, notes };
  const regions = surface.regions?.get(region);
  if (regions) return { ...surface, mesh: { ...surface.mesh, regions }, regionName: region, notes };
  const misfit = surface.unfitRegions?.get(region);
  if (misfit !== undefined) {
    throw new Fault(
      `${surface.path}: the cell data ${quoted(region)} cannot part the surface into regions: ${misfit}.`,
    );
  }
  const known = names.length > 0 ? `those of whole numbers are ${listed(names)}` : 'it has none of whole numbers';
  throw new Fault(`${surface.path}: there is no cell data ${quoted(region)} to part it into regions; ${known}.`);
}

function unusedNotes(names: string[]): string[] {
  if (names.length === 0) return [];
  return [`Not carried unless it parts the surface into regions (--region): cell data ${listed(names)}.`];
}
