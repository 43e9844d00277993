import type { Inspection, Mesh, VariableExtent } from '../../wasm/index.ts';
import type { NamedFile } from '../formats/read-together.ts';
import { choosableRegionNotes } from '../formats/region-notes.ts';
import type { Labels } from '../formats/surface.ts';
import { listed } from '../formats/wording.ts';
import type { Multiplied } from '../probe/multiplied.ts';
import {
  asBounds,
  type BoundSetting,
  type BoundSettings,
  defaultBounds,
  moveAll,
  settingsFrom,
} from './bound-setting.ts';
import type { Bounds } from './bound-text.ts';
import { codeOf, messageOf, nonFiniteVariable } from './failure.ts';
import { changed, type History, historyOf, redone, settled, undone } from './history.ts';
import { type Keeping, nothingKept, sameKeeping } from './keeping.ts';
import { Latest, superseded } from './latest.ts';
import { firstMethod, type Method, sameMethod } from './method.ts';
import { oddityNotes } from './oddity-notes.ts';
import type { OpenedFile } from './read.ts';
import type { Services } from './services.ts';
import { resultOf, taskOf } from './task.ts';
import { canGoOnward, Waypoints } from './waypoints.ts';

/** Where a surface comes from. */
interface Source {
  /** For people: the name of the file. */
  name: string;
  /** The address that it was loaded from; null for a file of the user. */
  address: string | null;
}

/** A surface that passed validation. */
export interface OpenSurface extends Source {
  mesh: Mesh;
  /** Units and names of components, where the file states them. */
  labels: Labels;
  /** Position first, then the mesh's variables in their order. */
  variables: VariableExtent[];
  /** Vertices that must stay, because sheets only touch there. */
  locked: Uint32Array | undefined;
  /** Labels of the triangles, by the cell data that hold them. */
  regions?: ReadonlyMap<string, Int32Array>;
}

/** A file that is being opened. */
export interface Opening {
  name: string;
  /** Fetched, read, or checked by the core. */
  phase: 'download' | 'read' | 'check';
  /** Of this phase, 0…1. */
  progress: number;
}

/** A result with what it was asked with. */
export interface Reduced {
  result: Multiplied;
  bounds: BoundSettings;
  method: Method;
  keeping: Keeping;
}

/** Something to tell the user, until dismissed. */
export interface Notice {
  id: number;
  kind: 'error' | 'note';
  text: string;
  /** Of an error: what is wrong, for programs. */
  code?: string;
  /** It is not about the file, and stays when another one is opened. */
  lasting?: boolean;
  /** It is about the last reduction, and goes when the next one starts. */
  ofReduction?: boolean;
  /** It tells of what can part the surface into regions, and goes when that is chosen. */
  ofRegions?: boolean;
  /** A way out that the user may take. */
  remedy?: { label: string; take: () => void };
}

/** Never changed in place: a change replaces it. */
export interface SessionState {
  opening: Opening | null;
  surface: OpenSurface | null;
  bounds: BoundSettings;
  /** Whether a change of the bounds can be undone, and done again. */
  canUndo: boolean;
  canRedo: boolean;
  method: Method;
  keeping: Keeping;
  /** Of the running reduction, 0…1; null where none runs. */
  progress: number | null;
  /** The user stopped the last reduction: a result is that of the one before. */
  cancelled: boolean;
  /** The last good reduction of this surface: of earlier bounds where another one runs. */
  reduced: Reduced | null;
  /**
   * While bounds move and until the reduction is there: an answer from a waypoint, which keeps its bounds, but is not the one
   * that counts. Null where there is none, and always where nothing runs.
   */
  provisional: Reduced | null;
  notices: readonly Notice[];
}

/** What is to be seen of a session: the answer at hand. */
export function answerOf({ provisional, reduced }: SessionState): Reduced | null {
  return provisional ?? reduced;
}

/**
 * A slider that is being dragged sends many changes. Until it rests this long, in milliseconds, they are answered from a
 * waypoint; where there is none, a reduction that runs goes on meanwhile, though of earlier bounds, and shows the way. Then
 * the reduction with the last of them starts.
 */
const restBeforeReducing = 60;

const emptyState: SessionState = {
  opening: null,
  surface: null,
  bounds: {},
  canUndo: false,
  canRedo: false,
  method: firstMethod,
  keeping: nothingKept,
  progress: null,
  cancelled: false,
  reduced: null,
  provisional: null,
  notices: [],
};

/**
 * What is open, what is asked of it and what came of it. Emits `change` whenever its state changes. A fault leaves the
 * last good state as it was and adds a notice.
 */
export class Session extends EventTarget {
  #services: Services;
  #opening = new Latest();
  #reducing = new Latest();
  #drafting = new Latest();
  #waypoints = new Waypoints();
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** The bounds have changed since the reduction that runs began. */
  #isStale = false;
  #lastNotice = 0;
  #wanted: Bounds | null = null;
  #history = historyOf<BoundSettings>({});
  /** What all bounds are moved in proportion to: moving the rounded bounds on and on would change their proportions. */
  #mix: BoundSettings = {};
  #state = emptyState;

  constructor(services: Services) {
    super();
    this.#services = services;
  }

  get state(): SessionState {
    return this.#state;
  }

  /** `beside` are files chosen together with it: variables in CSV, what a glTF file refers to. */
  openFile(file: File, beside: readonly File[] = []): Promise<void> {
    const others = () => Promise.all(beside.map(async (other) => ({ name: other.name, bytes: await bytesOf(other) })));
    return this.#open({ name: file.name, address: null }, (signal) =>
      this.#read(file.name, () => bytesOf(file), signal, others),
    );
  }

  openAddress(address: string): Promise<void> {
    const name = nameIn(address);
    return this.#open({ name, address }, (signal) => {
      const onProgress = (progress: number) => {
        if (!signal.aborted) this.#update({ opening: { name, phase: 'download', progress } });
      };
      onProgress(0);
      return this.#read(name, () => this.#services.fetchBytes(address, { signal, onProgress }), signal);
    });
  }

  /**
   * Bounds for the surface that is open and for all that are opened after it; null for those that surfaces begin with.
   *
   * @param later leaves the surface that is open as it is
   */
  wantBounds(bounds: Bounds | null, { later = false } = {}): void {
    this.#wanted = bounds;
    if (!later && this.#state.surface) this.#setBounds(this.#firstBounds(this.#state.surface.variables));
  }

  setBound(variable: string, setting: BoundSetting): void {
    this.#setBounds({ ...this.#state.bounds, [variable]: setting }, variable);
  }

  /** Multiplies all bounds so that the largest becomes `fraction`. */
  setAllBounds(fraction: number): void {
    const mix = this.#mix;
    this.#setBounds(moveAll(mix, fraction), '*');
    this.#mix = mix;
  }

  setBounds(bounds: Bounds): void {
    if (this.#state.surface) this.#setBounds(settingsFrom(bounds, this.#state.surface.variables));
  }

  /** The change of a bound has come to rest: the next one is another step to undo. */
  settleBounds(): void {
    this.#history = settled(this.#history);
  }

  undo(): void {
    this.#goTo(undone(this.#history));
  }

  redo(): void {
    this.#goTo(redone(this.#history));
  }

  setMethod(method: Method): void {
    if (sameMethod(method, this.#state.method)) return;
    this.#update({ method });
    this.reduceAgain();
  }

  /** What of the surface is to be kept from now on. A surface that is being opened takes it into account. */
  setKeeping(keeping: Keeping): void {
    const { keeping: before, surface, notices } = this.#state;
    if (sameKeeping(keeping, before)) return;
    const isParted = surface?.regions?.has(keeping.regions ?? '');
    this.#update({ keeping, notices: notices.filter(({ ofRegions }) => !(ofRegions && isParted)) });
    if (!this.#state.opening) this.reduceAgain();
  }

  /** Starts the reduction anew; one that runs is aborted. */
  reduceAgain(): void {
    if (!this.#state.surface) return;
    this.#update({ progress: 0, cancelled: false });
    void this.#reduce();
  }

  /** Stops what is opened, or else the running reduction. The last surface and result, if there are, stay. */
  cancel(): void {
    if (this.#state.opening) {
      this.#opening.abort();
      this.#stay();
    } else if (this.#state.progress !== null) {
      this.#stopReducing();
      this.#update({ progress: null, cancelled: true, provisional: null });
    }
  }

  /** Stops everything that runs. Nobody is there any more to see a change; who waits for an answer is told by `stop`. */
  stop(): void {
    this.#opening.abort();
    this.#stopReducing();
    this.#state = { ...this.#state, opening: null, progress: null, provisional: null };
    this.dispatchEvent(new Event('stop'));
  }

  /** Tells the user of a fault; a lasting one is not about the file that is open. */
  report(error: unknown, { lasting = false } = {}): void {
    this.#notify({ kind: 'error', code: codeOf(error), text: messageOf(error), lasting });
  }

  /** Tells the user something worth knowing of what is open. */
  tell(text: string): void {
    this.#notify({ kind: 'note', text });
  }

  dismiss(id: number): void {
    this.#update({ notices: this.#state.notices.filter((notice) => notice.id !== id) });
  }

  #stopReducing(): void {
    clearTimeout(this.#timer);
    this.#isStale = false;
    this.#reducing.abort();
    this.#drafting.abort();
  }

  async #read(
    name: string,
    bytes: () => Promise<Uint8Array<ArrayBuffer>>,
    signal: AbortSignal,
    beside: () => Promise<NamedFile[]> = async () => [],
  ): Promise<OpenedFile> {
    const [content, others] = await Promise.all([bytes(), beside()]);
    signal.throwIfAborted();
    this.#update({ opening: { name, phase: 'read', progress: 0 } });
    return this.#services.read(name, content, { signal }, others);
  }

  async #open(source: Source, load: (signal: AbortSignal) => Promise<OpenedFile>): Promise<void> {
    const { name } = source;
    const notices = this.#state.notices.filter(({ lasting }) => lasting);
    this.#update({ opening: { name, phase: 'read', progress: 0 }, notices });
    let file: OpenedFile | undefined;
    try {
      const inspected = await this.#opening.run(async (signal) => {
        file = await load(signal);
        signal.throwIfAborted();
        this.#update({ opening: { name, phase: 'check', progress: 0 } });
        return { file, inspection: await this.#services.inspect(file.mesh, { signal }) };
      });
      if (inspected !== superseded) this.#adopt(source, inspected.file, inspected.inspection);
    } catch (error) {
      this.#stay();
      this.#refuse(source, file, error);
    }
  }

  /** At the surface that is open: nothing else is being opened any more. */
  #stay(): void {
    const { reduced, keeping } = this.#state;
    this.#update({ opening: null });
    if (reduced && !sameKeeping(reduced.keeping, keeping)) this.reduceAgain();
  }

  #adopt(
    source: Source,
    { mesh, labels, notes, locked, regions }: OpenedFile,
    { variables, oddities }: Inspection,
  ): void {
    this.#stopReducing();
    this.#waypoints.clear();
    const surface = { ...source, mesh, labels, variables, locked, regions };
    const bounds = this.#firstBounds(variables);
    this.#history = historyOf(bounds);
    this.#mix = bounds;
    this.#update({
      canUndo: false,
      canRedo: false,
      opening: null,
      surface,
      bounds,
      progress: 0,
      cancelled: false,
      reduced: null,
      provisional: null,
    });
    for (const text of [...notes, ...oddityNotes(oddities)]) this.#notify({ kind: 'note', text });
    const choosable = choosableRegionNotes(regions, this.#state.keeping.regions);
    for (const text of choosable) this.#notify({ kind: 'note', text, ofRegions: true });
    void this.#reduce();
  }

  /** What is wanted, as far as there are such variables. */
  #firstBounds(variables: VariableExtent[]): BoundSettings {
    const names = variables.map(({ name }) => name);
    if (!this.#wanted) return defaultBounds(names);
    const missing = Object.keys(this.#wanted).filter((name) => name !== '*' && !names.includes(name));
    if (missing.length > 0) {
      const text = `There is no variable ${listed(missing)} to bound; the variables are ${listed(names)}.`;
      this.#notify({ kind: 'error', code: 'unknown_variable', text });
    }
    return settingsFrom(this.#wanted, variables);
  }

  /** Says why a file was not opened. A variable that holds no numbers need not stop the rest: leaving it out is offered. */
  #refuse(source: Source, file: OpenedFile | undefined, error: unknown): void {
    const text = `${source.name}: ${messageOf(error)}`;
    const variable = nonFiniteVariable(error);
    const code = codeOf(error);
    if (!file || variable === undefined) {
      this.#notify({ kind: 'error', code, text });
      return;
    }
    const take = () => void this.#open(source, async () => withoutVariable(file, variable));
    this.#notify({ kind: 'error', code, text, remedy: { label: `Leave out “${variable}”`, take } });
  }

  /** @param of what is changed: in a row, changes of one thing are one step to undo */
  #setBounds(bounds: BoundSettings, of: string | null = null): void {
    if (this.#state.surface) this.#goTo(changed(this.#history, bounds, of));
  }

  #goTo(history: History<BoundSettings>): void {
    this.#history = history;
    const { past, present, future } = history;
    this.#mix = present;
    const [canUndo, canRedo] = [past.length > 0, future.length > 0];
    this.#update({ bounds: present, canUndo, canRedo, progress: 0, cancelled: false });
    this.#follow();
  }

  /** Answers bounds that have changed: from a waypoint at once, and from the original when they rest. */
  #follow(): void {
    clearTimeout(this.#timer);
    if (this.#drafting.isRunning) return; // and goes on to these
    if (this.#waypoints.nearest(this.#state)) {
      this.#reducing.abort();
      void this.#draft();
    } else if (this.#reducing.isRunning) {
      this.#isStale = true;
      this.#reduceAtRest();
    } else {
      void this.#reduce();
    }
  }

  #reduceAtRest(): void {
    this.#timer = setTimeout(() => void this.#reduce(), restBeforeReducing);
  }

  /** One answer after the other, each to the newest bounds: those in between are left out. */
  async #draft(): Promise<void> {
    this.#isStale = false;
    let answer: Reduced | null | typeof superseded;
    do {
      answer = await this.#drafting.run((signal) => this.#answerFromWaypoint(signal));
      if (answer === superseded) return;
      if (answer) this.#update({ provisional: answer });
    } while (answer && answer.bounds !== this.#state.bounds);
    this.#reduceAtRest();
  }

  /** Null where no waypoint serves, or where something is wrong: the reduction from the original will say what. */
  async #answerFromWaypoint(signal: AbortSignal): Promise<Reduced | null> {
    const { surface, bounds, method, keeping } = this.#state;
    const waypoint = this.#waypoints.nearest(this.#state);
    if (!surface || !waypoint) return null;
    const { options } = taskOf(surface, method, keeping);
    try {
      const result = await this.#services.reduceOnward(waypoint, { bounds: asBounds(bounds), ...options, signal });
      return { result, bounds, method, keeping };
    } catch {
      return null;
    }
  }

  /** From the original, so that the result does not depend on which way the sliders took. */
  async #reduce(): Promise<void> {
    clearTimeout(this.#timer);
    this.#isStale = false;
    this.#drafting.abort();
    const { surface, bounds, method, keeping } = this.#state;
    if (!surface) return;
    this.#update({ notices: this.#state.notices.filter(({ ofReduction }) => !ofReduction) });
    try {
      const outcome = await this.#reducing.run(async (signal) => {
        const task = taskOf(surface, method, keeping);
        const onProgress = (progress: number) => {
          if (!signal.aborted) this.#update({ progress });
        };
        const waypoint = canGoOnward(this.#state);
        const options = { bounds: asBounds(bounds), ...task.options, waypoint, signal, onProgress };
        return resultOf(task, await this.#services.reduce(task.mesh, options));
      });
      if (outcome === superseded) return;
      const { waypoint, ...result } = outcome;
      const reduced = { result, bounds, method, keeping };
      this.#waypoints.keep(result, waypoint, reduced);
      this.#update({ reduced, provisional: null, progress: this.#isStale ? 0 : null });
    } catch (error) {
      if (!this.#isStale) {
        this.#notify({ kind: 'error', code: codeOf(error), text: messageOf(error), ofReduction: true });
        this.#update({ provisional: null, progress: null });
      }
    }
    if (this.#isStale) this.#follow();
  }

  #update(change: Partial<SessionState>): void {
    this.#state = { ...this.#state, ...change };
    this.dispatchEvent(new Event('change'));
  }

  #notify(notice: Omit<Notice, 'id'>): void {
    this.#update({ notices: [...this.#state.notices, { ...notice, id: ++this.#lastNotice }] });
  }
}

async function bytesOf(file: File): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await file.arrayBuffer());
}

/** What the file at an address is called. */
function nameIn(address: string): string {
  const path = address.replace(/[?#].*$/s, '');
  const name = path.slice(path.lastIndexOf('/') + 1);
  try {
    return decodeURIComponent(name) || address;
  } catch {
    return name;
  }
}

function withoutVariable(file: OpenedFile, variable: string): OpenedFile {
  const variables = file.mesh.variables.filter(({ name }) => name !== variable);
  const notes = [...file.notes, `The variable “${variable}” was left out.`];
  return { ...file, notes, mesh: { ...file.mesh, variables } };
}
