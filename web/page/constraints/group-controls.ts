import { html } from 'lit';
import { live } from 'lit/directives/live.js';

/** A choice among values with their texts. */
export function choice(label: string, options: string[][], selected: string, choose: (value: string) => void) {
  return html`<label>
    <span>${label}</span>
    <select @change=${({ target }: Event) => choose((target as HTMLSelectElement).value)}>
      ${options.map(
        ([value, text]) => html`<option value=${value} .selected=${live(value === selected)}>${text}</option>`,
      )}
    </select>
  </label>`;
}

export function tick(label: string, checked: boolean, change: (checked: boolean) => void) {
  return html`<label class="tick">
    <input
      type="checkbox"
      .checked=${live(checked)}
      @change=${({ target }: Event) => change((target as HTMLInputElement).checked)}
    />
    <span>${label}</span>
  </label>`;
}
