import { css, html, LitElement, nothing } from 'lit';
import { controlsStyle } from '../element/controls-style.ts';
import { percentNumber } from '../element/number-text.ts';
import { parsePercent } from '../session/bound-setting.ts';

/**
 * A percentage to type. What cannot be a bound is refused with a reason, and the bound stays as it was.
 *
 * @fires bound-input with the typed fraction
 */
export class PercentField extends LitElement {
  static override properties = {
    fraction: { type: Number },
    label: {},
    disabled: { type: Boolean },
    fault: { state: true },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: inline-block;
        position: relative;
      }
      input {
        width: 58px;
        text-align: right;
      }
      input[aria-invalid='true'] {
        border-color: var(--fault);
        outline-color: var(--fault);
      }
      p {
        position: absolute;
        z-index: 2;
        top: calc(100% + 4px);
        right: 0;
        width: max-content;
        max-width: 260px;
        padding: 4px 8px;
        color: var(--fault);
        background: var(--fault-soft);
        border: 1px solid var(--fault);
        border-radius: var(--radius);
        font-size: var(--text-small);
      }
    `,
  ];

  declare fraction: number;
  declare label: string;
  declare disabled: boolean;
  /** Why the last entry was refused. */
  declare fault: string;

  constructor() {
    super();
    this.fraction = 0;
    this.label = '';
    this.disabled = false;
    this.fault = '';
  }

  override willUpdate(changed: Map<string, unknown>): void {
    if (changed.has('fraction')) this.fault = '';
  }

  override render() {
    return html`<input
        type="text"
        inputmode="decimal"
        autocomplete="off"
        aria-label=${this.label}
        aria-invalid=${this.fault ? 'true' : 'false'}
        aria-describedby="fault"
        .value=${percentNumber(this.fraction)}
        ?disabled=${this.disabled}
        @change=${this.#change}
        @keydown=${this.#keydown}
      />&#8239;%${this.fault ? html`<p id="fault" role="alert">${this.fault}</p>` : nothing}`;
  }

  #change({ target }: Event): void {
    const input = target as HTMLInputElement;
    const parsed = parsePercent(input.value);
    if ('fault' in parsed) {
      this.fault = parsed.fault;
      return;
    }
    this.fault = '';
    // Also where the bound is what it was, so that nothing draws the field again.
    input.value = percentNumber(parsed.fraction);
    this.dispatchEvent(new CustomEvent('bound-input', { detail: parsed.fraction }));
  }

  /** Escape goes back to the bound that holds. */
  #keydown(event: KeyboardEvent): void {
    if (event.key !== 'Escape') return;
    this.fault = '';
    (event.target as HTMLInputElement).value = percentNumber(this.fraction);
  }
}

customElements.define('meshbound-percent-field', PercentField);
