import { css, html, LitElement, nothing } from 'lit';
import type { Mesh, Reduction } from '../../wasm/types.ts';
import { aboveBoundColour, type Colour, colourTable, missingColour } from '../colour/colormaps.ts';
import type { OpenSurface } from '../session/session.ts';
import { type Frame, frameOf } from '../viewer/frame.ts';
import type { ShownColour } from '../viewer/lookup-material.ts';
import { Viewer } from '../viewer/viewer.ts';
import { type Colouring, type Meaning, valueColouring } from './colouring.ts';
import { controlsStyle } from './controls-style.ts';
import { originalErrors, reducedErrors, unknownErrors } from './error-colouring.ts';
import './legend.ts';
import { countText, trianglesText } from './number-text.ts';
import { firstView, type ViewSettings } from './view-settings.ts';

const sides = ['original', 'reduced'] as const;
const original = 0;
const reduced = 1;

/**
 * The original and the reduced surface side by side, with their legends. A side shows its last surface until the next is
 * ready to draw.
 *
 * @fires stage-drawn when both sides show what they are to show
 * @fires stage-fault with a message where nothing can be drawn
 */
export class Stage extends LitElement {
  static override properties = {
    surface: { attribute: false },
    result: { attribute: false },
    settings: { attribute: false },
    reducing: { type: Boolean },
    meanings: { state: true },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: block;
        position: relative;
        container-type: size;
        background: var(--stage);
        overflow: hidden;
      }
      canvas {
        position: absolute;
        width: 100%;
        height: 100%;
      }
      .panes {
        position: absolute;
        inset: 0;
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 1px;
      }
      @container (max-aspect-ratio: 1/1) {
        .panes {
          grid-template: 1fr 1fr / none;
        }
      }
      .pane {
        display: flex;
        flex-direction: column;
        justify-content: space-between;
        min-width: 0;
        min-height: 0;
        padding: 10px;
        outline-offset: -2px;
        cursor: grab;
      }
      .pane:active {
        cursor: grabbing;
      }
      .pane + .pane {
        box-shadow: -1px 0 var(--line), 0 -1px var(--line);
      }
      .pane > * {
        pointer-events: none;
      }
      .caption {
        align-self: start;
        max-width: 100%;
        padding: 2px 8px;
        background: var(--veil);
        border-radius: var(--radius);
      }
      .caption b {
        font-weight: 600;
      }
    `,
  ];

  declare surface: OpenSurface | null;
  declare result: Reduction | null;
  declare settings: ViewSettings;
  declare reducing: boolean;
  /** What the colours of each side mean. */
  declare meanings: (Meaning | null)[];

  #viewer: Viewer | null = null;
  #frame: Frame = { centre: [0, 0, 0], radius: 1 };
  /** What each side has drawn. */
  #drawn: (Mesh | null)[] = [null, null];
  /** The result that the reduced side has drawn: errors on the original side are its errors. */
  #drawnResult: Reduction | null = null;

  constructor() {
    super();
    this.surface = null;
    this.result = null;
    this.settings = firstView;
    this.reducing = false;
    this.meanings = [null, null];
  }

  override render() {
    return html`
      <canvas part="canvas" aria-hidden="true"></canvas>
      <div class="panes">${sides.map((_, side) => this.#pane(side))}</div>
    `;
  }

  #pane(side: number) {
    const keys = 'Arrow keys turn, with Shift they move, plus and minus zoom, 0 fits.';
    return html`<div
      class="pane"
      part="pane"
      id=${sides[side]}
      tabindex="0"
      role="application"
      aria-label="${sides[side]} surface. ${keys}"
      @keydown=${(event: KeyboardEvent) => this.#pressKey(side, event)}
    >
      <div class="caption" part="caption">${side === original ? this.#originalCaption() : this.#reducedCaption()}</div>
      ${
        this.meanings[side]
          ? html`<meshbound-legend
              part="legend"
              exportparts="title: legend-title, bar: legend-bar, ticks: legend-ticks"
              .meaning=${this.meanings[side]}></meshbound-legend>`
          : nothing
      }
    </div>`;
  }

  #originalCaption() {
    if (!this.surface) return html`<span class="soft">Original</span>`;
    const count = this.surface.mesh.triangles.length / 3;
    return html`Original <b>${countText(count)}</b> ${trianglesText(count)}`;
  }

  #reducedCaption() {
    if (!this.result) return html`<span class="soft">${this.reducing ? 'Reducing…' : 'Not reduced'}</span>`;
    const count = this.result.report.triangles.after;
    return html`Reduced <b>${countText(count)}</b> ${trianglesText(count)}`;
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
    this.#drawnResult = null;
  }

  #begin(): void {
    const canvas = this.renderRoot.querySelector('canvas') as HTMLCanvasElement;
    const panes = [...this.renderRoot.querySelectorAll<HTMLElement>('.pane')];
    try {
      this.#viewer = new Viewer(canvas, panes);
    } catch {
      const detail = 'Nothing can be drawn: this browser offers no WebGL 2. Reducing and saving still work.';
      this.dispatchEvent(new CustomEvent('stage-fault', { detail }));
    }
  }

  override updated(changed: Map<string, unknown>): void {
    if (!this.#viewer) return;
    if (changed.has('surface')) this.#showOriginal();
    if (changed.has('surface') || changed.has('result')) this.#showReduced();
    if (changed.has('settings')) this.#applySettings(this.#viewer);
  }

  #showAll(): void {
    if (!this.#viewer) return;
    this.#applySettings(this.#viewer);
    this.#showOriginal();
    this.#showReduced();
  }

  fit(): void {
    this.#viewer?.cameras.fit();
  }

  #showOriginal(): void {
    if (this.surface) this.#frame = frameOf(this.surface.mesh.position);
    this.fit();
    void this.#show(original, this.surface?.mesh ?? null);
  }

  #showReduced(): void {
    const { result } = this;
    void this.#show(reduced, result?.mesh ?? null, () => {
      this.#drawnResult = result;
      if (this.settings.quantity !== 'value') this.#repaint(original);
    });
  }

  async #show(side: number, mesh: Mesh | null, drawn = () => {}): Promise<void> {
    await this.#viewer?.show(side, mesh, this.#frame, () => {
      this.#drawn[side] = mesh;
      drawn();
      return this.#paint(side);
    });
    const complete = sides.every((_, each) => this.#drawn[each] === this.#due(each));
    if (mesh && complete) this.dispatchEvent(new CustomEvent('stage-drawn'));
  }

  /** What is about to be replaced keeps its colours; what replaces it takes the new settings when it is drawn. */
  #repaint(side: number): void {
    if (this.#drawn[side] === this.#due(side)) this.#viewer?.recolour(side, this.#paint(side));
  }

  #applySettings(viewer: Viewer): void {
    viewer.cameras.linked = this.settings.linked;
    viewer.edges = this.settings.edges;
    for (const side of [original, reduced]) this.#repaint(side);
  }

  /** Makes map and legend of a side those of what it has drawn, and returns the places of its corners in the map. */
  #paint(side: number): Float32Array {
    const colouring = this.#colouring(side);
    const meaning = colouring?.meaning ?? null;
    this.meanings = this.meanings.map((old, index) => (index === side ? meaning : old));
    if (!colouring) return new Float32Array();
    this.#viewer?.setLookup(side, {
      table: colourTable(colouring.meaning.map),
      markAbove: colouring.meaning.quantity !== 'value',
      above: shown(aboveBoundColour),
      missing: shown(missingColour),
    });
    return colouring.places;
  }

  /** What a side is to show. */
  #due(side: number): Mesh | null {
    return (side === original ? this.surface : this.result)?.mesh ?? null;
  }

  #colouring(side: number): Colouring | null {
    const mesh = this.#drawn[side];
    const [surface, result] = [this.surface, this.#drawnResult];
    if (!mesh || !surface) return null;
    if (this.settings.quantity === 'value' || !result) return valueColouring(mesh, surface, this.settings);
    if (side === reduced) return reducedErrors(result, surface.labels, this.settings);
    return originalErrors(mesh, result, surface.labels, this.settings) ?? this.#valuesInstead(mesh, surface);
  }

  #valuesInstead(mesh: Mesh, surface: OpenSurface): Colouring {
    const { places, meaning } = valueColouring(mesh, surface, this.settings);
    return { places, meaning: { ...meaning, detail: unknownErrors } };
  }

  #pressKey(side: number, event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (this.#viewer?.cameras.pressKey(side, event.key, event.shiftKey)) event.preventDefault();
  }
}

function shown([red, green, blue]: Colour): ShownColour {
  return [red / 255, green / 255, blue / 255];
}

customElements.define('meshbound-stage', Stage);
