import { css, html, LitElement, nothing } from 'lit';
import { cssColour, cssGradient } from '../../colour/colormaps.ts';
import { placeIn, roundTicks } from '../../colour/colour-range.ts';
import { controlsStyle } from '../controls/controls-style.ts';
import { tickText } from '../number-text.ts';
import type { Meaning } from '../stage/colouring.ts';
import { type LegendEnd, legendEnds } from './legend-ends.ts';

/** About how many numbers stand under the bar, its ends not counted. */
const tickCount = 4;

/** What the colours of a surface mean, in numbers. */
export class Legend extends LitElement {
  static override properties = { meaning: { attribute: false } };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: block;
        width: min(260px, 100%);
        padding: 6px 14px 4px;
        background: var(--veil);
        border-radius: var(--radius);
        font-size: var(--text-small);
      }
      .title {
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      .bar {
        height: 10px;
        margin-top: 3px;
        border-radius: 2px;
      }
      .ticks {
        position: relative;
        height: 20px;
      }
      .ticks span {
        position: absolute;
        padding-top: 4px;
        transform: translateX(-50%);
        white-space: nowrap;
      }
      .ticks span::before {
        content: '';
        position: absolute;
        top: 0;
        left: 50%;
        height: 4px;
        border-left: 1px solid var(--ink-soft);
      }
      .ends {
        display: flex;
        justify-content: space-between;
        white-space: nowrap;
      }
      /* Where the surface has little room, the ticks must do. */
      @container (max-width: 480px) {
        .ticks span:nth-child(even) {
          display: none;
        }
        :host {
          width: auto;
          padding: 3px 12px 0;
        }
        .title,
        .detail {
          display: inline;
          white-space: normal;
        }
        .detail::before {
          content: '· ';
        }
        /* What has a colour of its own is told all the same. */
        .ends.value span:not(.swatch, :has(.swatch)) {
          display: none;
        }
      }
      .swatch {
        display: inline-block;
        width: 10px;
        height: 10px;
        margin-right: 4px;
        border-radius: 2px;
      }
    `,
  ];

  declare meaning: Meaning | null;

  constructor() {
    super();
    this.meaning = null;
  }

  override render() {
    if (!this.meaning) return nothing;
    const { title, detail, unit, map, range } = this.meaning;
    const ticks = roundTicks(range, tickCount);
    return html`
      <div class="title" part="title">${unit && unit !== '1' ? `${title} [${unit}]` : title}</div>
      ${detail ? html`<div class="detail soft">${detail}</div>` : nothing}
      <div class="bar" part="bar" .style=${`background:${cssGradient(map, 'to right')}`}></div>
      <div class="ticks" part="ticks">
        ${ticks.map((tick) => html`<span .style=${`left:${100 * placeIn(range, tick)}%`}>${tickText(tick, range)}</span>`)}
      </div>
      ${this.#below(this.meaning)}
    `;
  }

  #below(meaning: Meaning) {
    return html`<div class="ends soft ${meaning.quantity}">${legendEnds(meaning).map(endTemplate)}</div>`;
  }
}

function endTemplate({ text, colour }: LegendEnd) {
  if (!colour) return html`<span>${text}</span>`;
  return html`<span><span class="swatch" .style=${`background:${cssColour(colour)}`}></span>${text}</span>`;
}

customElements.define('meshbound-legend', Legend);
