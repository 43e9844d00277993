import { html, LitElement, nothing, type PropertyValues } from 'lit';
import { inspect, reduce, reduceLevels, reduceOnward, segment } from '../../wasm/index.ts';
import type { Levels, Reduction, Report } from '../../wasm/types.ts';
import type { ValueColormap } from '../colour/colormaps.ts';
import type { Probe } from '../probe/probe.ts';
import { areFirst, asBounds, largestFraction } from '../session/bound-setting.ts';
import { boundsText, readBounds } from '../session/bound-text.ts';
import { fetchBytes } from '../session/fetch-bytes.ts';
import { LevelSession, mostLevels } from '../session/level-session.ts';
import type { Method } from '../session/method.ts';
import { Probing } from '../session/probing.ts';
import { readInWorker } from '../session/read.ts';
import { Session } from '../session/session.ts';
import { answerOf, type Reduced, type SessionState } from '../session/session-state.ts';
import './bound-slider.ts';
import { controlsStyle } from './controls-style.ts';
import { download, type SavedKind, savedFile } from './download.ts';
import { keepingAttributes, keepingFrom, type WantedKeeping } from './keeping-attributes.ts';
import './levels-panel.ts';
import { LevelMotion } from './level-motion.ts';
import { LevelView } from './level-view.ts';
import './notices.ts';
import { percentText } from './number-text.ts';
import { outcomeOf } from './outcome.ts';
import { overall, type Phase, type Step, stepOf } from './progress.ts';
import { isMeasured } from './promise-words.ts';
import './result-bar.ts';
import type { Shown, Stage } from './stage.ts';
import type { Pointed } from './stage-probe.ts';
import './stage.ts';
import type { ViewDirection } from '../viewer/linked-cameras.ts';
import { tokens } from './tokens.ts';
import './view-controls.ts';
import { english } from '../words/english.ts';
import {
  firstView,
  type Quantity,
  sameView,
  settingsFor,
  type View,
  type ViewSettings,
  type WantedView,
} from './view-settings.ts';
import { asAttribute, methodAttributes, methodFrom, propertyOf, viewAttributes } from './viewer-attributes.ts';
import { firstState, type StateAttribute, stateAttributes, type ViewerState } from './viewer-state.ts';
import { viewerStyle } from './viewer-style.ts';

/** How near to the window's part in sight a lazy viewer begins to load. */
const lazyMargin = '200px';

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
export class MeshboundViewer extends LitElement implements WantedView, WantedKeeping {
  static override properties = {
    // Setting the same address again loads it again.
    src: { hasChanged: () => true },
    bounds: { noAccessor: true },
    errors: {},
    cost: {},
    refusePiercing: { attribute: 'refuse-piercing', type: Boolean },
    limitToFeatureSize: { attribute: 'limit-to-feature-size', type: Boolean },
    dropSmallParts: { attribute: 'drop-small-parts', type: Boolean },
    lockPoints: { attribute: 'lock-points' },
    lockBox: { attribute: 'lock-box' },
    regions: {},
    lockRegions: { attribute: 'lock-regions' },
    focusVariable: { attribute: 'focus-variable' },
    focusPoint: { attribute: 'focus-point' },
    variable: {},
    component: {},
    show: {},
    colormap: {},
    range: {},
    view: {},
    edges: { type: Boolean },
    flat: { type: Boolean },
    cull: { type: Boolean },
    orthographic: { type: Boolean },
    clip: {},
    camera: { noAccessor: true },
    levelCount: { noAccessor: true, attribute: 'level-count', type: Number },
    level: { noAccessor: true, type: Number },
    levelPixels: { noAccessor: true, attribute: 'level-pixels', type: Number },
    unlinked: { type: Boolean },
    controls: { type: Boolean },
    poster: {},
    loading: {},
    alt: {},
    drawnOnce: { state: true },
  };

  static override styles = [tokens, controlsStyle, viewerStyle];

  /** The address of a surface: PLY, VTP, legacy VTK, glTF, OBJ or STL, packed by gzip or not. */
  declare src: string | null;
  /** How errors are accounted for: `tracked` (default) or `propagated`, as in the paper. */
  declare errors: Method['errors'] | null;
  /** What retriangulation makes small where errors are propagated: the error `introduced` (default), or the `maximum`. */
  declare cost: Method['cost'] | null;
  /**
   * Let no part of the surface pierce another one that passes near, in exchange for about half the time more.
   *
   * @attr refuse-piercing
   */
  declare refusePiercing: boolean;
  /**
   * Limit the bound of position to half the smallest distance between two parts of the surface that face each other.
   *
   * @attr limit-to-feature-size
   */
  declare limitToFeatureSize: boolean;
  /**
   * Leave out parts of the surface that are smaller than the bound of position, and count them; the promise is about the rest.
   *
   * @attr drop-small-parts
   */
  declare dropSmallParts: boolean;
  /**
   * Points that stay as they are, by their numbers in the surface as it is read, counted from 0: `3,17,20-40`.
   *
   * @attr lock-points
   */
  declare lockPoints: string | null;
  /**
   * A box whose inside stays as it is, in the unit of position: the lowest and the highest place along the axes,
   * `0,0,0,1,1,1`. Every triangle that meets it stays.
   *
   * @attr lock-box
   */
  declare lockBox: string | null;
  /** The cell data, of whole numbers, whose values part the surface into regions: their borders are kept within the bounds. */
  declare regions: string | null;
  /**
   * Regions that stay as they are, by their numbers: `2,5`.
   *
   * @attr lock-regions
   */
  declare lockRegions: string | null;
  /**
   * The variable, of one component and above zero everywhere, that multiplies every bound at each point of the original.
   *
   * @attr focus-variable
   */
  declare focusVariable: string | null;
  /**
   * Where bounds are finer, as `x,y,z,radius,factor`: within the radius they are multiplied by the factor, 0…1, and rise
   * from there to what they are at twice the radius. With `focus-variable` both multiply.
   *
   * @attr focus-point
   */
  declare focusPoint: string | null;
  /** What the surfaces are coloured by: a variable, `position` among them. Default: the first that varies. */
  declare variable: string | null;
  /** Which component of a vector: `magnitude` (default), or what it is called: x, y, z, or as in the file. */
  declare component: string | null;
  /** What is shown of the variable: `value` (default), `error` as a share of its bound, or `signed-error`. */
  declare show: Quantity | null;
  /** The map for values; errors have maps of their own. Default: viridis. */
  declare colormap: ValueColormap | null;
  /** What the map for values spans: `data` (default), percentiles as `2%…98%`, or two values as `0…1.5`. */
  declare range: string | null;
  /**
   * `split` (default), `wipe` (one over the other, with a divider to drag), `original`, `reduced`, or `morph`
   * (the reduced surface with levels of detail, of which there are then four unless `level-count` says otherwise).
   */
  declare view: View | null;
  /** Whether every triangle is shaded as the plane that it is. */
  declare flat: boolean;
  /** Whether triangles are drawn only where their front is seen, so that one looks through the backs. */
  declare cull: boolean;
  /** Whether parallels stay parallel, instead of a perspective. */
  declare orthographic: boolean;
  /** A plane that cuts off one side, in the mesh's unit: `x < 0.5` keeps what is below. */
  declare clip: string | null;
  /** Whether the edges of the triangles are drawn. */
  declare edges: boolean;
  /** Whether each side has a camera of its own, instead of one for both. */
  declare unlinked: boolean;
  /** Whether there are a bar of controls above the stage and the result in words below it. */
  declare controls: boolean;
  /** The address of an image to show until the first surface is drawn. */
  declare poster: string | null;
  /** `lazy`: nothing is loaded before the element comes near the part of the page in sight. */
  declare loading: 'eager' | 'lazy' | null;
  /** What the surface is, for those who cannot see it. */
  declare alt: string | null;
  /** Whether the poster has done its duty. @internal */
  declare drawnOnce: boolean;

  /** What is open, asked for and reached; for the page that is built around the element. @internal */
  readonly session = new Session({ inspect, reduce, reduceOnward, read: readInWorker, fetchBytes });
  /** Levels of detail of what the session reached. @internal */
  readonly levels = new LevelSession(this.session, reduceLevels);
  #probing = new Probing(segment, (error) => this.session.report(error));
  /** What the stage has drawn, and the variable whose worst place is to be pinned when it is a reduction. */
  #shown: Shown = { mesh: null, reduction: null };
  #worstWanted: string | null = null;
  #toldPin: readonly number[] | null = null;
  #levelView: LevelView | null = null;
  #motion = new LevelMotion(this.levels, () => this.#stage?.showsReduced ?? false);
  /** What the last change of the session was compared with. */
  #seen: SessionState = this.session.state;
  /** The same object until something in it changes, so that nothing is painted anew for nothing. */
  #settings = firstView;
  /** Whether the stage shows the last result. */
  #drawn = true;
  /** Whether this browser can draw at all. */
  #drawable = true;
  /** What the work that goes on began with, and what was last told of it. */
  #first: Phase | null = null;
  #step: Step | null = null;
  /** The camera, until there is a stage for it. */
  #firstCamera: string | null = null;
  /** The level that was asked for, until there are so many. */
  #firstLevel: number | null = null;
  /** The reports of levels that were last told of, and the level. */
  #toldLevels: Levels | null = null;
  #toldLevel = 1;
  #sight: IntersectionObserver | null = null;

  constructor() {
    super();
    this.src = null;
    this.errors = null;
    this.cost = null;
    this.refusePiercing = false;
    this.limitToFeatureSize = false;
    this.dropSmallParts = false;
    this.lockPoints = null;
    this.lockBox = null;
    this.regions = null;
    this.lockRegions = null;
    this.focusVariable = null;
    this.focusPoint = null;
    this.variable = null;
    this.component = null;
    this.show = null;
    this.colormap = null;
    this.range = null;
    this.view = null;
    this.flat = false;
    this.cull = false;
    this.orthographic = false;
    this.clip = null;
    this.edges = false;
    this.unlinked = false;
    this.controls = false;
    this.poster = null;
    this.loading = null;
    this.alt = null;
    this.drawnOnce = false;
    this.session.addEventListener('change', () => this.#sessionChanged());
    this.levels.addEventListener('change', () => this.#levelsChanged());
    this.#probing.addEventListener('change', () => this.#probeChanged());
  }

  /**
   * The bounds as text: `position: 1%; pressure: 3%; velocity: 0.2`, in percent of the variable's extent or in its unit;
   * `free` is no bound, `*` stands for every variable not named. A variable that none reaches is free. What cannot be a
   * bound is refused. Default: 1 % in space and 3 % in every variable. Read, the bounds in force.
   *
   * @attr
   */
  get bounds(): string {
    return boundsText(asBounds(this.session.state.bounds));
  }

  set bounds(text: string | null) {
    try {
      this.session.wantBounds(text === null ? null : readBounds(text));
    } catch (error) {
      this.session.report(error, { lasting: true });
    }
  }

  /**
   * Where the camera stands and what it looks at, x y z each, where the surface lies within distance 1 of the origin:
   * `1.9 1.5 3.8 / 0 0 0`; two of these with `;` between where each side has a camera of its own. Null where all of the
   * surface is in view, as at first.
   *
   * @attr
   */
  get camera(): string | null {
    return this.#stage ? this.#stage.camera : this.#firstCamera;
  }

  set camera(text: string | null) {
    this.#firstCamera = text;
    const stage = this.#stage;
    if (stage) stage.camera = text;
  }

  /**
   * How many nested levels of detail there are to be, with morphs between them: each has twice the bounds of the one before,
   * the first has `bounds`. At most 6; default: 0, none.
   *
   * @attr level-count
   */
  get levelCount(): number {
    return this.levels.state.count;
  }

  set levelCount(count: number | null) {
    this.levels.setCount(Math.floor(Math.min(Math.max(Number(count) || 0, 0), mostLevels)));
    if (this.#firstLevel !== null) this.levels.arriveAt(this.#firstLevel);
  }

  /**
   * Which level is shown: 0 the original, 1 (default) the finest, and so on; between two whole numbers the way from one to
   * the other.
   *
   * @attr
   */
  get level(): number {
    return this.levelCount > 0 ? this.levels.state.position : (this.#firstLevel ?? 1);
  }

  set level(level: number | null) {
    this.#firstLevel = Number.isFinite(level) ? Number(level) : 1;
    if (this.levelCount > 0) this.levels.setPosition(this.#firstLevel);
  }

  /**
   * Has the level chosen by its size on screen, the coarsest whose error in space spans no more than this many pixels; null
   * (default), and whenever `level` is set: it is not chosen so.
   *
   * @attr level-pixels
   */
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
      bounds: surface && !areFirst(bounds) ? this.bounds : null,
    };
    for (const name of viewAttributes) text[name] = asAttribute(this[propertyOf(name)]);
    const said = stateAttributes.filter((name) => typeof text[name] === 'string' && text[name] !== firstState[name]);
    return Object.fromEntries(said.map((name) => [name, text[name]]));
  }

  /** What a state does not say becomes as at first; but where it names no address, what is open stays. */
  set state(state: ViewerState) {
    const { bounds = null, src } = state;
    if (bounds !== this.state.bounds || (src && src !== this.state.src)) this.bounds = bounds;
    for (const name of viewAttributes) this.#setAttributeOf(name, state[name] ?? null);
    if (src && src !== this.state.src) this.src = src;
  }

  #setAttributeOf(name: (typeof viewAttributes)[number], value: string | null): void {
    const property = propertyOf(name);
    const isNumber = value !== null && property.startsWith('level');
    const given = typeof this[property] === 'boolean' ? value !== null : isNumber ? Number(value) : value;
    Object.assign(this, { [property]: given });
  }

  /** What is shown, and saved unless it is provisional: the answer at hand, or a level of detail of it. @internal */
  get shown(): Reduced | null {
    return this.levels.shown ?? answerOf(this.session.state);
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
    const blob = await this.#stage?.picture({ legends });
    if (!blob) throw new Error(english.faults.noPicture);
    return blob;
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
      const { name, content, losses } = await savedFile(surface, reduced, this.levels.state.nested, kind);
      download(name, content);
      for (const loss of losses) this.session.tell(`${name}: ${loss}`);
    } catch (error) {
      this.session.report(error);
    }
  }

  /** Rejects where what is shown is provisional and nothing else takes its place. */
  async #settled(): Promise<void> {
    if (!this.session.state.provisional) return;
    this.session.tell(english.progress.savedLater);
    await outcomeOf(this.session);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#sight?.disconnect();
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
    if (changed.has('view') && this.view === 'morph' && this.levelCount === 0) this.levelCount = levelsToMorph;
    if (changed.has('src') && this.src) this.#load();
    // After that, so that what is about to be replaced is not reduced anew.
    if (keepingAttributes.some((name) => changed.has(name))) this.#keep();
  }

  #keep(): void {
    try {
      this.session.setKeeping(keepingFrom(this));
    } catch (error) {
      this.session.report(error, { lasting: true });
    }
  }

  override render() {
    const { surface, progress, notices, keeping } = this.session.state;
    return html`
      ${this.controls ? this.#controls() : nothing}
      <div class="stage" part="stage">
        <meshbound-stage
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
          @stage-camera=${({ detail }: CustomEvent<string | null>) => this.#fire('camera-change', { camera: detail })}
          @stage-fault=${this.#stageFault}
        ></meshbound-stage>
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
    `;
  }

  #poster() {
    const image = this.poster ? html`<img part="poster" src=${this.poster} alt="" />` : nothing;
    return html`<div class="poster"><slot name="poster">${image}</slot></div>`;
  }

  #progress() {
    if (!this.#step || !this.#first) return nothing;
    const width = `width:${100 * overall(this.#step, this.#first)}%`;
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
    const { opening, progress, cancelled } = this.session.state;
    const reduction = this.shown?.result;
    return html`<meshbound-result-bar
      exportparts="sentence, numbers"
      .report=${reduction?.report ?? null}
      .measured=${!reduction || isMeasured(reduction)}
      ?multiplied=${this.session.state.reduced?.result.multiplier !== undefined}
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
    this.#sight?.disconnect();
    if (this.loading === 'lazy') this.#loadInSight();
    else this.#loadNow();
  }

  #loadNow(): void {
    if (this.src) void this.session.openAddress(this.src);
  }

  #loadInSight(): void {
    this.#sight = new IntersectionObserver(
      (entries, observer) => {
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
        observer.disconnect();
        this.#loadNow();
      },
      { rootMargin: lazyMargin },
    );
    this.#sight.observe(this);
  }

  #sessionChanged(): void {
    const [before, now] = [this.#seen, this.session.state];
    this.#seen = now;
    this.requestUpdate();
    this.#probing.mayCut = now.progress === null;
    if (answerOf(now) !== answerOf(before)) this.#drawn = answerOf(now) === null;
    if (now.surface && now.surface !== before.surface) {
      const { name, variables } = now.surface;
      this.#fire('load', { name, variables: variables.map((variable) => variable.name) });
    }
    this.#tellProgress();
    if (now.reduced && now.reduced !== before.reduced) this.#fire('reduce', now.reduced.result.report);
    for (const { kind, code, text } of now.notices.filter((notice) => !before.notices.includes(notice))) {
      if (kind === 'error') this.#fire('error', { code, message: text });
    }
  }

  #levelsChanged(): void {
    const { nested } = this.levels.state;
    const { surface } = this.session.state;
    if (!nested || !surface) this.#levelView = null;
    else if (this.#levelView?.nested !== nested) this.#levelView = new LevelView(surface, nested);
    this.requestUpdate();
    this.#tellLevels();
  }

  #tellLevels(): void {
    const { nested, position } = this.levels.state;
    const [toldLevels, toldLevel] = [this.#toldLevels, this.#toldLevel];
    this.#toldLevels = nested;
    this.#toldLevel = position;
    if (nested && nested !== toldLevels)
      this.#fire(
        'levels',
        nested.levels.map(({ report }) => report),
      );
    if (position !== toldLevel) this.#fire('level-change', { level: position });
  }

  #probeChanged(): void {
    this.requestUpdate();
    const { probe, pinned, pending } = this.#probing.state;
    if (!pending) this.#fire('probe', { probe, pinned });
    const place = (pinned && probe?.original?.position) || null;
    if (`${place}` === `${this.#toldPin}`) return;
    this.#toldPin = place;
    this.#fire('pin', { place });
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
    const step = stepOf(this.session.state, this.#drawn || !this.#drawable);
    const told = this.#step;
    this.#step = step;
    if (step) {
      this.#first ??= step.phase;
      if (told?.phase === step.phase && told.progress === step.progress) return;
      this.#fire('progress', { phase: step.phase, progress: overall(step, this.#first) });
    } else if (this.#first) {
      this.#first = null;
      if (told?.phase === 'draw') this.#fire('progress', { phase: 'draw', progress: 1 });
    }
  }

  #fire(name: string, detail: unknown): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}

/** A morph needs levels; so many where none are asked for. */
const levelsToMorph = 4;
