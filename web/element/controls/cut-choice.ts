import { css, html, LitElement } from 'lit';
import { live } from 'lit/directives/live.js';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import { type ComponentSpan, spanOf } from '../../surface/value-span.ts';
import { axes, type ClipPlane, clipText, parseClip } from '../../viewer/look.ts';
import { english } from '../../words/english.ts';
import { controlsStyle } from './controls-style.ts';

/** Steps of the slider: about as fine as one can see. */
const steps = 500;
/** Digits of a place that the slider gives. */
const placeDigits = 4;

const keptSides = axes.flatMap((axis) => [`${axis} <`, `${axis} >`]);

/**
 * Where a plane cuts the surfaces: typed, or by a side and a slider over the surface.
 *
 * @fires clip-change with the plane as text, null for none
 */
export class CutChoice extends LitElement {
  static override properties = {
    surface: { attribute: false },
    clip: {},
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: grid;
        grid-template-columns: auto 1fr;
        gap: 6px;
        align-items: center;
        margin-bottom: 6px;
      }
      label {
        display: contents;
      }
      input {
        width: 100%;
        min-width: 60px;
        margin: 0;
      }
      [aria-invalid='true'] {
        border-color: var(--fault);
      }
    `,
  ];

  declare surface: OpenSurface | null;
  /** As `parseClip` reads it; empty where there is no plane. */
  declare clip: string;

  /** Of the surface's positions, found when they are first asked for. */
  #box: { of: OpenSurface; spans: ComponentSpan[] } | null = null;

  constructor() {
    super();
    this.surface = null;
    this.clip = '';
  }

  override render() {
    const plane = parseClip(this.clip);
    const kept = plane && clipText(plane).slice(0, 3);
    return html`
      <label>
        ${english.view.cut}
        <input
          type="text"
          placeholder="x < 0.5"
          title=${english.view.cutHint}
          .value=${this.clip}
          @change=${this.#typed}
        />
      </label>
      <select aria-label=${english.view.cutKeeps} ?disabled=${!this.surface} @change=${this.#choose}>
        <option value="" .selected=${live(!kept)}>${english.view.cutKeepsAll}</option>
        ${keptSides.map((side) => html`<option .selected=${live(side === kept)}>${side}</option>`)}
      </select>
      <input
        type="range"
        aria-label=${english.view.cutPlace}
        aria-valuetext=${this.clip || english.view.noCut}
        min="0"
        max=${steps}
        ?disabled=${!plane || !this.surface}
        .value=${live(String(plane ? this.#stepOf(plane) : steps / 2))}
        @input=${this.#slide}
      />
    `;
  }

  /** Takes what was typed where it can be understood; else the field says that it cannot. */
  #typed({ target }: Event): void {
    const input = target as HTMLInputElement;
    const text = input.value.trim();
    const understood = text === '' || parseClip(text) !== null;
    input.setAttribute('aria-invalid', String(!understood));
    if (understood) this.#change(text || null);
  }

  #choose({ target }: Event): void {
    const side = (target as HTMLSelectElement).value;
    const plane = side ? parseClip(`${side} 0`) : null;
    if (!plane) {
      this.#change(null);
      return;
    }
    const now = parseClip(this.clip);
    const at = now?.axis === plane.axis ? now.at : this.#placeAt(plane, steps / 2);
    this.#change(clipText({ ...plane, at }));
  }

  #slide({ target }: Event): void {
    const plane = parseClip(this.clip);
    if (plane)
      this.#change(clipText({ ...plane, at: this.#placeAt(plane, Number((target as HTMLInputElement).value)) }));
  }

  #placeAt(plane: ClipPlane, step: number): number {
    const { lowest, highest } = this.#span(plane);
    return Number((lowest + (step / steps) * (highest - lowest)).toPrecision(placeDigits));
  }

  #stepOf(plane: ClipPlane): number {
    const { lowest, highest } = this.#span(plane);
    return highest > lowest ? Math.round((steps * (plane.at - lowest)) / (highest - lowest)) : steps / 2;
  }

  #span({ axis }: ClipPlane): ComponentSpan {
    const { surface } = this;
    if (!surface) return { lowest: 0, highest: 0 };
    if (this.#box?.of !== surface) {
      const position = { name: 'position', components: 3, values: surface.mesh.position };
      this.#box = { of: surface, spans: spanOf(position, surface.mesh.triangles).components };
    }
    return this.#box.spans[axes.indexOf(axis)];
  }

  #change(detail: string | null): void {
    this.dispatchEvent(new CustomEvent('clip-change', { detail }));
  }
}

customElements.define('meshbound-cut-choice', CutChoice);
