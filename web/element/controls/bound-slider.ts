import { css, html, LitElement } from 'lit';
import { fractionAt, placeOf } from './bound-place.ts';

/** How finely the track is divided: a press of an arrow key changes the bound by 2 %. */
const steps = 330;

/**
 * Sets a bound. Inside its track a bar shows how much of the bound the result uses.
 *
 * @fires bound-input with the chosen fraction
 * @fires bound-settled once it is let go; goes up through all parts of the page
 */
export class BoundSlider extends LitElement {
  static override properties = {
    fraction: { type: Number },
    used: { type: Number },
    label: {},
    spoken: {},
    disabled: { type: Boolean },
  };

  static override styles = css`
    :host {
      display: block;
    }
    input {
      --thumb: 14px;
      --bound: calc(var(--place) * (100% - var(--thumb)) + var(--thumb) / 2);
      display: block;
      width: 100%;
      height: 20px;
      margin: 0;
      appearance: none;
      cursor: pointer;
      border-radius: var(--radius);
      background:
        linear-gradient(var(--accent) 0 0) 0 50% / calc(var(--used) * var(--bound)) 4px,
        linear-gradient(var(--accent-soft) 0 0) 0 50% / var(--bound) 10px,
        linear-gradient(var(--line) 0 0) 0 50% / 100% 10px;
      background-repeat: no-repeat;
    }
    input::-webkit-slider-thumb {
      appearance: none;
      width: var(--thumb);
      height: 20px;
      background: var(--control);
      border: 2px solid var(--accent);
      border-radius: var(--radius);
    }
    input::-moz-range-thumb {
      box-sizing: border-box;
      width: var(--thumb);
      height: 20px;
      background: var(--control);
      border: 2px solid var(--accent);
      border-radius: var(--radius);
    }
    @media (any-pointer: coarse), (max-width: 800px) {
      input {
        height: 24px;
      }
    }
    input:focus-visible {
      outline: 2px solid var(--accent);
      outline-offset: 2px;
    }
    input:disabled {
      cursor: default;
      opacity: 0.45;
    }
  `;

  declare fraction: number;
  /** error / bound of the result, 0…1. */
  declare used: number;
  declare label: string;
  /** What a screen reader says for the chosen place. */
  declare spoken: string;
  declare disabled: boolean;

  constructor() {
    super();
    this.fraction = 1;
    this.used = 0;
    this.label = '';
    this.spoken = '';
    this.disabled = false;
  }

  override render() {
    const place = placeOf(this.fraction);
    return html`<input
      type="range"
      min="0"
      max=${steps}
      step="1"
      aria-label=${this.label}
      aria-valuetext=${this.spoken}
      .style=${`--place:${place};--used:${this.used}`}
      .value=${String(Math.round(place * steps))}
      ?disabled=${this.disabled}
      @input=${this.#input}
      @change=${() => settle(this)}
    />`;
  }

  #input({ target }: Event): void {
    const fraction = fractionAt(Number((target as HTMLInputElement).value) / steps);
    this.dispatchEvent(new CustomEvent('bound-input', { detail: fraction }));
  }
}

/** Says that a bound has come to rest: what follows is another step to undo. */
export function settle(control: EventTarget): void {
  control.dispatchEvent(new CustomEvent('bound-settled', { bubbles: true, composed: true }));
}

customElements.define('meshbound-bound-slider', BoundSlider);
