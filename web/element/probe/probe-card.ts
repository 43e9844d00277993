import { css, html, LitElement, nothing } from 'lit';
import type { Labels } from '../../formats/surface.ts';
import type { ProbedVariable } from '../../probe/probe.ts';
import { tellingDigits } from '../../session/bounds/rounding.ts';
import { nothingProbed, type ProbeState } from '../../session/probing.ts';
import { english } from '../../words/english.ts';
import { controlsStyle } from '../controls/controls-style.ts';
import { placeErrorText, usedShareText, valueText } from '../number-text.ts';

/** Significant digits of values: enough to see a difference within usual bounds, and more where they are far from 0. */
const valueDigits = 4;

/**
 * What stands at a place of both surfaces, a row for each variable.
 *
 * @fires worst-wanted with the name of a variable: where its error is largest is to be shown
 * @fires unpin
 */
export class ProbeCard extends LitElement {
  static override properties = {
    state: { attribute: false },
    labels: { attribute: false },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: block;
        padding: 4px 10px 6px;
        /* Not opaque: where such a card can be scrolled, Chromium takes the canvas below it for hidden, beyond its edges. */
        background: color-mix(in srgb, var(--panel) 98%, transparent);
        border: 1px solid var(--line);
        border-radius: var(--radius);
        font-size: var(--text-small);
        line-height: 1.3;
        pointer-events: none;
      }
      :host([pinned]) {
        border-color: var(--control-line);
        pointer-events: auto;
      }
      thead button {
        min-height: 20px;
        margin-left: 4px;
        padding: 0 6px;
        color: var(--ink);
      }
      /* The columns stay where they are whatever the values, and the rows: each component has a line. */
      table {
        width: 100%;
        table-layout: fixed;
        border-collapse: collapse;
      }
      col.name {
        width: 28%;
      }
      col.value {
        width: 19%;
      }
      th,
      td {
        padding: 1px 0 1px 8px;
        font-weight: inherit;
        text-align: right;
        vertical-align: top;
        white-space: nowrap;
      }
      thead th {
        vertical-align: bottom;
      }
      th:first-child {
        padding-left: 0;
        text-align: left;
      }
      th[scope='row'] {
        overflow: hidden;
        text-overflow: ellipsis;
      }
      td span {
        display: block;
      }
      td.share {
        background: linear-gradient(var(--accent) 0 0) 8px 1.3em / calc(var(--share) * (100% - 8px)) 2px no-repeat;
      }
      tbody button {
        min-height: 0;
        padding: 0;
        text-decoration: underline dotted;
        background: none;
        border: none;
      }
      /* The legend has the unit of what is coloured. */
      @container (max-width: 480px) {
        :host {
          padding: 4px 6px;
          font-size: 11.5px;
        }
        col.name,
        col.value {
          width: 22%;
        }
        th,
        td {
          padding-left: 4px;
        }
        thead th {
          white-space: normal;
        }
        th .soft {
          display: none;
        }
      }
    `,
  ];

  declare state: ProbeState;
  declare labels: Labels | null;

  constructor() {
    super();
    this.state = nothingProbed;
    this.labels = null;
  }

  override render() {
    const { probe, pinned } = this.state;
    if (!probe) return nothing;
    return html`
      <table>
        <colgroup>
          <col class="name" />
          <col class="value" span="2" />
          <col span="2" />
        </colgroup>
        <thead class="soft">
          <tr>
            <th scope="col">${pinned ? this.#unpin() : english.probe.pin}</th>
            <th scope="col">${english.probe.original}</th>
            <th scope="col">${english.probe.reduced}</th>
            <th scope="col">${english.probe.error}${this.#isLimit ? '\u00a0\u2264' : ''}</th>
            <th scope="col">${english.probe.ofBound}</th>
          </tr>
        </thead>
        <tbody>${probe.variables.map((variable) => this.#row(variable))}</tbody>
      </table>
      ${probe.preimages > 1 ? this.#fold(probe.preimages) : nothing}
    `;
  }

  #unpin() {
    return html`${english.probe.pinned}
      <button title=${english.probe.letGo} @click=${() => this.dispatchEvent(new CustomEvent('unpin'))}>${english.probe.unpin}</button>`;
  }

  /** Without the place on the original only the limit of a whole triangle is known. */
  get #isLimit(): boolean {
    const { probe, pending } = this.state;
    return !pending && probe !== null && probe.original === null;
  }

  #row(variable: ProbedVariable) {
    const { name, error, bound, ratio } = variable;
    const unit = this.labels?.units[name];
    const free = !Number.isFinite(bound) && this.state.probe?.reduced != null;
    // While the map is made, an error would be that of a triangle, and jump.
    const known = !this.state.pending;
    return html`<tr>
      <th scope="row" title=${name}>${this.#name(name)}${unit && unit !== '1' ? html` <span class="soft">[${unit}]</span>` : nothing}</th>
      <td>${this.#values(variable.original, variable)}</td>
      <td>${this.#values(variable.reduced, variable)}</td>
      <td>${known && error !== null ? placeErrorText(error, ratio) : this.#unknown}</td>
      <td class="share" .style=${`--share:${known ? Math.min(1, ratio ?? 0) : 0}`}>
        ${free ? english.probe.free : known && ratio !== null ? usedShareText(ratio) : this.#unknown}
      </td>
    </tr>`;
  }

  #name(name: string) {
    if (!this.state.pinned || this.#hasNoErrors) return name;
    return html`<button
      title=${english.probe.toWorst(name)}
      @click=${() => this.dispatchEvent(new CustomEvent('worst-wanted', { detail: name }))}
    >
      ${name}
    </button>`;
  }

  get #hasNoErrors(): boolean {
    return !this.state.probe?.reduced && !this.state.pending;
  }

  #values(values: number[] | null, { bound, error }: ProbedVariable) {
    if (!values) return this.#unknown;
    const step = Number.isFinite(bound) ? bound : (error ?? 0);
    return values.map((value) => html`<span>${valueText(value, tellingDigits(value, step, valueDigits))}</span>`);
  }

  get #unknown(): string {
    return this.state.pending ? '…' : '–';
  }

  #fold(preimages: number) {
    const isLargest = this.state.probe?.from === 'reduced';
    return html`<div class="soft">${english.probe.folded(preimages, isLargest)}</div>`;
  }
}

customElements.define('meshbound-probe-card', ProbeCard);
