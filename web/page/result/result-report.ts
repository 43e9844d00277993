import { css, html, LitElement } from 'lit';
import type { RegionReport, Report } from '../../../wasm/types.ts';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import { countText, valueText, withUnit } from '../../element/number-text.ts';
import { firstMethod, type Method } from '../../session/constraints/method.ts';
import { pageEnglish } from '../../words/page-english.ts';
import { groupStyle } from '../constraints/group-style.ts';

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
  #unusual({ flippedNormals, dropped, featureSize, defects, regions }: Report): string[] {
    const found: [boolean, string][] = [
      [dropped.components > 0, words.partsDropped(countText(dropped.components), dropped.components)],
      [regions.some(isVanished), words.unusual.vanished],
      [featureSize !== undefined, words.unusual.limited],
      [flippedNormals.after > flippedNormals.before, words.unusual.flippedNormals],
      [defects.flippedTriangles > 0, words.unusual.turnedRound],
      [defects.unorientableComponents > 0, words.unusual.oneSided],
    ];
    return found.filter(([is]) => is).map(([, text]) => text);
  }

  #regions(regions: RegionReport[]): string {
    const vanished = regions.filter(isVanished).map(({ label }) => this.names?.get(label) ?? String(label));
    return words.regionsAre(countText(regions.length - vanished.length), vanished);
  }

  #lines(report: Report): [string, string][] {
    const { flippedNormals, dropped, featureSize, defects, regions, nonManifoldVertices, cells, foldedCells } = report;
    const { flippedTriangles, unorientableComponents } = defects;
    const size = featureSize === undefined ? null : withUnit(valueText(featureSize), this.unit);
    return [
      [words.flippedNormals, words.beforeAndAfter(countText(flippedNormals.before), countText(flippedNormals.after))],
      [words.folds, cells > 0 ? words.foldsAre(countText(foldedCells), countText(cells)) : words.noMap],
      [
        words.orientation,
        words.orientationIs(
          countText(flippedTriangles),
          flippedTriangles,
          countText(unorientableComponents),
          unorientableComponents,
        ),
      ],
      [words.regions, regions.length > 0 ? this.#regions(regions) : words.noRegions],
      [words.nonManifold, countText(nonManifoldVertices)],
      [words.featureSize, words.featureSizeIs(size, this.method.limitToFeatureSize)],
      [
        words.smallParts,
        words.smallPartsAre(
          countText(dropped.components),
          countText(dropped.triangles),
          this.method.dropSmallComponents,
        ),
      ],
    ];
  }
}

function isVanished({ triangles }: RegionReport): boolean {
  return triangles.after === 0;
}

customElements.define('meshbound-result-report', ResultReport);
