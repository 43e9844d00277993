import { css, html, LitElement, svg } from 'lit';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import { countText, percentText } from '../../element/number-text.ts';
import type { CurvePoint } from '../../session/bounds/bounds-curve.ts';
import { pageEnglish } from '../../words/page-english.ts';

/** The drawing, in its own unit: room for numbers on the left and below. */
const [width, height] = [288, 130];
const [left, right, top, bottom] = [44, 8, 8, 20];

/** The bounds that the chart spans, and where it has marks. */
const [lowest, highest] = [0.0005, 0.25];
const marks = [0.001, 0.01, 0.1];

/** Triangles against bounds, both by their logarithms, with the present bounds on it. */
export class BoundsChart extends LitElement {
  static override properties = {
    points: { attribute: false },
    present: { type: Number },
    most: { type: Number },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: block;
      }
      svg {
        display: block;
        width: 100%;
        margin-top: 6px;
        font-size: 11px;
        fill: var(--ink-soft);
      }
      .grid {
        stroke: var(--line);
      }
      .curve {
        fill: none;
        stroke: var(--accent);
        stroke-width: 1.5;
      }
      .point {
        fill: var(--panel);
        stroke: var(--accent);
        stroke-width: 1.5;
      }
      .present {
        fill: var(--accent);
      }
    `,
  ];

  declare points: readonly CurvePoint[];
  /** The largest bound now. */
  declare present: number;
  /** The triangles of the original. */
  declare most: number;

  constructor() {
    super();
    this.points = [];
    this.present = 0;
    this.most = 1;
  }

  override render() {
    const { points } = this;
    const places = points.map((point) => [this.#x(point.fraction), this.#y(point.triangles)]);
    return html`<svg viewBox="0 0 ${width} ${height}" role="img" aria-label=${this.#words()}>
        ${this.#grid()}
        <polyline class="curve" points=${places.map((place) => place.join()).join(' ')}></polyline>
        ${points.map(
          ({ fraction }, index) =>
            svg`<circle
              class=${fraction === this.present ? 'present' : 'point'}
              cx=${places[index][0]} cy=${places[index][1]} r=${fraction === this.present ? 4.5 : 3}
            ></circle>`,
        )}
      </svg>
      <p class="small soft">${pageEnglish.chart.what}</p>`;
  }

  #grid() {
    const powers = Array.from({ length: Math.floor(Math.log10(this.most)) + 1 }, (_, power) => 10 ** power);
    return [
      ...marks.map((mark) => {
        const x = this.#x(mark);
        return svg`<line class="grid" x1=${x} x2=${x} y1=${top} y2=${height - bottom}></line>
          <text x=${x} y=${height - 6} text-anchor="middle">${percentText(mark)}</text>`;
      }),
      ...powers.map((count) => {
        const y = this.#y(count);
        return svg`<line class="grid" x1=${left} x2=${width - right} y1=${y} y2=${y}></line>
          <text x=${left - 6} y=${y + 4} text-anchor="end">${countText(count)}</text>`;
      }),
    ];
  }

  #words(): string {
    const points = this.points.map(({ fraction, triangles }) =>
      pageEnglish.chart.point(countText(triangles), percentText(fraction)),
    );
    return pageEnglish.chart.points(points);
  }

  #x(fraction: number): number {
    const share = Math.log(Math.min(highest, Math.max(lowest, fraction)) / lowest) / Math.log(highest / lowest);
    return Math.round(10 * (left + share * (width - left - right))) / 10;
  }

  #y(count: number): number {
    const share = Math.log(Math.max(1, count)) / Math.log(Math.max(2, this.most));
    return Math.round(10 * (height - bottom - share * (height - top - bottom))) / 10;
  }
}

customElements.define('meshbound-bounds-chart', BoundsChart);
