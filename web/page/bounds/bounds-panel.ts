import { css, html, LitElement, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import type { Report, VariableExtent } from '../../../wasm/index.ts';
import {
  type BoundSetting,
  type BoundSettings,
  boundsThatFit,
  largestFraction,
  parsePercent,
  sameSetting,
} from '../../session/bounds/bound-setting.ts';
import { type Bounds, readBounds } from '../../session/bounds/bound-text.ts';
import type { CurvePoint } from '../../session/bounds/bounds-curve.ts';
import { isMultiplied, type Keeping, nothingKept } from '../../session/constraints/keeping.ts';
import type { Method } from '../../session/constraints/method.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import { notVerified, type VerifyState } from '../../session/verifying.ts';
import './bound-row.ts';
import './bounds-chart.ts';
import '../result/error-spread.ts';
import { settle } from '../../element/controls/bound-slider.ts';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import '../toolbar/menu.ts';
import '../constraints/method-choice.ts';
import './number-field.ts';
import { percentOf, percentText } from '../../element/number-text.ts';
import { fieldText } from '../../session/bounds/rounding.ts';
import '../constraints/multiplier-choice.ts';
import '../result/held-back.ts';
import '../constraints/lock-choice.ts';
import '../result/result-report.ts';
import '../result/verification.ts';
import type { Multiplied } from '../../probe/multiplied.ts';
import { english } from '../../words/english.ts';
import { pageEnglish } from '../../words/page-english.ts';

/** What the panel asks for: the bound of one variable, the largest of all with the others in proportion, or all. */
export type BoundChange = { variable: string; setting: BoundSetting } | { all: number } | { bounds: Bounds };

/** Mixes of bounds to begin with. */
const presets = [
  { ...pageEnglish.bounds.presetNames.fine, bounds: 'position: 0.1%; *: 0.3%' },
  { ...pageEnglish.bounds.presetNames.usual, bounds: 'position: 1%; *: 3%' },
  { ...pageEnglish.bounds.presetNames.coarse, bounds: 'position: 3%; *: 9%' },
  { ...pageEnglish.bounds.presetNames.alike, bounds: '*: 1%' },
  { ...pageEnglish.bounds.presetNames.shape, bounds: 'position: 1%; *: free' },
];

/**
 * What holds the result back, a row that moves all bounds, one for each variable of the surface, and groups for what is rarer.
 *
 * @fires bounds-change with a BoundChange
 * @fires worst-wanted with the name of a variable: where its error is largest is to be shown
 * @fires chart-toggle with whether the chart of triangles against bounds is to be seen
 * @fires verify from meshbound-verification, as is verify-cancel
 * @fires undo
 * @fires redo
 * @fires method-change with a Method
 * @fires keeping-change with what of the Keeping is another
 */
export class BoundsPanel extends LitElement {
  static override properties = {
    surface: { attribute: false },
    bounds: { attribute: false },
    method: { attribute: false },
    keeping: { attribute: false },
    pinned: { attribute: false },
    report: { attribute: false },
    shownBounds: { attribute: false },
    unusedLockedBoxes: { attribute: false },
    reduction: { attribute: false },
    spreadShown: { state: true },
    measured: { type: Boolean },
    verification: { attribute: false },
    busy: { type: Boolean },
    curve: { attribute: false },
    canUndo: { type: Boolean },
    canRedo: { type: Boolean },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: block;
        padding: 12px 16px;
      }
      .row {
        padding: 5px 0;
        border-top: 1px solid var(--line);
      }
      h2 {
        flex: 1;
        font-weight: 600;
      }
      .head {
        display: flex;
        gap: 6px;
        align-items: center;
        margin-bottom: 6px;
      }
      .all {
        display: grid;
        grid-template-columns: 1fr auto;
        gap: 2px var(--gap);
        align-items: center;
        padding-bottom: 8px;
      }
      .all meshbound-bound-slider {
        grid-column: 1 / -1;
      }
      summary {
        border-radius: var(--radius);
        cursor: pointer;
      }
      .chart,
      .spread,
      meshbound-lock-choice,
      meshbound-multiplier-choice,
      meshbound-result-report,
      meshbound-verification,
      meshbound-method-choice {
        padding: 8px 0;
        border-top: 1px solid var(--line);
      }
    `,
  ];

  declare surface: OpenSurface | null;
  declare bounds: BoundSettings;
  declare method: Method;
  declare keeping: Keeping;
  /** The place on the original that is pinned. */
  declare pinned: readonly number[] | null;
  declare report: Report | null;
  /** What the result shown was made with, where that is not what is asked for; else null. */
  declare shownBounds: BoundSettings | null;
  /** Of the last reduction from the original: a provisional answer knows only what its box meets on the way there. */
  declare unusedLockedBoxes: readonly number[];
  /** What the report is of. */
  declare reduction: Multiplied | null;
  /** Whether the spread of errors is to be seen: it is not worked out for nobody. */
  declare spreadShown: boolean;
  /** Whether the errors of the report were measured; otherwise they are limits from above. */
  declare measured: boolean;
  /** What the judge said of the result that is shown. */
  declare verification: VerifyState;
  /** A reduction runs. */
  declare busy: boolean;
  /** Triangles against bounds, as far as measured. */
  declare curve: readonly CurvePoint[];
  declare canUndo: boolean;
  declare canRedo: boolean;

  constructor() {
    super();
    this.surface = null;
    this.bounds = {};
    this.keeping = nothingKept;
    this.pinned = null;
    this.report = null;
    this.shownBounds = null;
    this.unusedLockedBoxes = [];
    this.reduction = null;
    this.spreadShown = false;
    this.measured = true;
    this.verification = notVerified;
    this.busy = false;
    this.curve = [];
    this.canUndo = false;
    this.canRedo = false;
  }

  override render() {
    if (!this.surface) return html`<h2>${english.bounds.title}</h2>`;
    const variables = this.surface.variables;
    return html`
      <div class="head">
        <h2>${english.bounds.title}</h2>
        ${this.#steps()} ${this.#presets()}
      </div>
      <meshbound-held-back .report=${this.report}></meshbound-held-back>
      ${this.#all()}
      ${repeat(
        variables,
        ({ name }) => name,
        (variable, index) => this.#row(variable, index),
      )}
      ${this.#spread()} ${this.#chart()}
      <meshbound-result-report
        .report=${this.report}
        .method=${this.method}
        .unit=${this.surface.labels.units.position}
        .names=${this.surface.labels.regionNames?.get(this.keeping.regions ?? '')}
      ></meshbound-result-report>
      <meshbound-verification
        .report=${this.report}
        .state=${this.verification}
        ?disabled=${this.busy}
      ></meshbound-verification>
      <meshbound-lock-choice
        .surface=${this.surface}
        .keeping=${this.keeping}
        .pinned=${this.pinned}
        ?isUnmet=${this.keeping.lockBox !== null && this.unusedLockedBoxes.includes(0)}
      ></meshbound-lock-choice>
      <meshbound-multiplier-choice
        .surface=${this.surface}
        .keeping=${this.keeping}
        .pinned=${this.pinned}
      ></meshbound-multiplier-choice>
      <meshbound-method-choice
        .method=${this.method}
        @method-change=${({ detail }: CustomEvent<Method>) =>
          this.dispatchEvent(new CustomEvent('method-change', { detail }))}
      ></meshbound-method-choice>
    `;
  }

  #steps() {
    const step = (event: 'undo' | 'redo', sign: string, keys: string, possible: boolean) => {
      const name = pageEnglish.bounds[event];
      return html`<button
        aria-label=${name}
        title=${pageEnglish.bounds.stepHint(name, keys)}
        ?disabled=${!possible}
        @click=${() => this.dispatchEvent(new CustomEvent(event))}
      >
        ${sign}
      </button>`;
    };
    return html`${step('undo', '\u21b6', 'Ctrl+Z', this.canUndo)}${step('redo', '\u21b7', 'Ctrl+Y', this.canRedo)}`;
  }

  #presets() {
    const items = presets.map(({ text, title, bounds }) => ({
      text,
      title,
      take: () => this.#change({ bounds: boundsThatFit(readBounds(bounds), this.surface?.variables ?? []) }),
    }));
    return html`<meshbound-menu label=${pageEnglish.bounds.presets} .items=${items}></meshbound-menu>`;
  }

  #all() {
    const fraction = largestFraction(this.bounds);
    const input = ({ detail }: CustomEvent<number>) => this.#change({ all: detail });
    return html`<div class="all">
      <span title=${pageEnglish.bounds.allHint}>
        ${pageEnglish.bounds.all} <span class="small soft">${pageEnglish.bounds.inProportion}</span>
      </span>
      <span>
        <meshbound-number-field
          label=${pageEnglish.bounds.largestInPercent}
          .text=${fieldText(percentOf(fraction))}
          .parse=${parsePercent}
          @number-input=${(event: CustomEvent<number>) => {
            input(event);
            settle(this);
          }}
        ></meshbound-number-field>
        %
      </span>
      <meshbound-bound-slider
        label=${english.bounds.allBounds}
        spoken=${english.bounds.largest(percentText(fraction))}
        .fraction=${fraction}
        @bound-input=${input}
      ></meshbound-bound-slider>
    </div>`;
  }

  #row(variable: VariableExtent, index: number) {
    return html`<div class="row">
      <meshbound-bound-row
        .variable=${variable}
        .unit=${this.surface?.labels.units[variable.name]}
        .setting=${this.bounds[variable.name]}
        .reached=${this.report?.variables[index] ?? null}
        .shownWith=${this.#shownWith(variable.name)}
        .measured=${this.measured}
        .multiplied=${isMultiplied(this.keeping)}
        @worst-wanted=${() => this.dispatchEvent(new CustomEvent('worst-wanted', { detail: variable.name }))}
        @bound-change=${({ detail }: CustomEvent<BoundSetting>) =>
          this.#change({ variable: variable.name, setting: detail })}
      ></meshbound-bound-row>
    </div>`;
  }

  #shownWith(variable: string): BoundSetting | null {
    const shown = this.shownBounds?.[variable];
    return shown && !sameSetting(shown, this.bounds[variable]) ? shown : null;
  }

  #spread() {
    return html`<details
      class="spread"
      @toggle=${({ target }: Event) => {
        this.spreadShown = (target as HTMLDetailsElement).open;
      }}
    >
      <summary>${pageEnglish.spread.title}</summary>
      ${
        this.spreadShown
          ? html`<meshbound-error-spread
              .mesh=${this.surface?.mesh ?? null}
              .reduction=${this.reduction}
            ></meshbound-error-spread>`
          : nothing
      }
    </details>`;
  }

  #chart() {
    return html`<details class="chart" @toggle=${this.#toggleChart}>
      <summary>${pageEnglish.chart.title}</summary>
      <meshbound-bounds-chart
        .points=${this.curve}
        .present=${largestFraction(this.bounds)}
        .most=${this.report?.triangles.before ?? 1}
      ></meshbound-bounds-chart>
    </details>`;
  }

  #toggleChart({ target }: Event): void {
    const details = target as HTMLDetailsElement;
    details.scrollIntoView({ block: 'nearest' });
    this.dispatchEvent(new CustomEvent('chart-toggle', { detail: details.open }));
  }

  #change(detail: BoundChange): void {
    this.dispatchEvent(new CustomEvent('bounds-change', { detail }));
  }
}

customElements.define('meshbound-bounds-panel', BoundsPanel);
