import { html, nothing, type PropertyValues } from 'lit';
import { inspect, reduce, reduceLevels, resumeReduction, segment } from '../../wasm/index.ts';
import type { Reduction, Report } from '../../wasm/types.ts';
import type { Probe } from '../probe/probe.ts';
import { areFirst, asBounds, largestFraction } from '../session/bounds/bound-setting.ts';
import { boundsText, readBounds } from '../session/bounds/bound-text.ts';
import { Probing } from '../session/probing.ts';
import { fetchBytes } from '../session/reading/fetch-bytes.ts';
import { readInWorker } from '../session/reading/read.ts';
import { LevelSession, mostLevels } from '../session/reducing/level-session.ts';
import type { Reducers } from '../session/reducing/reduced-for-file.ts';
import { Session } from '../session/session.ts';
import { answerOf, type Reduced, type SessionState, type Standing, standingOf } from '../session/session-state.ts';
import { readOptionsFrom } from './attributes/read-options.ts';
import './controls/bound-slider.ts';
import { attributeName } from './attributes/attributes.ts';
import { keepingAttributes, keepingFrom } from './attributes/keeping-attributes.ts';
import { controlsStyle } from './controls/controls-style.ts';
import type { SavedKind, SavedSurface } from './saving/download.ts';
import './controls/levels-panel.ts';
import { LevelMotion } from './level-motion.ts';
import { LevelView } from './stage/level-view.ts';
import './controls/notices.ts';
import { percentText } from './number-text.ts';
import { isMeasured } from './result/guarantee-words.ts';
import { LastingStanding } from './result/lasting-standing.ts';
import { outcomeOf } from './result/outcome.ts';
import { stepOf } from './result/progress.ts';
import './result/result-bar.ts';
import type { Pointed } from './probe/stage-probe.ts';
import { resultLead } from './result/result-lead.ts';
import { Sight } from './sight.ts';
import type { Shown, Stage } from './stage/stage.ts';
import './stage/stage.ts';
import type { ViewDirection } from '../viewer/linked-cameras.ts';
import { tokens } from './tokens.ts';
import './controls/view-controls.ts';
import { english } from '../words/english.ts';
import { firstView, sameView, settingsFor, type ViewSettings, type WantedView } from './attributes/view-settings.ts';
import {
  asAttribute,
  fromAttribute,
  methodAttributes,
  methodFrom,
  viewProperties,
} from './attributes/viewer-attributes.ts';
import { ViewerEvents } from './attributes/viewer-events.ts';
import { ViewerProperties } from './attributes/viewer-properties.ts';
import { firstState, type StateAttribute, stateAttributes, type ViewerState } from './attributes/viewer-state.ts';
import { viewerStyle } from './viewer-style.ts';

/**
 * A surface that carries data, and its reduction within proved bounds.
 *
 * @tag meshbound-viewer
 *
 * @fires {CustomEvent<{ name: string, variables: string[] }>} load - A surface is open.
 * @fires {CustomEvent<{ phase: Phase, progress: number }>} progress - What is being done, and how far everything is, 0…1.
 * @fires {CustomEvent<Report>} reduce - A reduction has ended well: its report. What is shown as provisional while bounds move is none.
 * @fires {CustomEvent<{ probe: Probe | null, pinned: boolean }>} probe - Another place is pointed at or pinned: what stands there on both surfaces, and each error; null where none is any more.
 * @fires {CustomEvent<{ place: number[] | null }>} pin - Another place of the original is pinned: where, in the unit of position; null where none is any more.
 * @fires {CustomEvent<Report[]>} levels - Levels of detail are there: the report of each, finest first.
 * @fires {CustomEvent<{ level: number }>} level-change - Another level is shown, or the way between two goes on.
 * @fires {CustomEvent<{ camera: string | null }>} camera-change - The camera has moved; the detail is as the attribute.
 * @fires {CustomEvent<{ code: string, message: string }>} error - Something is at fault. What was shown before stays.
 *
 * @slot poster - Shown until the first surface is drawn, instead of the image that `poster` names.
 * @slot controls - Further controls, in the bar that `controls` shows.
 *
 * @csspart stage - Where the surfaces are drawn.
 * @csspart pane - The part of the stage of one surface.
 * @csspart canvas - The picture under the panes.
 * @csspart caption - What a pane shows: original or reduced, and how many triangles.
 * @csspart legend - What the colours mean.
 * @csspart legend-title - The name and the unit of what is shown.
 * @csspart legend-bar - The colours.
 * @csspart legend-ticks - The numbers that they stand for.
 * @csspart divider - What is dragged between the surfaces when one lies over the other.
 * @csspart marker - Where a probed place is on a surface.
 * @csspart probe - What stands at the probed place.
 * @csspart poster - The image before the first surface.
 * @csspart notice - A message over the stage.
 * @csspart progress - How far the work is: a line at the lower edge of the stage.
 * @csspart controls - The bar of controls above the stage.
 * @csspart levels - The bar below the stage in which a level of detail is chosen.
 * @csspart sentence - The result in words below the stage.
 * @csspart numbers - Beside it, how far the work is, or what it brought.
 *
 * @cssprop --meshbound-stage - Behind the surfaces.
 * @cssprop --meshbound-panel - Behind controls and messages.
 * @cssprop --meshbound-ink - Text.
 * @cssprop --meshbound-ink-soft - Text of less weight.
 * @cssprop --meshbound-line - Lines between parts.
 * @cssprop --meshbound-control - Behind buttons, choices and fields.
 * @cssprop --meshbound-control-hover - Behind them while pointed at.
 * @cssprop --meshbound-control-line - Around them.
 * @cssprop --meshbound-accent - What is chosen, and progress.
 * @cssprop --meshbound-accent-soft - The track of a bound.
 * @cssprop --meshbound-fault - Text of a fault.
 * @cssprop --meshbound-fault-soft - Behind it.
 * @cssprop --meshbound-veil - Behind captions and legends.
 * @cssprop --meshbound-gap - Room between controls.
 * @cssprop --meshbound-radius - Of corners.
 * @cssprop --meshbound-text - Size of text.
 * @cssprop --meshbound-text-small - Size of text in legends.
 * @cssprop --meshbound-font - Family of text.
 */
export class MeshboundViewer extends ViewerProperties {
  static override properties = { drawnOnce: { state: true } };

  static override styles = [tokens, controlsStyle, viewerStyle];

  /** Whether the poster has done its duty. @internal */
  declare drawnOnce: boolean;

  /** What is open, asked for and reached; for the page that is built around the element. @internal */
  readonly session = new Session({
    inspect,
    reduce,
    resumeReduction,
    read: (name, bytes, watchers, beside, options) =>
      readInWorker(name, bytes, watchers, beside, { ...readOptionsFrom(this.weld), ...options }),
    fetchBytes,
  });
  /** Levels of detail of what the session reached. @internal */
  readonly levels = new LevelSession(this.session, reduceLevels);
  #probing = new Probing(segment, (error) => this.session.report(error));
  /** What the stage has drawn, and the variable whose worst place is to be pinned when it is a reduction. */
  #shown: Shown = { mesh: null, reduction: null };
  #worstWanted: string | null = null;
  #levelView: LevelView | null = null;
  #lastSaved: SavedSurface | null = null;
  #motion = new LevelMotion(this.levels, () => this.#stage?.showsReduced ?? false);
  /** What the last change of the session was compared with. */
  #seen: SessionState = this.session.state;
  /** The same object until something in it changes, so that nothing is painted anew for nothing. */
  #settings = firstView;
  /** Whether the stage shows the last result. */
  #drawn = true;
  /** Whether this browser can draw at all. */
  #drawable = true;
  #events = new ViewerEvents(this);
  /** The camera, until there is a stage for it. */
  #firstCamera: string | null = null;
  /** The level that was asked for, until there are so many. */
  #firstLevel: number | null = null;
  /** There are levels only because the view needs them. */
  #levelsOfView = false;
  #sight = new Sight();
  #standing = new LastingStanding(this, this.session);

  constructor() {
    super();
    this.drawnOnce = false;
    this.session.addEventListener('change', () => this.#sessionChanged());
    this.levels.addEventListener('change', () => this.#levelsChanged());
    this.#probing.addEventListener('change', () => this.#probeChanged());
  }

  get bounds(): string {
    return boundsText(asBounds(this.session.state.bounds));
  }

  set bounds(text: string | null) {
    try {
      this.session.wantBounds(text === null ? null : readBounds(text));
    } catch (error) {
      this.session.setFault('bounds', error);
    }
  }

  get camera(): string | null {
    return this.#stage ? this.#stage.camera : this.#firstCamera;
  }

  set camera(text: string | null) {
    this.#firstCamera = text;
    const stage = this.#stage;
    if (stage) stage.camera = text;
  }

  get levelCount(): number {
    return this.levels.state.count;
  }

  set levelCount(count: number | null) {
    this.levels.setCount(Math.floor(Math.min(Math.max(Number(count) || 0, 0), mostLevels)));
    if (this.#firstLevel !== null) this.levels.arriveAt(this.#firstLevel);
  }

  get level(): number {
    return this.levelCount > 0 ? this.levels.state.position : (this.#firstLevel ?? 1);
  }

  set level(level: number | null) {
    this.#firstLevel = Number.isFinite(level) ? Number(level) : 1;
    if (this.levelCount > 0) this.levels.setPosition(this.#firstLevel);
  }

  get levelPixels(): number | null {
    return this.levels.state.pixels;
  }

  set levelPixels(pixels: number | null) {
    this.levels.setPixels(pixels !== null && pixels > 0 ? pixels : null);
  }

  /** What the last reduction reached, provisional answers aside; null where there is none. */
  get report(): Report | null {
    return this.reduction?.report ?? null;
  }

  /** The last reduction, provisional answers aside: mesh, map, errors, report; null where there is none. Its arrays are the viewer's. */
  get reduction(): Reduction | null {
    return this.session.state.reduced?.result ?? null;
  }

  /** What stands at the place that is pointed at or pinned, on both surfaces; null where none is. */
  get probe(): Probe | null {
    return this.#probing.state.probe;
  }

  /** How the surfaces are looked at: what is asked for, as far as the surface has it. @internal */
  get settings(): ViewSettings {
    const settings = settingsFor(this.session.state.surface, this);
    if (!sameView(settings, this.#settings)) this.#settings = settings;
    return this.#settings;
  }

  /** What there is to say of the viewer as attributes, to have the same again elsewhere. Never data. */
  get state(): ViewerState {
    const { surface, bounds } = this.session.state;
    const text: Partial<Record<StateAttribute, string | null>> = {
      src: surface?.address,
      bounds: surface && !areFirst(bounds, surface.variables) ? this.bounds : null,
    };
    for (const property of viewProperties) text[attributeName(property)] = asAttribute(this[property]);
    const said = stateAttributes.filter((name) => typeof text[name] === 'string' && text[name] !== firstState[name]);
    return Object.fromEntries(said.map((name) => [name, text[name]]));
  }

  /** What a state does not say becomes as at first; but where it names no address, what is open stays. */
  set state(state: ViewerState) {
    const { bounds = null, src } = state;
    if (bounds !== this.state.bounds || (src && src !== this.state.src)) this.bounds = bounds;
    for (const property of viewProperties)
      Object.assign(this, { [property]: fromAttribute(property, state[attributeName(property)] ?? null) });
    if (src && src !== this.state.src) this.src = src;
  }

  /** What is shown, and saved unless it is provisional: the answer at hand, or a level of detail of it. @internal */
  get shown(): Reduced | null {
    return this.levels.shown ?? answerOf(this.session.state);
  }

  /** How that stands to what is asked for. @internal */
  get standing(): Standing {
    return this.#standing.value;
  }

  /** What has to be said before the sentence about it. @internal */
  get resultLead(): string {
    return resultLead(this.standing, this.levels.state);
  }

  /** Opens a file of the user's, and those chosen together with it: variables in CSV, what a glTF file refers to. */
  open(file: File, ...beside: File[]): Promise<void> {
    return this.session.openFile(file, beside);
  }

  /**
   * Reduces anew. Resolves to the report; rejects with an AbortError where the reduction is aborted, another surface is
   * opened or the viewer is removed from the page meanwhile, and with an Error where it fails or there is nothing to reduce.
   */
  async reduce(): Promise<Report> {
    if (!this.session.state.surface) throw new Error(english.faults.noSurface);
    this.session.reduceAgain();
    if (this.session.state.refusal !== null) throw new Error(this.session.state.refusal);
    const { result } = await outcomeOf(this.session);
    return result.report;
  }

  /** Stops what is loaded or reduced. What was shown before stays. */
  abort(): void {
    this.session.cancel();
  }

  /** Brings the whole surface into view. */
  fit(): void {
    this.#stage?.fit();
  }

  /** Looks along an axis: from its positive or its negative end, `+x` to `-z`. */
  lookFrom(direction: ViewDirection): void {
    this.#stage?.lookFrom(direction);
  }

  /**
   * Pins the place where the error of a variable, `position` among them, is largest, and turns it into sight. From the way
   * between two levels of detail it goes to the nearer one.
   */
  async probeWorst(variable: string): Promise<void> {
    const { nested, position } = this.levels.state;
    const level = Math.max(1, Math.round(position));
    this.#worstWanted = variable;
    if (nested && level !== position) this.levels.setPosition(level);
    await this.#probeWanted();
  }

  /** As soon as there is a reduction to look at. */
  async #probeWanted(): Promise<void> {
    const variable = this.#worstWanted;
    if (variable === null || !this.#shown.reduction) return;
    this.#worstWanted = null;
    this.#probing.pinWorst(variable);
    await this.updateComplete;
    await this.#stage?.updateComplete;
    this.#stage?.revealProbe();
  }

  /** Lets go of the place that is pinned. */
  unpin(): void {
    this.#probing.pin('original', null);
  }

  /** What is seen as a PNG, with the legends or without. Rejects where nothing can be drawn. */
  async toBlob({ legends = true }: { legends?: boolean } = {}): Promise<Blob> {
    const blob = await this.#stage?.picture({ legends, note: this.#pictureNote() });
    if (!blob) throw new Error(english.faults.noPicture);
    return blob;
  }

  /** What a picture must say of itself: that the surface in it is not the answer to what is asked for. */
  #pictureNote(): string {
    const { shown, session } = this;
    if (!shown || !this.#stage?.showsReduced) return '';
    const bounds = boundsText(asBounds(shown.bounds));
    if (session.state.provisional) return english.save.provisionalPicture(bounds);
    return standingOf(session.state) === 'asked' ? '' : english.save.earlierPicture(bounds);
  }

  /**
   * Offers a download: the reduced surface as `ply`, `vtp`, `vtk`, `glb`, `obj` or `stl`, the `report` as JSON, or the `map`
   * as VTP (the original with where each vertex went and what error it has there), or all `levels` of detail as one GLB, where there
   * are some. What a format cannot hold is said. What is provisional is not saved, but what takes its place, as soon as that
   * is there; where it never is, this rejects as `reduce()` does.
   */
  async save(kind: SavedKind): Promise<void> {
    const { surface } = this.session.state;
    if (!surface) return;
    await this.#settled();
    const reduced = this.shown;
    if (!reduced) return;
    try {
      // Loaded when it is first needed, as the formats' writers are.
      const { download, savedFile } = await import('./saving/download.ts');
      const savable = { surface, reduced, levels: this.levels.state.results, last: this.#lastSaved };
      const saved = await savedFile(kind, savable, this.#reducersForFile());
      download(saved.name, saved.content);
      if (saved.report) this.#lastSaved = { of: reduced, name: saved.name, report: saved.report };
      this.#tellSaved(saved.name, reduced, saved.notes);
    } catch (error) {
      if (error instanceof DOMException && error.name === 'AbortError')
        this.session.tell(english.save.reducingCancelled, { about: 'saved', passing: true });
      else this.session.report(error, { about: 'saved' });
    }
  }

  /** What reduces again for a file that rounds; meanwhile a notice says how far it is, and can end it. */
  #reducersForFile(): Reducers {
    const ending = new AbortController();
    const remedy = { label: english.progress.cancel, take: () => ending.abort() };
    let told = -1;
    const onProgress = (progress: number) => {
      const percent = 10 * Math.floor(10 * progress);
      if (percent === told || ending.signal.aborted) return;
      told = percent;
      this.session.tell(english.save.reducing(percent), { about: 'saved', remedy });
    };
    const watched = { signal: ending.signal, onProgress };
    return {
      reduce: (mesh, options) => reduce(mesh, { ...options, ...watched }),
      reduceLevels: (mesh, options) => reduceLevels(mesh, { ...options, ...watched }),
    };
  }

  /** What a file lacks, that it was reduced again for, or that it is not what is asked for. */
  #tellSaved(name: string, { bounds }: Reduced, notes: readonly string[]): void {
    const isEarlier = standingOf(this.session.state) !== 'asked';
    const earlier = isEarlier ? [english.save.earlier(name, boundsText(asBounds(bounds)))] : [];
    const said = notes.length > 0 ? [`${name}: ${notes.join(' ')}`] : [];
    if (isEarlier || notes.length > 0)
      this.session.tell([...earlier, ...said].join(' '), { about: 'saved', passing: !isEarlier });
    else this.session.forget('saved');
  }

  /** Waits for the answer to what is asked for. Rejects where it does not come. */
  async #settled(): Promise<void> {
    if (this.session.state.progress === null) return;
    this.session.tell(english.progress.savedLater, { about: 'saved' });
    await outcomeOf(this.session);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#sight.stop();
    this.#motion.stop();
    // Moved within the document, it is back at once.
    queueMicrotask(() => this.isConnected || this.#stop());
  }

  #stop(): void {
    this.session.stop();
    this.#probing.stop();
  }

  override firstUpdated(): void {
    if (this.#firstCamera !== null) this.camera = this.#firstCamera;
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (methodAttributes.some((name) => changed.has(name))) this.session.setMethod(methodFrom(this));
    if (changed.has('view')) this.#bringLevels();
    if (changed.has('src') && this.src) this.#load();
    // After that, so that what is about to be replaced is not reduced anew.
    if (keepingAttributes.some((name) => changed.has(name))) this.#keep();
  }

  /** A morph needs levels: where there are none they come with the view, and go with it. */
  #bringLevels(): void {
    if (this.view === 'morph' && this.levelCount === 0) {
      this.#levelsOfView = true;
      this.levelCount = levelsToMorph;
    } else if (this.view !== 'morph' && this.#levelsOfView) {
      this.#levelsOfView = false;
      if (this.levelCount === levelsToMorph) this.levelCount = 0;
    }
  }

  #keep(): void {
    try {
      this.session.setKeeping(keepingFrom(this));
      this.session.setFault('keeping', null);
    } catch (error) {
      this.session.setFault('keeping', error);
    }
  }

  override render() {
    const { notices } = this.session.state;
    return html`<div class="width"></div><div class="frame">
      ${this.controls ? this.#controls() : nothing}
      <div class="stage" part="stage">
        ${this.#surfaces()}
        ${this.drawnOnce ? nothing : this.#poster()}
        ${this.#progress()}
        <meshbound-notices
          exportparts="notice"
          .notices=${notices}
          @dismiss=${({ detail }: CustomEvent<number>) => this.session.dismiss(detail)}
        ></meshbound-notices>
      </div>
      ${this.controls && this.levelCount > 0 ? this.#levels() : nothing}
      ${this.controls ? this.#result() : nothing}
    </div>`;
  }

  #surfaces() {
    const { surface, progress, keeping } = this.session.state;
    return html`<meshbound-stage
      role="group"
      aria-label=${this.alt ?? (surface?.name || nothing)}
      exportparts="pane, caption, legend, legend-title, legend-bar, legend-ticks, canvas, divider, marker, probe"
      .surface=${surface}
      .result=${answerOf(this.session.state)?.result ?? null}
      .levels=${this.#levelView}
      .keeping=${keeping}
      .position=${this.levels.state.position}
      .pixels=${this.levels.state.pixels}
      @level-wanted=${({ detail }: CustomEvent<number>) => this.#motion.towards(detail)}
      .reducing=${progress !== null}
      .standing=${this.standing}
      .settings=${this.settings}
      .probe=${this.#probing.state}
      @stage-shown=${this.#stageShown}
      @stage-point=${({ detail }: CustomEvent<Pointed | null>) =>
        this.#probing.point(detail?.from ?? 'original', detail?.place ?? null)}
      @stage-pin=${({ detail }: CustomEvent<Pointed | null>) =>
        this.#probing.pin(detail?.from ?? 'original', detail?.place ?? null)}
      @stage-worst=${({ detail }: CustomEvent<string>) => this.probeWorst(detail)}
      @keydown=${(event: KeyboardEvent) => event.key === 'Escape' && this.unpin()}
      @stage-drawn=${this.#stageDrawn}
      @stage-camera=${({ detail }: CustomEvent<string | null>) => this.#events.cameraMoved(detail)}
      @stage-fault=${this.#stageFault}
    ></meshbound-stage>`;
  }

  #poster() {
    const image = this.poster ? html`<img part="poster" src=${this.poster} alt="" />` : nothing;
    return html`<div class="poster"><slot name="poster">${image}</slot></div>`;
  }

  #progress() {
    const { progress } = this.#events;
    if (progress === null) return nothing;
    const width = `width:${100 * progress}%`;
    return html`<div class="progress" part="progress" aria-hidden="true" .style=${width}></div>`;
  }

  #controls() {
    const { surface, bounds } = this.session.state;
    const fraction = surface ? largestFraction(bounds) : 0;
    return html`<div class="controls" part="controls">
      <label class="all">
        <span class="soft">${english.bounds.title}</span>
        <meshbound-bound-slider
          label=${english.bounds.allBounds}
          spoken=${english.bounds.largest(percentText(fraction))}
          .fraction=${fraction}
          ?disabled=${!surface}
          @bound-input=${({ detail }: CustomEvent<number>) => this.session.setAllBounds(detail)}
          @bound-settled=${() => this.session.settleBounds()}
        ></meshbound-bound-slider>
        <span>${surface ? percentText(fraction) : ''}</span>
      </label>
      <meshbound-view-controls
        .surface=${surface}
        .bounds=${bounds}
        .settings=${this.settings}
        @view-change=${({ detail }: CustomEvent<Partial<WantedView>>) => Object.assign(this, detail)}
        @fit=${() => this.fit()}
        @look-from=${({ detail }: CustomEvent<ViewDirection>) => this.lookFrom(detail)}
      ></meshbound-view-controls>
      <slot name="controls"></slot>
    </div>`;
  }

  #levels() {
    return html`<meshbound-levels-panel
      part="levels"
      .levels=${this.levels.state}
      @level-count=${({ detail }: CustomEvent<number>) => this.levels.setCount(detail)}
      @level-pixels=${({ detail }: CustomEvent<number | null>) => this.levels.setPixels(detail)}
      @level-position=${({ detail }: CustomEvent<number>) => this.levels.setPosition(detail)}
    ></meshbound-levels-panel>`;
  }

  #result() {
    const { opening, progress, cancelled, refusal } = this.session.state;
    const reduction = this.shown?.result;
    return html`<meshbound-result-bar
      exportparts="sentence, numbers"
      .report=${reduction?.report ?? null}
      .measured=${!reduction || isMeasured(reduction)}
      ?multiplied=${this.session.state.reduced?.result.multiplier !== undefined}
      .lead=${this.resultLead}
      .refusal=${refusal}
      .opening=${opening}
      .progress=${progress}
      .cancelled=${cancelled}
      @cancel=${() => this.abort()}
      @reduce-again=${() => this.session.reduceAgain()}
    ></meshbound-result-bar>`;
  }

  get #stage(): Stage | null {
    return this.renderRoot?.querySelector<Stage>('meshbound-stage') ?? null;
  }

  #load(): void {
    this.#sight.stop();
    if (this.loading === 'lazy') this.#sight.wait(this, () => this.#loadNow());
    else this.#loadNow();
  }

  #loadNow(): void {
    if (this.src) void this.session.openAddress(this.src);
  }

  #sessionChanged(): void {
    const [before, now] = [this.#seen, this.session.state];
    this.#seen = now;
    this.requestUpdate();
    this.#probing.mayCut = now.progress === null;
    if (answerOf(now) !== answerOf(before)) this.#drawn = answerOf(now) === null;
    this.#events.opened(before, now);
    this.#tellProgress();
    this.#events.reduced(before, now);
    this.#events.failed(before, now);
  }

  #levelsChanged(): void {
    const { nested } = this.levels.state;
    const { surface } = this.session.state;
    if (!nested || !surface) this.#levelView = null;
    else if (this.#levelView?.nested !== nested) this.#levelView = new LevelView(surface, nested);
    this.requestUpdate();
    this.#events.levels(this.levels.state);
  }

  #probeChanged(): void {
    this.requestUpdate();
    this.#events.probed(this.#probing.state);
  }

  #stageShown({ detail }: CustomEvent<Shown>): void {
    if (detail.mesh !== this.#shown.mesh) this.#worstWanted = null;
    this.#shown = detail;
    this.#probing.follow(detail.mesh, detail.reduction);
    void this.#probeWanted();
  }

  #stageDrawn(): void {
    this.drawnOnce = true;
    if (this.#drawn) return;
    this.#drawn = true;
    this.#tellProgress();
    this.requestUpdate();
  }

  #stageFault({ detail }: CustomEvent<string>): void {
    this.#drawable = false;
    this.session.report(detail, { lasting: true });
  }

  #tellProgress(): void {
    this.#events.progressed(stepOf(this.session.state, this.#drawn || !this.#drawable));
  }
}

/** A morph needs levels; so many where none are asked for. */
const levelsToMorph = 4;
