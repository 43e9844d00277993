import { css, html, LitElement, nothing } from 'lit';
import type { Deviation, Report, Verdict } from '../../../wasm/types.ts';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import { countText, upperShareText } from '../../element/number-text.ts';
import { notVerified, type VerifyState } from '../../session/verifying.ts';
import { pageEnglish } from '../../words/page-english.ts';
import { groupStyle } from '../constraints/group-style.ts';

const words = pageEnglish.verification;

/**
 * Has the result judged by the judge who knows nothing of the reduction, and says what was found.
 *
 * @fires verify
 * @fires verify-cancel
 */
export class Verification extends LitElement {
  static override properties = {
    report: { attribute: false },
    state: { attribute: false },
    disabled: { type: Boolean },
  };

  static override styles = [
    controlsStyle,
    groupStyle,
    css`
      dl {
        display: grid;
        grid-template-columns: auto 1fr;
        gap: 2px 12px;
        margin: 6px 0 0;
      }
      dt {
        overflow-wrap: anywhere;
      }
      dd {
        margin: 0;
      }
      .broken {
        color: var(--fault);
      }
    `,
  ];

  /** Of the result that is shown; null where there is none. */
  declare report: Report | null;
  declare state: VerifyState;
  /** A reduction runs: the result is about to be another one. */
  declare disabled: boolean;

  constructor() {
    super();
    this.report = null;
    this.state = notVerified;
    this.disabled = false;
  }

  override render() {
    const { report } = this;
    if (!report) return html``;
    const isWhole = report.dropped.components === 0;
    return html`<details @toggle=${() => this.scrollIntoView({ block: 'nearest' })}>
      <summary>${words.title} <span class="small soft">${this.#now()}</span></summary>
      <p class="small soft">${isWhole ? words.what : words.dropped}</p>
      ${isWhole ? this.#button() : nothing}
      <div role="status">${this.#found(report)}</div>
    </details>`;
  }

  #now(): string {
    const { progress, verdict, fault } = this.state;
    if (progress !== null) return words.progress(Math.round(100 * progress));
    if (verdict) return verdict.withinBounds ? words.now.holds : words.now.broken;
    return fault === null ? words.now.notYet : words.now.fault;
  }

  #button() {
    if (this.state.progress !== null)
      return html`<button @click=${() => this.#fire('verify-cancel')}>${words.cancel}</button>`;
    return html`<button ?disabled=${this.disabled} @click=${() => this.#fire('verify')}>${words.verify}</button>`;
  }

  #found(report: Report) {
    const { verdict, fault } = this.state;
    if (fault !== null) return html`<p class="small broken">${fault}</p>`;
    if (!verdict) return nothing;
    const { surface, boundary, withinBounds } = verdict;
    const names = report.variables.map(({ name }) => name);
    const rows = [
      [words.surface.fromOriginal, surface.fromOriginal],
      [words.surface.fromReduced, surface.fromReduced],
      [words.boundary.fromOriginal, boundary.fromOriginal],
      [words.boundary.fromReduced, boundary.fromReduced],
    ] as const;
    return html`<p class="small ${withinBounds ? '' : 'broken'}">
        ${withinBounds ? words.holds(countText(samplesOf(verdict))) : words.broken}
      </p>
      <dl class="small">${rows.map(
        ([title, found]) => html`<dt class="soft">${title}</dt><dd>${farthest(found, names, withinBounds)}</dd>`,
      )}</dl>`;
  }

  #fire(event: string): void {
    this.dispatchEvent(new CustomEvent(event, { bubbles: true, composed: true }));
  }
}

/** Ratios are too large by a rounding that the judge allows for: where he finds the bounds kept, none is shown as above 100 %. */
function farthest({ ratio, variable, samples }: Deviation, names: readonly string[], withinBounds: boolean): string {
  if (samples === 0) return Number.isFinite(ratio) ? words.nothing : words.nothingNear;
  const share = upperShareText(withinBounds ? Math.min(1, ratio) : ratio);
  return ratio > 0 ? words.farthest(share, names[variable]) : share;
}

function samplesOf({ surface, boundary }: Verdict): number {
  const both = [surface, boundary].flatMap(({ fromOriginal, fromReduced }) => [fromOriginal, fromReduced]);
  return both.reduce((sum, { samples }) => sum + samples, 0);
}

customElements.define('meshbound-verification', Verification);
