import { html, LitElement, nothing } from 'lit';
import type { Variable } from '../../../wasm/types.ts';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import type { FocusPoint } from '../../session/constraints/focus-point.ts';
import { type Keeping, nothingKept } from '../../session/constraints/keeping.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import { spanOf } from '../../surface/value-span.ts';
import { pageEnglish } from '../../words/page-english.ts';
import { choice, tick } from './group-controls.ts';
import { groupStyle } from './group-style.ts';
import { numberInput, parseNumber, parseWithin } from './number-input.ts';
import { placeInSight, proposed } from './proposed-place.ts';

/** Of a focus point that is proposed: its radius as a share of the surface's size, and its factor. */
const proposedRadius = 0.1;
const proposedFactor = 0.1;

const parseRadius = parseWithin((radius) => radius > 0, pageEnglish.multiplier.badRadius);
const parseFactor = parseWithin((factor) => factor > 0 && factor <= 1, pageEnglish.multiplier.badFactor);

/**
 * What multiplies the bounds, out of the way until it is opened.
 *
 * @fires keeping-change with what of the Keeping is another
 */
export class MultiplierChoice extends LitElement {
  static override properties = {
    surface: { attribute: false },
    keeping: { attribute: false },
    pinned: { attribute: false },
  };

  static override styles = [controlsStyle, groupStyle];

  declare surface: OpenSurface | null;
  declare keeping: Keeping;
  /** The place on the original that is pinned. */
  declare pinned: readonly number[] | null;

  #able: { of: OpenSurface; names: string[] } | null = null;

  constructor() {
    super();
    this.surface = null;
    this.keeping = nothingKept;
    this.pinned = null;
  }

  override render() {
    const { boundMultiplier, focusPoint } = this.keeping;
    return html`<details @toggle=${() => this.scrollIntoView({ block: 'nearest' })}>
      <summary>
        ${pageEnglish.multiplier.title}
        <span class="small soft">${pageEnglish.multiplier.now(boundMultiplier, focusPoint && String(focusPoint.factor))}</span>
      </summary>
      ${this.#variable()}
      ${tick(pageEnglish.multiplier.point, focusPoint !== null, (wanted) =>
        this.#change({ focusPoint: wanted ? this.#proposed() : null }),
      )}
      ${focusPoint ? this.#point(focusPoint) : nothing}
      <p class="small soft">${pageEnglish.multiplier.means}</p>
    </details>`;
  }

  #variable() {
    const { boundMultiplier } = this.keeping;
    const able = this.#ableNames();
    const names = boundMultiplier === null || able.includes(boundMultiplier) ? able : [boundMultiplier, ...able];
    if (names.length === 0) return html`<p class="small soft">${pageEnglish.multiplier.noVariable}</p>`;
    const options = [['', pageEnglish.multiplier.nothing], ...names.map((name) => [name, name])];
    return choice(pageEnglish.multiplier.variable, options, boundMultiplier ?? '', (name) =>
      this.#change({ boundMultiplier: name || null }),
    );
  }

  #point(focus: FocusPoint) {
    const size = this.#size;
    const place = (axis: number) =>
      numberInput(pageEnglish.multiplier.at('xyz'[axis]), focus.point[axis], size, parseNumber, (value) => {
        const [x, y, z] = focus.point.map((each, i) => (i === axis ? value : each));
        this.#change({ focusPoint: { ...focus, point: [x, y, z] } });
      });
    return html`<div class="places">
        <span class="small">${pageEnglish.multiplier.place}</span>${[0, 1, 2].map(place)}
        <span class="small">${pageEnglish.multiplier.radius}</span>
        ${numberInput(pageEnglish.multiplier.radius, focus.radius, size / 4, parseRadius, (radius) => this.#change({ focusPoint: { ...focus, radius } }))}
        <span class="small">${pageEnglish.multiplier.factor}</span>
        ${numberInput(pageEnglish.multiplier.factor, focus.factor, 1, parseFactor, (factor) => this.#change({ focusPoint: { ...focus, factor } }))}
      </div>
      <button ?disabled=${!this.pinned} title=${pageEnglish.pin.hint} @click=${() => this.#toPin(focus)}>
        ${pageEnglish.multiplier.toPin}
      </button>`;
  }

  #toPin(focus: FocusPoint): void {
    const { point } = this.#proposed();
    this.#change({ focusPoint: { ...focus, point } });
  }

  /** At what is pinned, or else another place of the surface. */
  #proposed(): FocusPoint {
    const place = this.pinned ?? (this.surface ? placeInSight(this.surface.mesh) : [0, 0, 0]);
    const [x, y, z] = place.map(proposed);
    return { point: [x, y, z], radius: proposed(proposedRadius * this.#size), factor: proposedFactor };
  }

  /** Of the surface: the diagonal of its box. */
  get #size(): number {
    return this.surface?.variables[0].extent || 1;
  }

  /** Variables that can multiply: of one component, above zero everywhere. */
  #ableNames(): string[] {
    const { surface } = this;
    if (!surface) return [];
    if (this.#able?.of !== surface) {
      const able = surface.mesh.variables.filter(
        (variable) => variable.components === 1 && isAboveZero(variable, surface.mesh.triangles),
      );
      this.#able = { of: surface, names: able.map(({ name }) => name) };
    }
    return this.#able.names;
  }

  #change(detail: Partial<Keeping>): void {
    this.dispatchEvent(new CustomEvent('keeping-change', { bubbles: true, composed: true, detail }));
  }
}

function isAboveZero(variable: Variable, triangles: Uint32Array): boolean {
  const { components, nan, infinite } = spanOf(variable, triangles);
  return components[0].lowest > 0 && nan + infinite === 0;
}

customElements.define('meshbound-multiplier-choice', MultiplierChoice);
