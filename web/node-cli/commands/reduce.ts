import {
  type Mesh,
  type ReduceOptions,
  type Reduction,
  type Report,
  reduceLevels,
  reduce as reduceMesh,
} from '../../../wasm/index.ts';
import { originIn } from '../../formats/file-rounding.ts';
import type { Labels } from '../../formats/surface.ts';
import { listed } from '../../formats/text/wording.ts';
import { labelsWithMap, takenMapNames, triangleName, withMap } from '../../formats/variables/map-variables.ts';
import { requireHeld } from '../../formats/write.ts';
import { boundsForFile, leastMultiplier, reducedWithin } from '../../session/bounds/bounds-for-file.ts';
import { defectNotes, droppedNotes, featureNotes, nearPartsNotes } from '../../session/report/defect-notes.ts';
import { reportJson, type Seams } from '../../session/report/report-json.ts';
import { havePartsWithin } from '../../surface/near-parts.ts';
import type { Command } from '../command.ts';
import { exitStatus } from '../exit-status.ts';
import { Fault, faultOf } from '../fault.ts';
import { requireWritable, StagedFiles } from '../files/staged-files.ts';
import {
  encodeSurface,
  named,
  type OpenedSurface,
  openSurface,
  outputFormat,
  requirePlaceFor,
} from '../files/surface-files.ts';
import { type FileNotes, writeLevelFiles } from '../files/write-level-files.ts';
import { interruptible } from '../interruption.ts';
import { requireKnownBounds, unnamed } from '../options/bound-arguments.ts';
import { without } from '../options/exclude.ts';
import { requireBoundMultiplier, settingsOf, unmetBoxNotes, withRegions } from '../options/keeping-arguments.ts';
import { help, parseRequest, type Request } from '../options/reduce-arguments.ts';
import { levelsJson, levelsText } from '../output/level-report.ts';
import { sayNotes } from '../output/notes.ts';
import { ProgressBar } from '../output/progress-bar.ts';
import type { RegionNames } from '../output/region-text.ts';
import { freeNotes, reportText } from '../output/report.ts';

async function openInput({
  input,
  variables: csv,
  weld,
  exclude,
  options,
  keeping,
  map,
}: Request): Promise<OpenedSurface> {
  const surface = withRegions(keeping, without(exclude, await openSurface(input, csv, { weld })));
  requireKnownBounds(options.bounds, surface);
  requireBoundMultiplier(keeping, surface);
  if (map) {
    requireMapNames(surface);
    await requirePlaceFor(triangleName, map);
  }
  return surface;
}

/** Throws a Fault where the names that the map needs are taken by variables of the surface. */
function requireMapNames({ path, mesh }: OpenedSurface): void {
  const taken = takenMapNames(mesh);
  if (taken.length > 0) throw new Fault(`${path}: --map needs the names of the variables ${listed(taken)} for itself.`);
}

/** Calls the core as the command line asks for, and shows the progress. */
async function callCore<Result>(
  surface: OpenedSurface,
  { options, keeping, quiet }: Request,
  signal: AbortSignal,
  call: (settings: Omit<ReduceOptions, 'bounds'>) => Promise<Result>,
): Promise<Result> {
  const bar = process.stderr.isTTY && !quiet ? new ProgressBar(process.stderr) : undefined;
  try {
    return await call({
      errors: options.errors,
      cost: options.cost === 'maximum' ? 'maximum' : 'introduced',
      refusePiercing: options.refusePiercing,
      limitToFeatureSize: options.limitToFeatureSize,
      ...settingsOf(keeping, surface),
      signal,
      onProgress: (progress) => bar?.show(progress),
    });
  } catch (error) {
    throw faultOf(surface.path, error);
  } finally {
    bar?.clear();
  }
}

function seamsOf({ seamPoints = 0, locked }: OpenedSurface): Seams {
  return { points: seamPoints, touching: locked?.length ?? 0 };
}

function namesOf({ regionNames, regionName }: OpenedSurface): RegionNames | undefined {
  return regionName === undefined ? undefined : regionNames?.get(regionName);
}

/** What there is to say when all files are written. */
interface Outcome {
  report: Report;
  /** The largest bound of position that any result has. */
  positionBound: number;
  /** What each file does not hold. */
  notes: FileNotes[];
  text: string;
}

/** Writes what was asked for. */
async function writeResult(files: StagedFiles, request: Request, surface: OpenedSurface, reduction: Reduction) {
  const { output, map, report, options } = request;
  const surfaces: [string, Mesh, Labels][] = [[output, reduction.mesh, surface]];
  if (map) surfaces.push([map, withMap(surface.mesh, reduction), labelsWithMap(surface)]);
  const notes: FileNotes[] = [];
  for (const [path, mesh, labels] of surfaces) {
    const { bytes, losses } = await encodeSurface(path, mesh, labels);
    await files.write(path, bytes);
    notes.push([path, losses]);
  }
  if (report)
    await files.write(
      report,
      reportJson(reduction.report, options, { seams: seamsOf(surface), names: namesOf(surface) }),
    );
  const { bound: positionBound } = reduction.report.variables[0];
  return {
    report: reduction.report,
    positionBound,
    notes,
    text: reportText(reduction.report, options, namesOf(surface)),
  };
}

/** The same for levels of detail. */
async function writeLevels(
  files: StagedFiles,
  { outputs, report, options, levels = [] }: Request,
  surface: OpenedSurface,
  levelResults: Reduction[],
) {
  const notes = await writeLevelFiles(files, outputs, levelResults, surface);
  const reports = levelResults.map((level, i) => ({
    file: outputs[i] ?? outputs[0],
    bounds: levels[i],
    report: level.report,
  }));
  if (report) await files.write(report, levelsJson(reports, options, seamsOf(surface), namesOf(surface)));
  const positionBound = Math.max(...reports.map(({ report: { variables } }) => variables[0].bound));
  return { report: reports[0].report, positionBound, notes, text: levelsText(reports, namesOf(surface)) };
}

async function reduceAndWrite(
  files: StagedFiles,
  request: Request,
  surface: OpenedSurface,
  signal: AbortSignal,
): Promise<Outcome> {
  const { levels, options, keeping, output } = request;
  const { mesh } = surface;
  const format = outputFormat(output);
  // A part of every bound is the format's: what is guaranteed is guaranteed of the file.
  const least = leastMultiplier(mesh, keeping.boundMultiplier);
  const parts = await named(output, async () => {
    await requireHeld(format, mesh, surface);
    return (levels ?? [options.bounds]).map((bounds) => boundsForFile(format, mesh, bounds, least, surface));
  });
  const reduced = await named(output, () =>
    reducedWithin(format, parts, least, (bounds) =>
      callCore(surface, request, signal, async (settings) => {
        if (!levels) return [await reduceMesh(mesh, { ...settings, bounds: bounds[0] })];
        return (await reduceLevels(mesh, { ...settings, levels: bounds })).levels;
      }),
    ),
  );
  const placed = { ...surface, origin: originIn(format, mesh) };
  return levels ? writeLevels(files, request, placed, reduced) : writeResult(files, request, placed, reduced[0]);
}

/** Whether nothing that was asked for keeps near parts from piercing each other. */
function mayPierce({ refusePiercing, limitToFeatureSize }: Request['options']): boolean {
  return !refusePiercing && !limitToFeatureSize;
}

async function run(args: string[]): Promise<number> {
  const request = parseRequest(args);
  const { outputs, map, report, options, quiet } = request;
  await requireWritable([...outputs, map, report].filter((path) => path !== undefined));
  const surface = await openInput(request);
  const outcome = await interruptible((signal) =>
    StagedFiles.complete(signal, (files) => reduceAndWrite(files, request, surface, signal)),
  );
  if (!quiet) {
    if (options.cost === 'maximum' && options.errors === 'tracked') {
      console.error('--cost has an effect with --errors propagated only.');
    }
    const { defects, dropped, featureSize, unusedLockedBoxes } = outcome.report;
    const free = freeNotes(unnamed(options.bounds, surface.mesh));
    sayNotes(surface.path, [
      ...surface.notes,
      ...defectNotes(defects),
      ...droppedNotes(dropped),
      ...featureNotes(featureSize),
      ...nearPartsNotes(mayPierce(options) && havePartsWithin(surface.mesh, outcome.positionBound)),
      ...unmetBoxNotes(options.lockBoxes, unusedLockedBoxes),
      ...free,
    ]);
    for (const [path, losses] of outcome.notes) sayNotes(path, losses);
    console.log(outcome.text);
  }
  return exitStatus.done;
}

export const reduce: Command = { help, run };
