import { css, html, LitElement, nothing } from 'lit';
import { settle } from '../element/bound-slider.ts';
import { controlsStyle } from '../element/controls-style.ts';
import type { Parsed } from '../session/bound-setting.ts';

/**
 * A number to type. What cannot be a bound is refused with a reason, and the bound stays as it was.
 *
 * @fires number-input with the number that the text stands for
 */
export class NumberField extends LitElement {
  static override properties = {
    text: {},
    parse: { attribute: false },
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

  /** What stands in the field. */
  declare text: string;
  declare parse: (text: string) => Parsed;
  declare label: string;
  declare disabled: boolean;
  /** Why the last entry was refused. */
  declare fault: string;

  constructor() {
    super();
    this.text = '';
    this.label = '';
    this.disabled = false;
    this.fault = '';
  }

  override willUpdate(changed: Map<string, unknown>): void {
    if (changed.has('text')) this.fault = '';
  }

  override render() {
    return html`<input
        type="text"
        inputmode="decimal"
        autocomplete="off"
        aria-label=${this.label}
        aria-invalid=${this.fault ? 'true' : 'false'}
        aria-describedby="fault"
        .value=${this.text}
        ?disabled=${this.disabled}
        @change=${this.#change}
        @keydown=${this.#keydown}
      />${this.fault ? html`<p id="fault" role="alert">${this.fault}</p>` : nothing}`;
  }

  #change({ target }: Event): void {
    const input = target as HTMLInputElement;
    const parsed = this.parse(input.value);
    if ('fault' in parsed) {
      this.fault = parsed.fault;
      return;
    }
    this.fault = '';
    // Also where the bound is what it was, so that nothing draws the field again.
    input.value = parsed.text;
    this.dispatchEvent(new CustomEvent('number-input', { detail: parsed.value }));
    settle(this);
  }

  /** Escape goes back to the bound that holds. */
  #keydown(event: KeyboardEvent): void {
    if (event.key !== 'Escape') return;
    this.fault = '';
    (event.target as HTMLInputElement).value = this.text;
  }
}

customElements.define('meshbound-number-field', NumberField);
