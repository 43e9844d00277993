import { css, html, LitElement, nothing } from 'lit';
import { live } from 'lit/directives/live.js';
import { controlsStyle } from '../element/controls-style.ts';
import type { Method } from '../session/method.ts';
import { english } from '../words/english.ts';

/**
 * How errors are accounted for, out of the way until it is opened.
 *
 * @fires method-change with the new Method
 */
export class MethodChoice extends LitElement {
  static override properties = { method: { attribute: false } };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: block;
      }
      summary {
        border-radius: var(--radius);
        cursor: pointer;
      }
      label {
        display: flex;
        gap: var(--gap);
        align-items: center;
        justify-content: space-between;
        margin-top: 6px;
      }
      label.tick {
        justify-content: start;
      }
      select {
        width: 198px;
      }
      p {
        margin-top: 6px;
      }
    `,
  ];

  declare method: Method;

  override render() {
    return html`<details @toggle=${() => this.scrollIntoView({ block: 'nearest' })}>
      <summary
        >${english.method.title} <span class="small soft">${english.method.now(this.method.errors)}</span></summary
      >
      ${choice(
        english.method.errors,
        Object.keys(english.method.means).map((name) => [name, name]),
        this.method.errors,
        (chosen) => this.#change({ errors: chosen as Method['errors'] }),
      )}
      ${
        this.method.errors === 'propagated'
          ? choice(english.method.keepsSmall, Object.entries(english.method.costs), this.method.cost, (chosen) =>
              this.#change({ cost: chosen as Method['cost'] }),
            )
          : nothing
      }
      <p class="small soft">${english.method.means[this.method.errors]}</p>
      ${tick(english.method.refusePiercing, this.method.refusePiercing, (refusePiercing) => this.#change({ refusePiercing }))}
      ${tick(english.method.limitToFeatureSize, this.method.limitToFeatureSize, (limitToFeatureSize) =>
        this.#change({ limitToFeatureSize }),
      )}
      <p class="small soft">${english.method.nearParts}</p>
    </details>`;
  }

  #change(change: Partial<Method>): void {
    this.dispatchEvent(new CustomEvent('method-change', { detail: { ...this.method, ...change } }));
  }
}

function choice(label: string, options: string[][], selected: string, choose: (value: string) => void) {
  return html`<label>
    <span>${label}</span>
    <select @change=${({ target }: Event) => choose((target as HTMLSelectElement).value)}>
      ${options.map(
        ([value, text]) => html`<option value=${value} .selected=${live(value === selected)}>${text}</option>`,
      )}
    </select>
  </label>`;
}

function tick(label: string, checked: boolean, change: (checked: boolean) => void) {
  return html`<label class="tick">
    <input
      type="checkbox"
      .checked=${live(checked)}
      @change=${({ target }: Event) => change((target as HTMLInputElement).checked)}
    />
    <span>${label}</span>
  </label>`;
}

customElements.define('meshbound-method-choice', MethodChoice);
