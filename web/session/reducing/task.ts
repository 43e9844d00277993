import type { Levels, Mesh, MorphEnd, ReduceOptions, Reduction, Variable } from '../../../wasm/types.ts';
import { listed } from '../../formats/text/wording.ts';
import type { Multiplied } from '../../probe/multiplied.ts';
import { multiplierNear } from '../../surface/nearness.ts';
import type { Keeping } from '../constraints/keeping.ts';
import type { Method } from '../constraints/method.ts';
import { pointsOf } from '../constraints/point-list.ts';
import type { OpenSurface } from '../reading/open-surface.ts';

/** What the core is given but for bounds, and what it takes to understand its answer. */
export interface Task {
  mesh: Mesh;
  options: Omit<ReduceOptions, 'bounds'>;
  /** What multiplies the bounds at each vertex. */
  multiplier?: Variable['values'];
  /** The last variable of the mesh is that multiplier, and none of the surface. */
  added: boolean;
}

/** Throws an Error with a `code` where the surface has not what is asked for. */
export function taskOf(surface: OpenSurface, method: Method, keeping: Keeping): Task {
  const { lockBox, lockRegions } = keeping;
  const options = {
    ...method,
    locked: withPoints(surface, keeping),
    lockedBoxes: lockBox ? [lockBox] : [],
    lockedRegions: Int32Array.from(lockRegions),
  };
  return withMultiplier(withRegions(surface, keeping), options, keeping);
}

/** What the surface itself needs to stay, and what is asked for. */
function withPoints({ locked = new Uint32Array(), mesh }: OpenSurface, { lockPoints }: Keeping): Uint32Array {
  if (lockPoints.length === 0) return locked;
  return Uint32Array.from([...locked, ...pointsOf(lockPoints, mesh.position.length / 3)]);
}

function withRegions({ mesh, regions }: OpenSurface, { regions: name }: Keeping): Mesh {
  if (name === null) return mesh;
  const labels = regions?.get(name);
  if (labels) return { ...mesh, regions: labels };
  const known = regions?.size ? `those of whole numbers are ${listed([...regions.keys()])}` : 'it has none';
  const text = `The surface has no cell data ${listed([name])} to part it into regions; ${known}.`;
  throw Object.assign(new Error(text), { code: 'unknown_regions' });
}

function withMultiplier(mesh: Mesh, options: Task['options'], { boundMultiplier, focusPoint }: Keeping): Task {
  const variable = mesh.variables.find(({ name }) => name === boundMultiplier);
  // What cannot multiply is the core's to refuse.
  if (!focusPoint || (boundMultiplier !== null && variable?.components !== 1)) {
    return boundMultiplier === null
      ? { mesh, options, added: false }
      : { mesh, options: { ...options, boundMultiplier }, multiplier: variable?.values, added: false };
  }
  const near = multiplierNear(mesh, focusPoint);
  const multiplier = variable ? near.map((each, vertex) => each * variable.values[vertex]) : near;
  const name = freeName(mesh, boundMultiplier ?? 'focus');
  const variables = [...mesh.variables, { name, components: 1, values: multiplier }];
  return { mesh: { ...mesh, variables }, options: { ...options, boundMultiplier: name }, multiplier, added: true };
}

function freeName({ variables }: Mesh, name: string): string {
  return variables.some((variable) => variable.name === name) ? freeName({ variables } as Mesh, `${name} `) : name;
}

/** What the core reduced, of the surface's own variables, with what multiplied the bounds. */
export function resultOf({ multiplier, added }: Task, result: Reduction): Multiplied {
  if (!multiplier) return result;
  if (!added) return { ...result, multiplier };
  return {
    ...result,
    multiplier,
    mesh: withoutLast(result.mesh),
    triangleErrors: result.triangleErrors.slice(0, -1),
    vertexErrors: result.vertexErrors?.slice(0, -1),
    report: withoutLast(result.report),
  };
}

/** The same of levels of detail. */
export function levelsOf(task: Task, { levels, morphs }: Levels): Levels {
  const own = <End extends MorphEnd>(end: End) => (task.added ? withoutLast(end) : end);
  return {
    levels: levels.map((level) => resultOf(task, level)),
    morphs: morphs.map((morph) => ({ ...morph, finer: own(morph.finer), coarser: own(morph.coarser) })),
  };
}

function withoutLast<Whole extends { variables: unknown[] }>(whole: Whole): Whole {
  return { ...whole, variables: whole.variables.slice(0, -1) };
}
