import { css, html, LitElement, nothing } from 'lit';
import type { VariableExtent, VariableReport } from '../../wasm/index.ts';
import type { BoundSetting } from '../session/bound-setting.ts';
import './bound-slider.ts';
import { controlsStyle } from './controls-style.ts';
import { percentText, roundedUp, valueText, withUnit } from './number-text.ts';
import './percent-field.ts';
import { wholeOf } from './promise-words.ts';

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
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: block;
      }
      .line {
        display: flex;
        gap: var(--gap);
        align-items: center;
        justify-content: space-between;
      }
      .name {
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
        font-weight: 600;
      }
      label {
        display: flex;
        gap: 4px;
        align-items: center;
        cursor: pointer;
      }
      .numbers {
        min-height: 30px;
        white-space: nowrap;
      }
      meshbound-bound-slider {
        margin: 2px 0;
      }
    `,
  ];

  declare variable: VariableExtent;
  declare unit: string | undefined;
  declare setting: BoundSetting;
  /** What the last result reached; null while there is none. */
  declare reached: VariableReport | null;

  override render() {
    const { name } = this.variable;
    const { fraction, free } = this.setting;
    const bound = withUnit(valueText(fraction * wholeOf(this.variable)), this.unit);
    return html`
      <div class="line">
        <span class="name" title=${name}>${name}</span>
        <label class="small soft">
          <input type="checkbox" aria-label="${name} bounded" .checked=${!free} @change=${this.#toggle} />bounded
        </label>
      </div>
      <meshbound-bound-slider
        label="Bound of ${name}"
        spoken="${percentText(fraction)}, ${bound}"
        .fraction=${fraction}
        .used=${free ? 0 : (this.reached?.ratio ?? 0)}
        ?disabled=${free}
        @bound-input=${this.#input}
      ></meshbound-bound-slider>
      <div class="line numbers">
        <span>
          <meshbound-percent-field
            label="Bound of ${name} in percent"
            .fraction=${fraction}
            ?disabled=${free}
            @bound-input=${this.#input}
          ></meshbound-percent-field>
          <span class="small soft">${free ? 'free' : html`= ${bound}`}</span>
        </span>
        ${this.#reached()}
      </div>
      ${this.variable.constant ? html`<p class="small soft">Constant: percent of its magnitude.</p>` : nothing}
    `;
  }

  #reached() {
    if (!this.reached) return nothing;
    const error = roundedUp(this.reached.error);
    const share = percentText(roundedUp(this.reached.error / wholeOf(this.variable)));
    return html`<span class="small" title="No point of the surface has a larger error than this.">
      error ${withUnit(valueText(error), this.unit)}, ${share}
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
