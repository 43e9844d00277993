import { css, html, LitElement, nothing, type PropertyValues } from 'lit';
import { live } from 'lit/directives/live.js';
import type { Box } from '../../../wasm/types.ts';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import { countText } from '../../element/number-text.ts';
import { type Keeping, nothingKept } from '../../session/constraints/keeping.ts';
import { type PointRange, pointsOf, pointsText, readPoints } from '../../session/constraints/point-list.ts';
import { messageOf } from '../../session/reading/failure.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import { type ComponentSpan, spanOf } from '../../surface/value-span.ts';
import { english } from '../../words/english.ts';
import { pageEnglish } from '../../words/page-english.ts';
import { choice, tick } from './group-controls.ts';
import { groupStyle } from './group-style.ts';
import { nearestVertex } from './nearest-vertex.ts';
import { numberInput, parseNumber } from './number-input.ts';
import { placeInSight, proposed } from './proposed-place.ts';

const axes = [0, 1, 2] as const;
/** Half the size of a box that is proposed, of that of the surface. */
const proposedShare = 0.15;

/**
 * What must stay as it is, and what parts the surface into regions, out of the way until it is opened.
 *
 * @fires keeping-change with what of the Keeping is another
 */
export class LockChoice extends LitElement {
  static override properties = {
    surface: { attribute: false },
    keeping: { attribute: false },
    pinned: { attribute: false },
    isUnmet: { type: Boolean },
    refused: { state: true },
  };

  static override styles = [
    controlsStyle,
    groupStyle,
    css`
      fieldset {
        display: flex;
        flex-wrap: wrap;
        gap: 0 16px;
        max-height: 140px;
        margin: 6px 0 0;
        padding: 0 8px 6px;
        overflow-y: auto;
        border: 1px solid var(--line);
        border-radius: var(--radius);
      }
      legend {
        padding: 0 4px;
      }
      label > input[type='text'] {
        width: 198px;
      }
      .fault {
        color: var(--fault);
      }
    `,
  ];

  declare surface: OpenSurface | null;
  declare keeping: Keeping;
  /** The place on the original that is pinned. */
  declare pinned: readonly number[] | null;
  /** The box that was reduced with meets no triangle. */
  declare isUnmet: boolean;
  /** What was typed as points and cannot be. @internal */
  declare refused: { text: string; why: string } | null;

  #span: { of: OpenSurface; along: ComponentSpan[] } | null = null;
  #counted: { of: Int32Array; labels: [label: number, triangles: number][] } | null = null;

  constructor() {
    super();
    this.surface = null;
    this.keeping = nothingKept;
    this.pinned = null;
    this.isUnmet = false;
    this.refused = null;
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('keeping') || changed.has('surface')) this.refused = null;
  }

  override render() {
    const { lockPoints, lockBox, regions, lockRegions } = this.keeping;
    return html`<details @toggle=${() => this.scrollIntoView({ block: 'nearest' })}>
      <summary>
        ${pageEnglish.locks.title}
        <span class="small soft">${pageEnglish.locks.now(lockPoints.length > 0, lockBox !== null, lockRegions.length, regions)}</span>
      </summary>
      ${this.#points(lockPoints)}
      ${tick(pageEnglish.locks.box, lockBox !== null, (wanted) => this.#change({ lockBox: wanted ? this.#proposedBox() : null }))}
      ${lockBox ? this.#box(lockBox) : nothing}
      ${this.isUnmet ? html`<p class="small" role="status">${pageEnglish.locks.unmet}</p>` : nothing}
      <p class="small soft">${pageEnglish.locks.boxMeans}</p>
      ${this.#regions()}
    </details>`;
  }

  #points(ranges: readonly PointRange[]) {
    const { refused } = this;
    return html`<label>
        <span>${pageEnglish.locks.points}</span>
        <input
          type="text"
          autocomplete="off"
          spellcheck="false"
          aria-describedby=${refused ? 'points-fault points-mean' : 'points-mean'}
          aria-invalid=${refused !== null}
          .value=${live(refused?.text ?? pointsText(ranges))}
          @change=${({ target }: Event) => this.#lockPoints((target as HTMLInputElement).value)}
          @keydown=${(event: KeyboardEvent) => this.#restorePoints(event, ranges)}
        />
      </label>
      ${refused ? html`<p class="small fault" id="points-fault" role="alert">${refused.why}</p>` : nothing}
      <p class="small soft" id="points-mean">${pageEnglish.locks.pointsMean}</p>
      <button
        ?disabled=${!this.pinned}
        title=${this.pinned ? pageEnglish.locks.addPinMeans : pageEnglish.pin.hint}
        @click=${() => this.#addPin(ranges)}
      >
        ${pageEnglish.locks.addPin}
      </button>`;
  }

  #box(box: Box) {
    const row = (end: 'lowest' | 'highest') => html`<span class="small">${pageEnglish.locks[end]}</span>
      ${axes.map((axis) =>
        numberInput(
          pageEnglish.locks.place(pageEnglish.locks[end], 'xyz'[axis]),
          box[end][axis],
          this.#size(axis),
          parseNumber,
          (value) => this.#move(box, end, axis, value),
        ),
      )}`;
    return html`<div class="places">${row('lowest')}${row('highest')}</div>
      <button ?disabled=${!this.pinned} title=${pageEnglish.pin.hint} @click=${() => this.#change({ lockBox: this.#proposedBox() })}>
        ${pageEnglish.locks.aroundPin}
      </button>`;
  }

  #regions() {
    const arrays = [...(this.surface?.regions?.keys() ?? [])];
    const { regions } = this.keeping;
    if (arrays.length === 0 && regions === null) return html`<p class="small soft">${pageEnglish.locks.noRegions}</p>`;
    const names = regions === null || arrays.includes(regions) ? arrays : [regions, ...arrays];
    const options = [['', pageEnglish.locks.none], ...names.map((name) => [name, name])];
    return html`
      ${choice(pageEnglish.locks.regions, options, regions ?? '', (name) => this.#change({ regions: name || null, lockRegions: [] }))}
      <p class="small soft">${pageEnglish.locks.regionsMean}</p>
      ${regions === null ? nothing : this.#labels(regions)}
    `;
  }

  #labels(name: string) {
    const { lockRegions } = this.keeping;
    const labels = this.#labelsOf(name);
    if (labels.length === 0) return nothing;
    return html`<fieldset>
      <legend class="small">${pageEnglish.locks.lockRegions}</legend>
      ${labels.map(
        ([label, triangles]) =>
          html`<span title="${countText(triangles)} ${english.triangles(triangles)}"
            >${tick(this.#nameOf(name, label), lockRegions.includes(label), (wanted) => this.#lockRegion(label, wanted))}</span
          >`,
      )}
    </fieldset>`;
  }

  /** What a label of a cell-data array stands for; where nothing says so, its number. */
  #nameOf(array: string, label: number): string {
    return this.surface?.labels.regionNames?.get(array)?.get(label) ?? String(label);
  }

  /** The labels of a cell-data array, rising, and how many triangles have each. */
  #labelsOf(name: string): [label: number, triangles: number][] {
    const of = this.surface?.regions?.get(name);
    if (!of) return [];
    if (this.#counted?.of !== of) {
      const counts = new Map<number, number>();
      for (const label of of) counts.set(label, (counts.get(label) ?? 0) + 1);
      this.#counted = { of, labels: [...counts].sort(([a], [b]) => a - b) };
    }
    return this.#counted.labels;
  }

  #lockPoints(text: string): void {
    try {
      const lockPoints = text.trim() === '' ? [] : readPoints(text);
      if (this.surface) pointsOf(lockPoints, this.surface.mesh.position.length / 3);
      this.refused = null;
      this.#change({ lockPoints });
    } catch (error) {
      this.refused = { text, why: messageOf(error) };
    }
  }

  /** Escape goes back to the points that are locked. */
  #restorePoints({ key, target }: KeyboardEvent, ranges: readonly PointRange[]): void {
    if (key !== 'Escape') return;
    this.refused = null;
    (target as HTMLInputElement).value = pointsText(ranges);
  }

  #addPin(ranges: readonly PointRange[]): void {
    const { surface, pinned } = this;
    if (!surface || !pinned) return;
    const vertex = nearestVertex(surface.mesh, pinned);
    const isLocked = ranges.some(([first, last]) => first <= vertex && vertex <= last);
    this.refused = null;
    if (!isLocked) this.#change({ lockPoints: [...ranges, [vertex, vertex]] });
  }

  #lockRegion(label: number, wanted: boolean): void {
    const others = this.keeping.lockRegions.filter((each) => each !== label);
    this.#change({ lockRegions: wanted ? [...others, label].sort((a, b) => a - b) : others });
  }

  /** Where one end would pass the other, that one goes along, and the box keeps its size. */
  #move({ lowest, highest }: Box, end: 'lowest' | 'highest', axis: number, value: number): void {
    const box: Box = { lowest: [...lowest], highest: [...highest] };
    const size = highest[axis] - lowest[axis];
    box[end][axis] = value;
    if (box.lowest[axis] > box.highest[axis]) {
      const other = end === 'lowest' ? 'highest' : 'lowest';
      box[other][axis] = proposed(end === 'lowest' ? value + size : value - size);
    }
    this.#change({ lockBox: box });
  }

  /** Around what is pinned, or else another place of the surface. */
  #proposedBox(): Box {
    const half = proposedShare * Math.max(...axes.map((axis) => this.#size(axis)));
    const middle = this.pinned ?? (this.surface ? placeInSight(this.surface.mesh) : [0, 0, 0]);
    const [x, y, z] = middle.map((place) => proposed(place - half));
    const [right, top, front] = middle.map((place) => proposed(place + half));
    return { lowest: [x, y, z], highest: [right, top, front] };
  }

  #size(axis: number): number {
    const { lowest, highest } = this.#along(axis);
    return highest - lowest;
  }

  #along(axis: number): ComponentSpan {
    const { surface } = this;
    if (!surface) return { lowest: 0, highest: 1 };
    if (this.#span?.of !== surface) {
      const position = { name: 'position', components: 3, values: surface.mesh.position };
      this.#span = { of: surface, along: spanOf(position, surface.mesh.triangles).components };
    }
    return this.#span.along[axis];
  }

  #change(detail: Partial<Keeping>): void {
    this.dispatchEvent(new CustomEvent('keeping-change', { bubbles: true, composed: true, detail }));
  }
}

customElements.define('meshbound-lock-choice', LockChoice);
