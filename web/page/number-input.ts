import { html } from 'lit';
import { live } from 'lit/directives/live.js';

/** Steps of the arrow keys in a number that can be anything up to `size`: about fifty, of one digit. */
function stepFor(size: number): number | 'any' {
  return Number((size / 50).toPrecision(1)) || 'any';
}

/**
 * A number of any sign, to type or to change by the arrow keys.
 *
 * @param size how large such numbers can be: it sets the steps
 * @param take told of a new one; false where it cannot be, which is then marked
 */
export function numberInput(label: string, value: number, size: number, take: (value: number) => boolean) {
  return html`<input
    type="number"
    aria-label=${label}
    title=${label}
    step=${stepFor(size)}
    .value=${live(String(value))}
    @change=${({ target }: Event) => {
      const input = target as HTMLInputElement;
      input.setAttribute('aria-invalid', String(!take(input.valueAsNumber)));
    }}
  />`;
}
