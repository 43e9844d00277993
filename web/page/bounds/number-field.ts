import { css, html, LitElement, nothing } from 'lit';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import type { Parsed } from '../../session/bounds/bound-setting.ts';

/** Steps of the arrow keys in a number that can be anything up to `size`: about fifty, of one digit. */
function stepFor(size: number): number | 'any' {
  return Number((size / 50).toPrecision(1)) || 'any';
}

/**
 * A number to type. What cannot be is refused with a reason, and the number stays as it was.
 *
 * @fires number-input with the number that the text stands for
 */
export class NumberField extends LitElement {
  static override properties = {
    text: {},
    exact: {},
    parse: { attribute: false },
    label: {},
    size: { attribute: false },
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
        /* Four significant digits with an exponent have room: “−1.234e−10”. */
        width: calc(9ch + 14px);
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
        /* It ends at the number, and must not begin left of the panel. What lies under it stays in reach. */
        max-width: 220px;
        pointer-events: none;
        padding: 4px 8px;
        color: var(--fault);
        background: var(--fault-soft);
        border: 1px solid var(--fault);
        border-radius: var(--radius);
        font-size: var(--text-small);
      }
      :host([in-grid]) {
        display: contents;
      }
      :host([in-grid]) input {
        width: 100%;
        min-width: 0;
        min-height: 28px;
        padding: 2px 4px;
        font-size: var(--text-small);
        text-align: start;
        background: var(--control);
        border: 1px solid var(--control-line);
        border-radius: var(--radius);
        /* The arrow keys do what its arrows would, which take the room of the number. */
        appearance: textfield;
      }
      ::-webkit-inner-spin-button {
        appearance: none;
      }
      :host([in-grid]) input[aria-invalid='true'] {
        border-color: var(--fault);
      }
      :host([in-grid]) p {
        position: static;
        grid-column: 1 / -1;
        width: auto;
        max-width: none;
      }
    `,
  ];

  /** What stands in the field. */
  declare text: string;
  /** The same with all of its digits, where the field has no room for them. */
  declare exact: string;
  declare parse: (text: string) => Parsed;
  declare label: string;
  /** How large the number can be, where the arrow keys change it: it sets their steps. */
  declare size: number | null;
  declare disabled: boolean;
  /** Why the last entry was refused. */
  declare fault: string;

  constructor() {
    super();
    this.text = '';
    this.exact = '';
    this.label = '';
    this.size = null;
    this.disabled = false;
    this.fault = '';
  }

  override willUpdate(changed: Map<string, unknown>): void {
    if (changed.has('text')) this.fault = '';
  }

  override render() {
    return html`<input
        type=${this.size === null ? 'text' : 'number'}
        step=${this.size === null ? nothing : stepFor(this.size)}
        inputmode="decimal"
        autocomplete="off"
        aria-label=${this.label}
        title=${this.size === null ? this.#exactTitle() : this.label}
        aria-invalid=${this.fault ? 'true' : 'false'}
        aria-describedby="fault"
        .value=${this.text}
        ?disabled=${this.disabled}
        @change=${this.#change}
        @keydown=${this.#keydown}
      />${this.fault ? html`<p id="fault" role="alert">${this.fault}</p>` : nothing}`;
  }

  #exactTitle() {
    return this.exact && this.exact !== this.text ? this.exact : nothing;
  }

  #change({ target }: Event): void {
    const input = target as HTMLInputElement;
    const parsed = this.parse(input.value);
    if ('fault' in parsed) {
      this.fault = parsed.fault;
      return;
    }
    this.fault = '';
    // Also where the number is what it was, so that nothing draws the field again.
    input.value = parsed.text;
    this.dispatchEvent(new CustomEvent('number-input', { detail: parsed.value }));
  }

  /** Escape goes back to the number that holds. */
  #keydown(event: KeyboardEvent): void {
    if (event.key !== 'Escape') return;
    this.fault = '';
    (event.target as HTMLInputElement).value = this.text;
  }
}

customElements.define('meshbound-number-field', NumberField);
