import type { Inspection, VariableExtent } from '../../wasm/index.ts';
import { choosableRegionNotes } from '../formats/region-notes.ts';
import { listed } from '../formats/wording.ts';
import { type BoundSetting, type BoundSettings, defaultBounds, moveAll, settingsFrom } from './bound-setting.ts';
import type { Bounds } from './bound-text.ts';
import { codeOf, messageOf, nonFiniteVariable } from './failure.ts';
import { changed, type History, historyOf, redone, settled, undone } from './history.ts';
import { type Keeping, sameKeeping } from './keeping.ts';
import { Latest, superseded } from './latest.ts';
import { fromAddress, fromFile, type Loadable, withoutVariable } from './loadable.ts';
import { type Method, sameMethod } from './method.ts';
import { oddityNotes } from './oddity-notes.ts';
import type { Source } from './open-surface.ts';
import type { OpenedFile } from './read.ts';
import { type Asking, Reducing } from './reducing.ts';
import type { Services } from './services.ts';
import { emptyState, type Notice, type Opening, type SessionState } from './session-state.ts';

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
    void this.#reducing.start();
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

  async #open(source: Loadable): Promise<void> {
    const { name } = source;
    const tell = (step: Omit<Opening, 'name'>) => this.#update({ opening: { name, ...step } });
    const notices = this.#state.notices.filter(({ lasting }) => lasting);
    this.#update({ opening: { name, phase: 'read', progress: 0 }, notices });
    let file: OpenedFile | undefined;
    try {
      const inspected = await this.#opening.run(async (signal) => {
        file = await source.load(this.#services, signal, tell);
        signal.throwIfAborted();
        tell({ phase: 'check', progress: 0 });
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
    { name, address }: Source,
    { mesh, labels, notes, locked, regions }: OpenedFile,
    { variables, oddities }: Inspection,
  ): void {
    this.#reducing.forget();
    const surface = { name, address, mesh, labels, variables, locked, regions };
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
    void this.#reducing.start();
  }

  /** What is wanted, as far as there are such variables. */
  #firstBounds(variables: VariableExtent[]): BoundSettings {
    const names = variables.map(({ name }) => name);
    if (!this.#wanted) return defaultBounds(variables);
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
    const take = () => void this.#open(withoutVariable(source, file, variable));
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
    this.#reducing.follow();
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
        this.#update({ provisional: null, progress: null });
      },
    };
  }

  #update(change: Partial<SessionState>): void {
    this.#state = { ...this.#state, ...change };
    this.dispatchEvent(new Event('change'));
  }

  #notify(notice: Omit<Notice, 'id'>): void {
    this.#update({ notices: [...this.#state.notices, { ...notice, id: ++this.#lastNotice }] });
  }
}
