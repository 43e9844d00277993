import { css, html, LitElement } from 'lit';
import type { RegionReport, Report } from '../../wasm/types.ts';
import { controlsStyle } from '../element/controls-style.ts';
import { countText, valueText, withUnit } from '../element/number-text.ts';
import { firstMethod, type Method } from '../session/method.ts';
import { pageEnglish } from '../words/page-english.ts';
import { groupStyle } from './group-style.ts';

const words = pageEnglish.report;

/** What the report says of the surface's shape beside bounds and errors, out of the way until it is opened. */
export class ResultReport extends LitElement {
  static override properties = {
    report: { attribute: false },
    method: { attribute: false },
    unit: {},
    names: { attribute: false },
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
      dd {
        margin: 0;
      }
    `,
  ];

  declare report: Report | null;
  declare method: Method;
  /** Of position. */
  declare unit: string | undefined;
  /** What the labels of regions stand for, where the surface says so. */
  declare names: ReadonlyMap<number, string> | undefined;

  constructor() {
    super();
    this.report = null;
    this.method = firstMethod;
    this.unit = undefined;
    this.names = undefined;
  }

  override render() {
    const { report } = this;
    if (!report) return html``;
    return html`<details @toggle=${() => this.scrollIntoView({ block: 'nearest' })}>
      <summary>${words.title} <span class="small soft">${words.now(this.#unusual(report))}</span></summary>
      <dl class="small">${this.#lines(report).map(([name, text]) => html`<dt class="soft">${name}</dt><dd>${text}</dd>`)}</dl>
    </details>`;
  }

  /** What most results have not, each in a few words. */
  #unusual({ turnedAway, dropped, featureSize, oddities, regions }: Report): string[] {
    const found: [boolean, string][] = [
      [dropped.parts > 0, words.partsDropped(countText(dropped.parts), dropped.parts)],
      [regions.some(isVanished), words.unusual.vanished],
      [featureSize !== undefined, words.unusual.limited],
      [turnedAway.after > turnedAway.before, words.unusual.turnedAway],
      [oddities.turnedTriangles > 0, words.unusual.turnedRound],
      [oddities.unorientableParts > 0, words.unusual.oneSided],
    ];
    return found.filter(([is]) => is).map(([, text]) => text);
  }

  #regions(regions: RegionReport[]): string {
    const vanished = regions.filter(isVanished).map(({ label }) => this.names?.get(label) ?? String(label));
    return words.regionsAre(countText(regions.length - vanished.length), vanished);
  }

  #lines(report: Report): [string, string][] {
    const { turnedAway, dropped, featureSize, oddities, regions, nonManifoldVertices, cells, foldedCells } = report;
    const { turnedTriangles, unorientableParts } = oddities;
    const size = featureSize === undefined ? null : withUnit(valueText(featureSize), this.unit);
    return [
      [words.turnedAway, words.beforeAndAfter(countText(turnedAway.before), countText(turnedAway.after))],
      [words.folds, cells > 0 ? words.foldsAre(countText(foldedCells), countText(cells)) : words.noMap],
      [
        words.orientation,
        words.orientationIs(
          countText(turnedTriangles),
          turnedTriangles,
          countText(unorientableParts),
          unorientableParts,
        ),
      ],
      [words.regions, regions.length > 0 ? this.#regions(regions) : words.noRegions],
      [words.nonManifold, countText(nonManifoldVertices)],
      [words.featureSize, words.featureSizeIs(size, this.method.limitToFeatureSize)],
      [
        words.smallParts,
        words.smallPartsAre(countText(dropped.parts), countText(dropped.triangles), this.method.dropSmallParts),
      ],
    ];
  }
}

function isVanished({ triangles }: RegionReport): boolean {
  return triangles.after === 0;
}

customElements.define('meshbound-result-report', ResultReport);
