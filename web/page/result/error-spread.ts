import { css, html, LitElement, nothing, svg } from 'lit';
import type { Mesh, Report, VariableReport } from '../../../wasm/types.ts';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import { countText, percentText, upperShareText } from '../../element/number-text.ts';
import { isMeasured } from '../../element/result/guarantee-words.ts';
import { type ErrorHistogram, errorHistograms, histogramBins } from '../../probe/error-histogram.ts';
import type { Multiplied } from '../../probe/multiplied.ts';
import { pageEnglish } from '../../words/page-english.ts';

/** Of a drawing, in its own unit. */
const [width, height] = [280, 32];

function foldsText({ cells, foldedCells }: Report): string {
  const share = foldedCells > 0 ? percentText(foldedCells / cells) : null;
  return pageEnglish.spread.folds(countText(cells), countText(foldedCells), share);
}

/** How the errors of each variable are spread over the surface: a histogram of error / bound by area. */
export class ErrorSpread extends LitElement {
  static override properties = {
    mesh: { attribute: false },
    reduction: { attribute: false },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: block;
      }
      .name {
        display: flex;
        gap: var(--gap);
        justify-content: space-between;
        margin-top: 8px;
      }
      .name span:first-child {
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      .quantiles {
        white-space: nowrap;
      }
      svg {
        display: block;
        width: 100%;
        border-bottom: 1px solid var(--control-line);
      }
      .part {
        fill: var(--accent);
      }
      .largest {
        stroke: var(--ink);
        stroke-dasharray: 2 2;
      }
      .ends {
        display: flex;
        justify-content: space-between;
      }
    `,
  ];

  declare mesh: Mesh | null;
  declare reduction: Multiplied | null;
  #histograms: (ErrorHistogram | null)[] = [];

  constructor() {
    super();
    this.mesh = null;
    this.reduction = null;
  }

  override willUpdate(changed: Map<string, unknown>): void {
    if (!changed.has('mesh') && !changed.has('reduction')) return;
    this.#histograms = this.mesh && this.reduction ? errorHistograms(this.mesh, this.reduction) : [];
  }

  override render() {
    const { reduction } = this;
    if (!reduction) return nothing;
    return html`
      ${reduction.report.variables.map((variable, index) => this.#drawing(variable, this.#histograms[index]))}
      <div class="ends small soft"><span>0</span><span>${pageEnglish.spread.axis}</span><span>1</span></div>
      <p class="small soft">${pageEnglish.spread.what(isMeasured(reduction))}</p>
      ${reduction.report.cells > 0 ? html`<p class="folds small soft">${foldsText(reduction.report)}</p>` : nothing}
    `;
  }

  #drawing({ name, ratio }: VariableReport, histogram: ErrorHistogram | null) {
    if (!histogram)
      return html`<div class="name small"><span>${name}</span><span class="soft">${pageEnglish.spread.free}</span></div>`;
    const [half, most] = [histogram.half, histogram.most].map(upperShareText);
    const words = pageEnglish.spread.long(half, most);
    return html`<div class="name small" title=${words}>
        <span>${name}</span><span class="quantiles soft">${pageEnglish.spread.short(half, most)}</span>
      </div>
      <svg viewBox="0 0 ${width} ${height}" preserveAspectRatio="none" role="img" aria-label="${name}: ${words}">
        ${this.#parts(histogram.parts)}
        <line class="largest" x1=${ratio * width} x2=${ratio * width} y1="0" y2=${height}></line>
      </svg>`;
  }

  #parts(parts: Float64Array) {
    const highest = Math.max(...parts);
    const step = width / histogramBins;
    return Array.from(parts, (share, index) => {
      const size = highest > 0 ? (share / highest) * (height - 1) : 0;
      return svg`<rect class="part" x=${index * step + 0.5} y=${height - size} width=${step - 1} height=${size}></rect>`;
    });
  }
}

customElements.define('meshbound-error-spread', ErrorSpread);
