import { html } from 'lit';
import type { Parsed } from '../../session/bounds/bound-setting.ts';
import { readDecimal } from '../../session/bounds/decimal.ts';
import { pageEnglish } from '../../words/page-english.ts';
import '../bounds/number-field.ts';

/**
 * A number in a grid, to type or to change by the arrow keys. What cannot be is refused with a reason, below its row.
 *
 * @param size how large such numbers can be: it sets the steps
 */
export function numberInput(
  label: string,
  value: number,
  size: number,
  parse: (text: string) => Parsed,
  take: (value: number) => void,
) {
  return html`<meshbound-number-field
    in-grid
    label=${label}
    .text=${String(value)}
    .size=${size}
    .parse=${parse}
    @number-input=${({ detail }: CustomEvent<number>) => take(detail)}
  ></meshbound-number-field>`;
}

/** Any number. */
export function parseNumber(text: string): Parsed {
  const value = readDecimal(text);
  return Number.isFinite(value) ? { value, text: String(value) } : { fault: pageEnglish.numbers.none };
}

/** A number within a range, or what is said of those that are not. */
export function parseWithin(isWithin: (value: number) => boolean, fault: string): (text: string) => Parsed {
  return (text) => {
    const parsed = parseNumber(text);
    return 'fault' in parsed || isWithin(parsed.value) ? parsed : { fault };
  };
}
