import { css, html, LitElement, nothing } from 'lit';
import { live } from 'lit/directives/live.js';
import type { VariableExtent, VariableReport } from '../../../wasm/index.ts';
import { settle } from '../../element/controls/bound-slider.ts';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import { percentOf, percentText, upperText, withUnit } from '../../element/number-text.ts';
import {
  type BoundSetting,
  inUnit,
  parseAmount,
  parsePercent,
  tidy,
  wholeOf,
} from '../../session/bounds/bound-setting.ts';
import { fieldText } from '../../session/bounds/rounding.ts';
import './number-field.ts';
import { pageEnglish } from '../../words/page-english.ts';

/**
 * The bound of one variable and what the result makes of it.
 *
 * @fires bound-change with the new BoundSetting
 * @fires worst-wanted where the error is largest is to be shown
 */
export class BoundRow extends LitElement {
  static override properties = {
    variable: { attribute: false },
    unit: {},
    setting: { attribute: false },
    reached: { attribute: false },
    shownWith: { attribute: false },
    measured: { type: Boolean },
    multiplied: { type: Boolean },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: block;
      }
      .line {
        display: flex;
        gap: 6px;
        align-items: center;
        justify-content: space-between;
      }
      .line.small {
        flex-wrap: wrap;
        gap: 0 6px;
      }
      .other {
        color: var(--fault);
      }
      .name {
        flex: 1;
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
        font-weight: 600;
      }
      label {
        display: flex;
        gap: 6px;
        align-items: center;
        cursor: pointer;
      }
      input {
        margin: 0;
      }
      .in {
        width: 58px;
        padding: 2px 4px;
        text-overflow: ellipsis;
      }
      .error {
        min-height: 0;
        padding: 0;
        white-space: nowrap;
        text-decoration: underline dotted;
        background: none;
        border: none;
      }
      @media (any-pointer: coarse), (max-width: 800px) {
        .error {
          min-height: 24px;
        }
      }
      meshbound-bound-slider {
        margin: 3px 0;
      }
    `,
  ];

  declare variable: VariableExtent;
  declare unit: string | undefined;
  declare setting: BoundSetting;
  /** What the last result reached; null while there is none. */
  declare reached: VariableReport | null;
  /** The bound that the result shown was made with, where that is another one; null where it is this one. */
  declare shownWith: BoundSetting | null;
  /** Whether the error reached was measured; otherwise it is a limit from above. */
  declare measured: boolean;
  /** Whether what differs over the surface multiplies it. */
  declare multiplied: boolean;

  override render() {
    const { name } = this.variable;
    const { fraction, absolute, free } = this.setting;
    const bound = withUnit(upperText(absolute ?? fraction * wholeOf(this.variable)), this.unit);
    return html`
      <div class="line">
        <span class="name" title=${name}>${name}</span>
        <span class="small soft">${this.#marks()}</span>
        ${this.#field()}${this.#unitChoice()}
      </div>
      <meshbound-bound-slider
        label=${pageEnglish.bounds.of(name)}
        spoken="${percentText(fraction)}, ${bound}"
        .fraction=${fraction}
        .used=${free || this.shownWith ? 0 : (this.reached?.ratio ?? 0)}
        ?disabled=${free}
        @bound-input=${({ detail }: CustomEvent<number>) => this.#slide(detail)}
      ></meshbound-bound-slider>
      <div class="line small">
        <label>
          <input type="checkbox" aria-label=${pageEnglish.bounds.isBounded(name)} .checked=${live(!free)} @change=${this.#toggle} />
          <span title=${this.multiplied ? pageEnglish.bounds.multipliedHint : nothing}>
            ${free ? pageEnglish.bounds.bounded : pageEnglish.bounds.by(absolute === undefined ? bound : percentText(fraction), this.multiplied)}
          </span>
        </label>
        ${this.#reached()}
      </div>
    `;
  }

  #field() {
    const { name } = this.variable;
    const { fraction, absolute, free } = this.setting;
    const percent = absolute === undefined;
    return html`<meshbound-number-field
      label=${pageEnglish.bounds.ofIn(name, percent ? pageEnglish.bounds.percent : (this.unit ?? pageEnglish.bounds.itsUnit))}
      .text=${fieldText(percent ? percentOf(fraction) : absolute)}
      exact=${percent ? percentOf(fraction) : absolute}
      .parse=${percent ? parsePercent : parseAmount}
      ?disabled=${free}
      @number-input=${({ detail }: CustomEvent<number>) => {
        this.#change(percent ? { fraction: detail, free } : inUnit(detail, this.variable));
        settle(this);
      }}
    ></meshbound-number-field>`;
  }

  #unitChoice() {
    const { absolute, free } = this.setting;
    return html`<select
      class="in"
      aria-label=${pageEnglish.bounds.stated(this.variable.name)}
      ?disabled=${free}
      @change=${this.#restate}
    >
      <option value="percent" .selected=${live(absolute === undefined)}>%</option>
      <option value="unit" .selected=${live(absolute !== undefined)}>${withUnit('', this.unit).trim() || pageEnglish.bounds.value}</option>
    </select>`;
  }

  /** What there is to know of the variable before it is bounded. */
  #marks() {
    const { constant, kind, nonFinite } = this.variable;
    const words = pageEnglish.bounds;
    const marks: [boolean, string, string][] = [
      [constant, words.constant, words.constantHint],
      [kind === 'identifier', words.identifier, words.identifierHint],
      [nonFinite !== undefined, words.nonFinite, words.nonFiniteHint],
    ];
    return marks.filter(([is]) => is).map(([, text, hint]) => html`<span title=${hint}>${text}</span> `);
  }

  #reached() {
    if (!this.reached) return nothing;
    const { shownWith } = this;
    const other = shownWith
      ? html`<span class="other">${pageEnglish.bounds.shownWith(this.#text(shownWith))}</span> `
      : nothing;
    const { error } = this.reached;
    if (Number.isNaN(error)) {
      return html`<span title=${pageEnglish.bounds.unknownHint}>${other}${pageEnglish.bounds.unknownError}</span>`;
    }
    return html`<span>${other}<button
      class="error"
      title=${pageEnglish.bounds.errorHint}
      @click=${() => this.dispatchEvent(new CustomEvent('worst-wanted'))}
    >
      ${pageEnglish.bounds.error} ${error > 0 ? `≤ ${upperText(error)}` : 0}
    </button></span>`;
  }

  /** A bound as it was stated. */
  #text({ fraction, absolute, free }: BoundSetting): string {
    if (free) return pageEnglish.bounds.free;
    return absolute === undefined ? percentText(fraction) : withUnit(upperText(absolute), this.unit);
  }

  #slide(fraction: number): void {
    const { absolute, free } = this.setting;
    const amount = tidy(fraction * wholeOf(this.variable));
    this.#change(absolute === undefined ? { fraction, free } : inUnit(amount, this.variable));
  }

  /** The same bound, in percent or in the unit. */
  #restate({ target }: Event): void {
    const { fraction, free } = this.setting;
    if ((target as HTMLSelectElement).value === 'percent') this.#change({ fraction, free });
    else this.#change({ fraction, absolute: fraction * wholeOf(this.variable), free });
    settle(this);
  }

  #toggle({ target }: Event): void {
    this.#change({ ...this.setting, free: !(target as HTMLInputElement).checked });
    settle(this);
  }

  #change(setting: BoundSetting): void {
    this.dispatchEvent(new CustomEvent('bound-change', { detail: setting }));
  }
}

customElements.define('meshbound-bound-row', BoundRow);
