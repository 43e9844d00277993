import { css, html, LitElement, nothing } from 'lit';
import { live } from 'lit/directives/live.js';
import type { VariableExtent, VariableReport } from '../../wasm/index.ts';
import { type BoundSetting, wholeOf } from '../session/bound-setting.ts';
import '../element/bound-slider.ts';
import { controlsStyle } from '../element/controls-style.ts';
import { percentText, upperText, withUnit } from '../element/number-text.ts';
import '../element/percent-field.ts';

/**
 * The bound of one variable and what the result makes of it.
 *
 * @fires bound-change with the new BoundSetting
 */
export class BoundRow extends LitElement {
  static override properties = {
    variable: { attribute: false },
    unit: {},
    setting: { attribute: false },
    reached: { attribute: false },
    measured: { type: Boolean },
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
      .name {
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
        font-weight: 600;
      }
      .unit {
        flex: 1;
        white-space: nowrap;
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
      .error {
        white-space: nowrap;
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
  /** Whether the error reached was measured; otherwise it is a limit from above. */
  declare measured: boolean;

  override render() {
    const { name } = this.variable;
    const { fraction, free } = this.setting;
    const bound = upperText(fraction * wholeOf(this.variable));
    return html`
      <div class="line">
        <span class="name" title=${name}>${name}</span>
        <span class="unit small soft">${withUnit('', this.unit)}${this.#constant()}</span>
        <meshbound-percent-field
          label="Bound of ${name} in percent"
          .fraction=${fraction}
          ?disabled=${free}
          @bound-input=${this.#input}
        ></meshbound-percent-field>
      </div>
      <meshbound-bound-slider
        label="Bound of ${name}"
        spoken="${percentText(fraction)}, ${withUnit(bound, this.unit)}"
        .fraction=${fraction}
        .used=${free ? 0 : (this.reached?.ratio ?? 0)}
        ?disabled=${free}
        @bound-input=${this.#input}
      ></meshbound-bound-slider>
      <div class="line small">
        <label>
          <input type="checkbox" aria-label="${name} bounded" .checked=${live(!free)} @change=${this.#toggle} />
          <span>bounded${free ? '' : html` by ${withUnit(bound, this.unit)}`}</span>
        </label>
        ${this.#reached()}
      </div>
    `;
  }

  #constant() {
    if (!this.variable.constant) return nothing;
    return html` <span title="Its values differ by rounding only: the percentage is of their magnitude.">constant</span>`;
  }

  #reached() {
    if (!this.reached) return nothing;
    return html`<span class="error" title="No point of the surface has a larger error than this.">
      error ${this.measured ? '' : '≤ '}${upperText(this.reached.error)}
    </span>`;
  }

  #input({ detail }: CustomEvent<number>): void {
    this.#change({ ...this.setting, fraction: detail });
  }

  #toggle({ target }: Event): void {
    this.#change({ ...this.setting, free: !(target as HTMLInputElement).checked });
  }

  #change(setting: BoundSetting): void {
    this.dispatchEvent(new CustomEvent('bound-change', { detail: setting }));
  }
}

customElements.define('meshbound-bound-row', BoundRow);
