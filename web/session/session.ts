import type { Inspection, VariableExtent } from '../../wasm/index.ts';
import { choosableRegionNotes } from '../formats/regions/region-notes.ts';
import { listed, quoted } from '../formats/text/wording.ts';
import {
  type BoundSetting,
  type BoundSettings,
  defaultBounds,
  moveAll,
  settingsFrom,
  settingsOf,
} from './bounds/bound-setting.ts';
import type { Bounds } from './bounds/bound-text.ts';
import { type Keeping, sameKeeping } from './constraints/keeping.ts';
import { type Method, sameMethod } from './constraints/method.ts';
import { changed, type History, historyOf, redone, settled, undone } from './history.ts';
import { codeOf, messageOf } from './reading/failure.ts';
import { fromAddress, fromFile, type Loadable, welded, withoutVariable } from './reading/loadable.ts';
import type { Source } from './reading/open-surface.ts';
import type { OpenedFile } from './reading/read.ts';
import { Latest, superseded } from './reducing/latest.ts';
import { type Asking, Reducing } from './reducing/reducing.ts';
import { defectNotes, nonFiniteWords } from './report/defect-notes.ts';
import type { Services } from './services.ts';
import { emptyState, type Notice, type Opening, type SessionState, standingOf } from './session-state.ts';

/** The fault of bounds that name variables which the surface does not have; another surface may have them. */
const namesOfBounds = 'names of bounds';
/** All faults that bounds can have. The first is that of a text that states none. */
const boundFaults = ['bounds', namesOfBounds];

/**
 * What is open, what is asked of it and what came of it. Emits `change` whenever its state changes. A fault leaves the
 * last good state as it was and adds a notice.
 */
export class Session extends EventTarget {
  #services: Services;
  #opening = new Latest();
  #reducing: Reducing;
  #lastNotice = 0;
  #wanted: Bounds | null = null;
  /** What is asked for and cannot be understood, by what it is about: until it is made good, nothing is reduced. */
  #faults = new Map<string, unknown>();
  #history = historyOf<BoundSettings>({});
  /** What all bounds are moved in proportion to: moving the rounded bounds on and on would change their proportions. */
  #mix: BoundSettings = {};
  #state = emptyState;

  constructor(services: Services) {
    super();
    this.#services = services;
    this.#reducing = new Reducing(services, this.#asking());
  }

  get state(): SessionState {
    return this.#state;
  }

  /** `beside` are files chosen together with it: variables in CSV, what a glTF file refers to. */
  openFile(file: File, beside: readonly File[] = []): Promise<void> {
    return this.#open(fromFile(file, beside));
  }

  openAddress(address: string): Promise<void> {
    return this.#open(fromAddress(address));
  }

  /**
   * Bounds for the surface that is open and for all that are opened after it; null for those that surfaces begin with.
   *
   * @param later leaves the surface that is open as it is
   */
  wantBounds(bounds: Bounds | null, { later = false } = {}): void {
    this.#wanted = bounds;
    this.#mend(...boundFaults);
    if (!later && this.#state.surface) this.#setBounds(this.#firstBounds(this.#state.surface.variables));
  }

  /**
   * Something that is asked for cannot be understood: it is not taken for something else, nothing is reduced until it is made
   * good, by an `error` of null. What was reduced before stays.
   *
   * @param of what it is about, for example `bounds`
   */
  setFault(of: string, error: unknown): void {
    if (error === null) {
      if (!this.#mend(of)) return;
      const isAnswered = this.#state.reduced !== null && standingOf(this.#state) === 'asked';
      if (!isAnswered && !this.#state.opening) this.reduceAgain();
      return;
    }
    this.#faults.set(of, error);
    this.#reducing.stop();
    this.report(error, { about: of, lasting: true });
    this.#update({ refusal: this.#refusal, progress: null, provisional: null });
  }

  /** Nothing is wrong with these any more. Returns whether something was. */
  #mend(...these: string[]): boolean {
    const mended = these.filter((of) => this.#faults.delete(of));
    for (const of of mended) this.forget(of);
    if (mended.length > 0) this.#update({ refusal: this.#refusal });
    return mended.length > 0;
  }

  get #refusal(): string | null {
    return [...this.#faults.values()].map(messageOf).join(' ') || null;
  }

  setBound(variable: string, setting: BoundSetting): void {
    this.#mend(...boundFaults);
    this.#setBounds({ ...this.#state.bounds, [variable]: setting }, variable);
  }

  /** Multiplies all bounds so that the largest becomes `fraction`. */
  setAllBounds(fraction: number): void {
    this.#mend(...boundFaults);
    const mix = this.#mix;
    this.#setBounds(moveAll(mix, fraction), '*');
    this.#mix = mix;
  }

  setBounds(bounds: Bounds): void {
    this.#mend(...boundFaults);
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
    this.#update(this.#asFirst());
    if (this.#faults.size === 0) void this.#reducing.start();
  }

  /** Before a reduction: it begins, unless something that is asked for cannot be understood. */
  #asFirst(): Pick<SessionState, 'progress' | 'cancelled' | 'refusal'> {
    return { progress: this.#faults.size === 0 ? 0 : null, cancelled: false, refusal: this.#refusal };
  }

  /** Stops what is opened, or else the running reduction. The last surface and result, if there are, stay. */
  cancel(): void {
    if (this.#state.opening) {
      this.#opening.abort();
      this.#stay();
    } else if (this.#state.progress !== null) {
      this.#reducing.stop();
      this.#update({ progress: null, cancelled: true, provisional: null });
    }
  }

  /** Stops everything that runs. Nobody is there any more to see a change; who waits for an answer is told by `stop`. */
  stop(): void {
    this.#opening.abort();
    this.#reducing.stop();
    this.#state = { ...this.#state, opening: null, progress: null, provisional: null };
    this.dispatchEvent(new Event('stop'));
  }

  /**
   * Tells the user of a fault; a lasting one is not about the file that is open. One `about` the same as an earlier one takes its
   * place.
   */
  report(error: unknown, { about, lasting = false }: { about?: string; lasting?: boolean } = {}): void {
    this.#notify({ kind: 'error', code: codeOf(error), text: messageOf(error), about, lasting });
  }

  /** Tells the user something worth knowing of what is open; what is passing goes by itself. */
  tell(text: string, { about, passing = false, remedy }: Pick<Notice, 'about' | 'passing' | 'remedy'> = {}): void {
    this.#notify({ kind: 'note', text, about, passing, remedy });
  }

  /** Takes back what was said about something: it is so no longer. */
  forget(about: string): void {
    const notices = this.#state.notices.filter((notice) => notice.about !== about);
    if (notices.length < this.#state.notices.length) this.#update({ notices });
  }

  dismiss(id: number): void {
    this.#update({ notices: this.#state.notices.filter((notice) => notice.id !== id) });
  }

  /** @param again it is the same surface, read otherwise: bounds of variables that it still has stay */
  async #open(source: Loadable, { again = false } = {}): Promise<void> {
    const { name } = source;
    const tell = (step: Omit<Opening, 'name'>) => this.#update({ opening: { name, ...step } });
    const notices = this.#state.notices.filter(({ lasting }) => lasting);
    this.#update({ opening: { name, phase: 'read', progress: 0 }, notices });
    try {
      const inspected = await this.#opening.run(async (signal) => {
        const file = await source.load(this.#services, signal, tell);
        signal.throwIfAborted();
        tell({ phase: 'check', progress: 0 });
        return { file, inspection: await this.#services.inspect(file.mesh, { signal }) };
      });
      if (inspected === superseded) return;
      const before = again ? this.#state.bounds : {};
      this.#adopt(source, inspected.file, inspected.inspection, before);
    } catch (error) {
      this.#stay();
      this.#notify({ kind: 'error', code: codeOf(error), text: `${source.name}: ${messageOf(error)}` });
    }
  }

  /** At the surface that is open: nothing else is being opened any more. */
  #stay(): void {
    const { reduced, keeping } = this.#state;
    this.#update({ opening: null });
    if (reduced && !sameKeeping(reduced.keeping, keeping)) this.reduceAgain();
  }

  #adopt(source: Loadable, file: OpenedFile, { variables, defects }: Inspection, before: BoundSettings): void {
    const { name, address } = source;
    const { mesh, labels, notes, locked, regions } = file;
    this.#reducing.forget();
    this.#mend(namesOfBounds);
    const surface = { name, address, mesh, labels, variables, locked, regions };
    const bounds = { ...this.#firstBounds(variables), ...settingsOf(variables, before) };
    this.#history = historyOf(bounds);
    this.#mix = bounds;
    this.#update({
      canUndo: false,
      canRedo: false,
      opening: null,
      surface,
      bounds,
      ...this.#asFirst(),
      reduced: null,
      provisional: null,
    });
    for (const text of [...notes, ...defectNotes(defects)]) this.#notify({ kind: 'note', text });
    this.#noteNonFinite(source, file, variables);
    this.#noteCrack(source, file);
    const choosable = choosableRegionNotes(regions, this.#state.keeping.regions);
    for (const text of choosable) this.#notify({ kind: 'note', text, ofRegions: true });
    if (this.#faults.size === 0) void this.#reducing.start();
  }

  /** What is wanted. Where it names a variable that there is not, it is refused: without a bound anything would be allowed. */
  #firstBounds(variables: VariableExtent[]): BoundSettings {
    const names = variables.map(({ name }) => name);
    if (!this.#wanted) return defaultBounds(variables);
    const missing = Object.keys(this.#wanted).filter((name) => name !== '*' && !names.includes(name));
    if (missing.length > 0) this.setFault(namesOfBounds, unknownVariable(missing, names));
    return settingsFrom(this.#wanted, variables);
  }

  /** A crack can be closed as the surface is read. */
  #noteCrack(source: Loadable, { crack }: OpenedFile): void {
    if (!crack) return;
    const take = () => void this.#open(welded(source, crack.weld), { again: true });
    this.#notify({ kind: 'note', text: crack.note, remedy: { label: 'Join them', take } });
  }

  /** A variable that can have no bound is free, and may be left out. */
  #noteNonFinite(source: Source, file: OpenedFile, variables: VariableExtent[]): void {
    for (const { name, nonFinite } of variables) {
      if (!nonFinite) continue;
      const text = `${nonFiniteWords(name, nonFinite)}: it can have no bound, and is only carried along.`;
      const take = () => void this.#open(withoutVariable(source, file, name), { again: true });
      this.#notify({ kind: 'note', text, remedy: { label: `Leave out ${quoted(name)}`, take } });
    }
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
    this.#update({ bounds: present, canUndo, canRedo, ...this.#asFirst() });
    if (this.#faults.size === 0) this.#reducing.follow();
  }

  /** How the answers become the state. */
  #asking(): Asking {
    const session = this;
    return {
      get state() {
        return session.#state;
      },
      began: () => this.#update({ notices: this.#state.notices.filter(({ ofReduction }) => !ofReduction) }),
      progressed: (progress) => this.#update({ progress }),
      answered: (provisional) => this.#update({ provisional }),
      reduced: (reduced, goesOn) => this.#update({ reduced, provisional: null, progress: goesOn ? 0 : null }),
      failed: (error) => {
        this.#notify({ kind: 'error', code: codeOf(error), text: messageOf(error), ofReduction: true });
        this.#update({ provisional: null, progress: null, refusal: messageOf(error) });
      },
    };
  }

  #update(change: Partial<SessionState>): void {
    this.#state = { ...this.#state, ...change };
    this.dispatchEvent(new Event('change'));
  }

  /** The same is not said twice: what is new takes the place of what was said before. */
  #notify(notice: Omit<Notice, 'id'>): void {
    const { notices } = this.#state;
    const others = notices.filter((other) => !isAboutTheSame(other, notice));
    // One that offers a way out keeps its button, and whoever is on that, while its words change.
    const before = notices.find((other) => isAboutTheSame(other, notice) && other.remedy && notice.remedy);
    this.#update({ notices: [...others, { ...notice, id: before?.id ?? ++this.#lastNotice }] });
  }
}

function isAboutTheSame(one: Omit<Notice, 'id'>, other: Omit<Notice, 'id'>): boolean {
  return one.text === other.text || (one.about !== undefined && one.about === other.about);
}

function unknownVariable(missing: string[], names: string[]): Error {
  const text = `There is no variable ${listed(missing)} to bound; the variables are ${listed(names)}.`;
  return Object.assign(new Error(text), { code: 'unknown_variable' });
}
