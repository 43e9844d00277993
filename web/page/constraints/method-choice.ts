import { html, LitElement, nothing } from 'lit';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import type { Method } from '../../session/constraints/method.ts';
import { pageEnglish } from '../../words/page-english.ts';
import { choice, tick } from './group-controls.ts';
import { groupStyle } from './group-style.ts';

/**
 * How errors are accounted for, and parts of the surface that are near or small, out of the way until it is opened.
 *
 * @fires method-change with the new Method
 */
export class MethodChoice extends LitElement {
  static override properties = { method: { attribute: false } };

  static override styles = [controlsStyle, groupStyle];

  declare method: Method;

  override render() {
    return html`<details @toggle=${() => this.scrollIntoView({ block: 'nearest' })}>
      <summary
        >${pageEnglish.method.title} <span class="small soft">${pageEnglish.method.now(this.method.errors, this.#ticked())}</span></summary
      >
      ${choice(
        pageEnglish.method.errors,
        Object.keys(pageEnglish.method.means).map((name) => [name, name]),
        this.method.errors,
        (chosen) => this.#change({ errors: chosen as Method['errors'] }),
      )}
      ${
        this.method.errors === 'propagated'
          ? choice(
              pageEnglish.method.keepsSmall,
              Object.entries(pageEnglish.method.costs),
              this.method.cost,
              (chosen) => this.#change({ cost: chosen as Method['cost'] }),
            )
          : nothing
      }
      <p class="small soft">${pageEnglish.method.means[this.method.errors]}</p>
      ${tick(pageEnglish.method.refusePiercing, this.method.refusePiercing, (refusePiercing) => this.#change({ refusePiercing }))}
      ${tick(pageEnglish.method.limitToFeatureSize, this.method.limitToFeatureSize, (limitToFeatureSize) =>
        this.#change({ limitToFeatureSize }),
      )}
      <p class="small soft">${pageEnglish.method.nearParts}</p>
      ${tick(pageEnglish.method.dropSmallComponents, this.method.dropSmallComponents, (dropSmallComponents) => this.#change({ dropSmallComponents }))}
      <p class="small soft">${pageEnglish.method.smallParts}</p>
    </details>`;
  }

  #ticked(): string[] {
    const { short } = pageEnglish.method;
    return (Object.keys(short) as (keyof typeof short)[])
      .filter((name) => this.method[name])
      .map((name) => short[name]);
  }

  #change(change: Partial<Method>): void {
    this.dispatchEvent(new CustomEvent('method-change', { detail: { ...this.method, ...change } }));
  }
}

customElements.define('meshbound-method-choice', MethodChoice);
