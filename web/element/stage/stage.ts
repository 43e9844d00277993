import { html, LitElement, nothing } from 'lit';
import type { Mesh } from '../../../wasm/types.ts';
import type { Multiplied } from '../../probe/multiplied.ts';
import type { Side } from '../../probe/probe.ts';
import { type Keeping, nothingKept } from '../../session/constraints/keeping.ts';
import { nothingProbed, type ProbeState } from '../../session/probing.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import type { Standing } from '../../session/session-state.ts';
import { type Frame, frameOf } from '../../viewer/frame.ts';
import { chooseLevel } from '../../viewer/level-choice.ts';
import type { ViewDirection } from '../../viewer/linked-cameras.ts';
import { parseClip } from '../../viewer/look.ts';
import { carriedOver, type MorphCorners } from '../../viewer/morph-corners.ts';
import type { MorphSource } from '../../viewer/prepare-morph.ts';
import { Viewer } from '../../viewer/viewer.ts';
import { controlsStyle } from '../controls/controls-style.ts';
import { type Colouring, type Meaning, meanTheSame } from './colouring.ts';
import '../legend/legend.ts';
import { legendWidth } from '../legend/legend-picture.ts';
import { isProvisional } from '../result/guarantee-words.ts';
import type { LevelStep, LevelView, MorphStep } from './level-view.ts';
import '../probe/probe-layer.ts';
import { english } from '../../words/english.ts';
import { firstView, type ViewSettings } from '../attributes/view-settings.ts';
import type { ProbeLayer } from '../probe/probe-layer.ts';
import { type ProbedStage, StageProbe } from '../probe/stage-probe.ts';
import { StageCamera } from './stage-camera.ts';
import { originalCaption, reducedCaption } from './stage-captions.ts';
import { lookupOf, originalColouring, reducedColouring } from './stage-colours.ts';
import { StageDivider } from './stage-divider.ts';
import { StageOutlines } from './stage-outlines.ts';
import { type PlacedLegend, stagePicture } from './stage-picture.ts';
import { stageStyle } from './stage-style.ts';

const sides = ['original', 'reduced'] as const;
const original = 0;
const reduced = 1;

/**
 * The original and the reduced surface side by side, with their legends. A side shows its last surface until the next is
 * ready to draw.
 *
 * @fires level-wanted with the level that the size on screen asks for
 * @fires stage-drawn when both sides show what they are to show
 * @fires stage-shown with the mesh and the reduction that are drawn, each null where there is none
 * @fires stage-point with the point of a surface that is pointed at; null where none is
 * @fires stage-pin with the point to stay at; null: let go
 * @fires stage-worst with a variable: where its error is largest is to be shown
 * @fires stage-camera with the place of the camera as text, or of both of them, when one has moved
 * @fires stage-fault with a message where nothing can be drawn
 */
export class Stage extends LitElement {
  static override properties = {
    surface: { attribute: false },
    result: { attribute: false },
    levels: { attribute: false },
    keeping: { attribute: false },
    position: { type: Number },
    pixels: { attribute: false },
    settings: { attribute: false },
    reducing: { type: Boolean },
    standing: { attribute: false },
    probe: { attribute: false },
    meanings: { state: true },
  };

  static override styles = [controlsStyle, stageStyle];

  declare surface: OpenSurface | null;
  declare result: Multiplied | null;
  /** Levels of detail, to be shown at `position` instead of the result; null where there are none. */
  declare levels: LevelView | null;
  /** What of the surface is kept: drawn on the original. */
  declare keeping: Keeping;
  declare position: number;
  /** How many pixels the error of the level that is shown may span; null where it is not chosen so. */
  declare pixels: number | null;
  declare settings: ViewSettings;
  declare reducing: boolean;
  /** How the result stands to what is asked for. */
  declare standing: Standing;
  /** What stands at the place that is pointed at. */
  declare probe: ProbeState;
  /** What the colours of each side mean. */
  declare meanings: (Meaning | null)[];

  #viewer: Viewer | null = null;
  #camera = new StageCamera();
  #divider = new StageDivider(this, () => {
    if (this.#viewer) this.#viewer.divider = this.#divider.place;
  });
  #frame: Frame = { centre: [0, 0, 0], radius: 1 };
  /** What each side has drawn. */
  #drawn: (Mesh | MorphSource | null)[] = [null, null];
  /** The morph that is being made ready to draw. */
  #coming: MorphSource | null = null;
  /** Where the corners of the morph that is drawn lie on its two levels. */
  #morphCorners: readonly [finer: MorphCorners, coarser: MorphCorners] | null = null;
  /** The result that the reduced side has drawn. */
  #drawnResult: Multiplied | null = null;
  /** Errors on the original side are those of the last one that is not provisional, which tells of none there. */
  #exactResult: Multiplied | null = null;
  #toldShown: Shown = { mesh: null, reduction: null };
  #outlines = new StageOutlines();
  #pointing = new StageProbe(this.#probedStage());

  constructor() {
    super();
    this.surface = null;
    this.result = null;
    this.levels = null;
    this.keeping = nothingKept;
    this.position = 1;
    this.pixels = null;
    this.settings = firstView;
    this.reducing = false;
    this.standing = 'asked';
    this.probe = nothingProbed;
    this.meanings = [null, null];
  }

  override render() {
    return html`
      <canvas part="canvas" aria-hidden="true"></canvas>
      <div class="panes ${this.settings.view}">${sides.map((_, side) => this.#pane(side))}</div>
      ${this.settings.view === 'wipe' ? this.#divider.handle() : nothing}
      <meshbound-probe-layer
        exportparts="marker, probe"
        .state=${this.probe}
        .labels=${this.surface?.labels ?? null}
        ?provisional=${this.#toldShown.reduction && isProvisional(this.#toldShown.reduction.report)}
        @worst-wanted=${({ detail }: CustomEvent<string>) => this.#tell('stage-worst', detail)}
        @unpin=${() => this.#tell('stage-pin', null)}
      ></meshbound-probe-layer>
    `;
  }

  #pane(side: number) {
    return html`<div
      class="pane"
      part="pane"
      id=${sides[side]}
      tabindex="0"
      role="application"
      aria-label="${english.stage.surfaces[sides[side]]}. ${english.stage.keys}"
      @keydown=${(event: KeyboardEvent) => this.#pressKey(side, event)}
      @pointermove=${(event: PointerEvent) => this.#pointing.move(side, event)}
      @pointerleave=${() => this.#pointing.leave()}
      @pointerdown=${(event: PointerEvent) => this.#pointing.press(event)}
      @click=${(event: MouseEvent) => this.#pointing.click(side, event)}
    >
      <div class="caption" part="caption">${this.#caption(side)}</div>
      ${
        this.meanings[side] && !(side === reduced && this.#sharesLegend)
          ? html`<meshbound-legend
              part="legend"
              exportparts="title: legend-title, bar: legend-bar, ticks: legend-ticks"
              .meaning=${this.meanings[side]}></meshbound-legend>`
          : nothing
      }
    </div>`;
  }

  #caption(side: number) {
    if (side === original) return originalCaption(this.surface);
    return reducedCaption(this.result, this.#step(), this.reducing, this.standing);
  }

  override firstUpdated(): void {
    this.#begin();
  }

  /** Moved within the document, or back into it: everything is drawn again. */
  override connectedCallback(): void {
    super.connectedCallback();
    if (!this.hasUpdated || this.#viewer) return;
    this.#begin();
    this.#showAll();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#viewer?.dispose();
    this.#viewer = null;
    this.#drawn = [null, null];
    this.#drawnResult = this.#exactResult = null;
  }

  #begin(): void {
    const canvas = this.renderRoot.querySelector('canvas') as HTMLCanvasElement;
    const panes = [...this.renderRoot.querySelectorAll<HTMLElement>('.pane')];
    try {
      this.#viewer = new Viewer(canvas, panes);
      this.#viewer.addEventListener('draw', this.#chooseLevel);
      this.#viewer.addEventListener('draw', () => this.#tellCamera());
      this.#viewer.addEventListener('draw', () => this.#mark());
    } catch {
      this.#tell('stage-fault', english.faults.noWebGl);
    }
  }

  override updated(changed: Map<string, unknown>): void {
    if (!this.#viewer) return;
    if (changed.has('surface')) this.#showOriginal();
    if (['surface', 'result', 'levels', 'position'].some((each) => changed.has(each))) this.#showReduced();
    if (changed.has('keeping')) this.#outline(original);
    if (changed.has('settings')) this.#applySettings(this.#viewer);
    if (changed.has('surface') || this.#camera.isDue) this.#camera.apply(this.#viewer.cameras);
    if (changed.has('levels') || changed.has('pixels')) this.#chooseLevel();
    if (changed.has('probe')) this.#mark();
  }

  #showAll(): void {
    if (!this.#viewer) return;
    this.#applySettings(this.#viewer);
    this.#camera.apply(this.#viewer.cameras);
    this.#showOriginal();
    this.#showReduced();
  }

  fit(): void {
    this.#viewer?.cameras.fit();
  }

  /** Looks along an axis: from its positive or its negative end. */
  lookFrom(direction: ViewDirection): void {
    this.#viewer?.cameras.lookFrom(direction);
  }

  /** Turns the surfaces until the place that is probed is in sight. */
  revealProbe(): void {
    if (this.probe.probe) this.#pointing.reveal(this.probe.probe);
  }

  /** Where the camera stands, or both of them, as text; null where everything is fitted into view. */
  get camera(): string | null {
    return this.#camera.text(this.#viewer?.cameras);
  }

  set camera(text: string | null) {
    this.#camera.want(text);
    this.requestUpdate();
  }

  /** What is to be seen as a PNG, with the legends or without; null where nothing can be drawn. */
  async picture({ legends, note }: { legends: boolean; note: string }): Promise<Blob | null> {
    const drawn = await this.#viewer?.picture();
    if (!drawn) return null;
    const { backgroundColor: background, color: ink } = getComputedStyle(this);
    return stagePicture(drawn, {
      width: this.clientWidth,
      background,
      ink,
      legends: legends ? this.#placedLegends() : [],
      note,
    });
  }

  #placedLegends(): PlacedLegend[] {
    const stage = this.getBoundingClientRect();
    return sides.flatMap((side, index) => {
      const meaning = this.meanings[index];
      const pane = this.renderRoot.querySelector(`#${side}`)?.getBoundingClientRect();
      if (!meaning || !pane?.width || (index === reduced && this.#sharesLegend)) return [];
      // One over the other, that of the reduced surface stands on the right, as on the stage.
      const isRight = this.settings.view === 'wipe' && index === reduced;
      const left = (isRight ? pane.right - legendWidth : pane.left) - stage.left;
      return [{ meaning, left: Math.round(left), bottom: Math.round(pane.bottom - stage.top) }];
    });
  }

  /** One over the other, surfaces whose colours mean the same have one legend. */
  get #sharesLegend(): boolean {
    const [one, other] = this.meanings;
    return this.settings.view === 'wipe' && one !== null && other !== null && meanTheSame(one, other);
  }

  #tellCamera(): void {
    const { camera } = this;
    if (this.#camera.isNew(camera)) this.#tell('stage-camera', camera);
  }

  #showOriginal(): void {
    if (this.surface) this.#frame = frameOf(this.surface.mesh);
    void this.#show(original, this.surface?.mesh ?? null);
  }

  #showReduced(): void {
    const step = this.#step();
    if (step && 'morph' in step) {
      this.#showMorph(step);
      return;
    }
    this.#coming = null;
    const result = step?.result ?? this.result;
    const mesh = step?.mesh ?? this.result?.mesh ?? null;
    if (step) this.#endAt(step.level);
    if (mesh && mesh === this.#drawn[reduced] && result === this.#drawnResult) return;
    void this.#show(reduced, mesh, () => this.#changedResult(result));
  }

  /** What points can be probed on: not while a morph or the original is drawn instead of a reduction. */
  #tellShown(): void {
    const mesh = this.#drawn[original] === this.surface?.mesh ? (this.surface?.mesh ?? null) : null;
    const isShown = mesh !== null && this.#drawn[reduced] === this.#drawnResult?.mesh;
    const shown = { mesh, reduction: isShown ? this.#drawnResult : null };
    if (shown.mesh === this.#toldShown.mesh && shown.reduction === this.#toldShown.reduction) return;
    this.#toldShown = shown;
    this.#tell('stage-shown', shown);
  }

  #probedStage(): ProbedStage {
    const stage = this;
    return {
      get viewer() {
        return stage.#viewer;
      },
      get panes() {
        return [...stage.renderRoot.querySelectorAll<HTMLElement>('.pane')];
      },
      get view() {
        return stage.settings.view;
      },
      get divider() {
        return stage.#divider.place;
      },
      meshOf: (side: Side) =>
        side === 'original' ? stage.#toldShown.mesh : (stage.#toldShown.reduction?.mesh ?? null),
      pointed: (pointed) => stage.#tell('stage-point', pointed),
      pinned: (pointed) => stage.#tell('stage-pin', pointed),
    };
  }

  #mark(): void {
    const layer = this.renderRoot.querySelector<ProbeLayer>('meshbound-probe-layer');
    if (layer && (this.probe.probe || layer.markers.length > 0))
      layer.markers = this.#pointing.markers(this.probe.probe);
  }

  #outline(side: number): void {
    const drawn = this.#drawn[reduced];
    if (!this.#viewer || !this.surface) return;
    if (side === original) this.#outlines.showKeeping(this.#viewer, this.surface, this.keeping, this.#frame);
    else this.#outlines.showReduced(this.#viewer, drawn && 'position' in drawn ? drawn : null, this.#frame);
  }

  #tell(type: string, detail: unknown): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  #changedResult(result: Multiplied | null): void {
    this.#drawnResult = result;
    if (result && isProvisional(result.report)) return;
    this.#exactResult = result;
    if (this.settings.quantity !== 'value') this.#repaint(original);
  }

  #showMorph(step: MorphStep): void {
    if (this.#drawn[reduced] === step.morph) this.#viewer?.setShare(reduced, step.share);
    if (this.#drawn[reduced] === step.morph || this.#coming === step.morph) return;
    this.#coming = step.morph;
    void this.#viewer?.showMorph(reduced, step.morph, this.#frame, (finer, coarser) => {
      this.#coming = null;
      this.#drawn[reduced] = step.morph;
      this.#morphCorners = [finer, coarser];
      this.#changedResult(step.result);
      // The slider may have moved on meanwhile.
      this.#viewer?.setShare(reduced, this.#morph()?.share ?? step.share);
      this.#outline(reduced);
      this.#tellShown();
      return this.#paintMorph();
    });
  }

  /** A morph that is still drawn waits at its end for the level there. */
  #endAt(level: number): void {
    const before = this.levels?.at(level - 0.5);
    if (before && 'morph' in before && this.#drawn[reduced] === before.morph) this.#viewer?.setShare(reduced, 1);
    const behind = this.levels?.at(level + 0.5);
    if (behind && 'morph' in behind && this.#drawn[reduced] === behind.morph) this.#viewer?.setShare(reduced, 0);
  }

  #chooseLevel = (): void => {
    if (!this.#viewer || !this.levels || this.pixels === null) return;
    const pixelsPerUnit = this.#viewer.pixelsPerRadius(reduced) / this.#frame.radius;
    const level = chooseLevel(this.levels.errors, pixelsPerUnit, this.pixels, Math.round(this.position));
    if (level !== this.position) this.#tell('level-wanted', level);
  };

  /** What is to be shown of the levels; null where there are none. */
  #step(): LevelStep | null {
    return this.levels && this.levels.surface === this.surface ? this.levels.at(this.position) : null;
  }

  async #show(side: number, mesh: Mesh | null, drawn = () => {}): Promise<void> {
    await this.#viewer?.show(side, mesh, this.#frame, () => {
      this.#drawn[side] = mesh;
      drawn();
      return this.#paint(side);
    });
    this.#outline(side);
    this.#tellShown();
    const complete = sides.every((_, each) => this.#drawn[each] === this.#due(each));
    if (mesh && complete) this.dispatchEvent(new CustomEvent('stage-drawn'));
  }

  /** What is about to be replaced keeps its colours; what replaces it takes the new settings when it is drawn. */
  #repaint(side: number): void {
    if (this.#drawn[side] !== this.#due(side)) return;
    if (side === reduced && this.#morph()) this.#viewer?.recolour(side, ...this.#paintMorph());
    else this.#viewer?.recolour(side, this.#paint(side));
  }

  #applySettings(viewer: Viewer): void {
    viewer.cameras.linked = this.settings.linked;
    const { edges, flat, doubleSided, orthographic, clip, view } = this.settings;
    viewer.look = { edges, shading: flat ? 'flat' : 'smooth', doubleSided, clip: parseClip(clip) };
    viewer.cameras.projection = orthographic ? 'orthographic' : 'perspective';
    viewer.divider = view === 'wipe' ? this.#divider.place : null;
    for (const side of [original, reduced]) this.#repaint(side);
  }

  /** Makes map and legend of a side those of what it has drawn, and returns the places of its corners in the map. */
  #paint(side: number): Float32Array {
    return this.#use(side, this.#colouring(side));
  }

  /** The same for a morph, on both of its ends. The map is that of the coarser level. */
  #paintMorph(): readonly [finer: Float32Array, coarser: Float32Array] {
    const { levels } = this;
    const step = this.#morph();
    if (!levels || !step || !this.#morphCorners) return [new Float32Array(), new Float32Array()];
    const ends = [step.from, step.from + 1].map((level) => levels.colouring(level, this.settings));
    this.#use(reduced, ends[1]);
    const [finer, coarser] = ends.map(({ places }, end) => carriedOver(places, 1, (this.#morphCorners ?? [])[end]));
    return [finer, coarser];
  }

  /** The morph that is to be shown; null where none is. */
  #morph(): MorphStep | null {
    const step = this.#step();
    return step && 'morph' in step ? step : null;
  }

  #use(side: number, colouring: Colouring | null): Float32Array {
    const meaning = colouring?.meaning ?? null;
    this.meanings = this.meanings.map((old, index) => (index === side ? meaning : old));
    if (!colouring || !meaning) return new Float32Array();
    this.#viewer?.setLookup(side, lookupOf(meaning));
    return colouring.places;
  }

  /** Whether the reduced side shows what it is to show, not something that waits for it. */
  get showsReduced(): boolean {
    return this.#drawn[reduced] === this.#due(reduced);
  }

  /** What a side is to show. */
  #due(side: number): Mesh | MorphSource | null {
    if (side === original) return this.surface?.mesh ?? null;
    const step = this.#step();
    if (step) return 'morph' in step ? step.morph : step.mesh;
    return this.result?.mesh ?? null;
  }

  #colouring(side: number): Colouring | null {
    const step = this.#step();
    if (side === reduced && step && this.levels && 'level' in step) {
      return this.levels.colouring(step.level, this.settings);
    }
    const mesh = this.#drawn[side] as Mesh | null;
    const { surface, settings } = this;
    if (!mesh || !surface) return null;
    return side === original
      ? originalColouring(mesh, surface, this.#exactResult, settings)
      : reducedColouring(mesh, surface, this.#drawnResult, settings);
  }

  #pressKey(side: number, event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === 'Enter') this.#pointing.pinMiddle(side);
    if (this.#viewer?.cameras.pressKey(side, event.key, event.shiftKey)) event.preventDefault();
  }
}

/** What both sides have drawn. */
export interface Shown {
  mesh: Mesh | null;
  reduction: Multiplied | null;
}

customElements.define('meshbound-stage', Stage);
