import { css, html, LitElement, nothing } from 'lit';
import { type LevelState, mostLevels } from '../session/level-session.ts';
import { controlsStyle } from './controls-style.ts';
import { countText } from './number-text.ts';

/** How many levels can be asked for. */
const counts = Array.from({ length: mostLevels + 1 }, (_, count) => count);
/** How many pixels an error may span where levels are chosen by their size on screen. */
const pixelChoices = [0.5, 1, 2, 5, 10];
/** One press of an arrow key moves this far from level to level. */
const step = 0.01;

/**
 * Levels of detail: how many, and which is shown.
 *
 * @fires level-count with how many levels there are to be
 * @fires level-pixels with how many pixels an error may span, or null: the position decides
 * @fires level-position with the position that is to be shown
 */
export class LevelsPanel extends LitElement {
  static override properties = {
    levels: { attribute: false },
    disabled: { type: Boolean },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: flex;
        flex-wrap: wrap;
        gap: var(--gap) 16px;
        align-items: center;
        min-height: 51px;
        padding: 8px 12px;
      }
      label {
        display: flex;
        gap: var(--gap);
        align-items: center;
        white-space: nowrap;
      }
      .slider {
        flex: 1 1 200px;
        max-width: 420px;
      }
      input {
        display: block;
        width: 100%;
        height: 16px;
        margin: 0;
      }
      /* As wide as the way of the slider's thumb, whose middle stands above the numbers. */
      .marks {
        display: flex;
        justify-content: space-between;
        margin: 0 -4px;
      }
      .marks button {
        width: 24px;
        min-height: 18px;
        padding: 0;
        font-size: 11px;
        color: var(--ink-soft);
        background: none;
        border: none;
      }
      /* One line, so that the stage keeps its height. */
      .now {
        flex: 1 1 240px;
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
    `,
  ];

  declare levels: LevelState;
  declare disabled: boolean;

  override render() {
    const { count, nested, progress, position } = this.levels;
    return html`
      <label>
        Levels of detail
        <select ?disabled=${this.disabled} @change=${this.#countChanged}>
          ${counts.map((each) => html`<option value=${each} ?selected=${each === count}>${each || 'none'}</option>`)}
        </select>
      </label>
      ${count > 0 ? this.#slider(count, position, nested === null) : nothing}
      <span class="now soft">${progress === null ? this.#now() : `Making levels: ${Math.floor(100 * progress)} %`}</span>
    `;
  }

  #slider(count: number, position: number, waiting: boolean) {
    return html`${this.#choice(waiting)}<div class="slider">
      <input
        type="range"
        aria-label="Position among levels"
        aria-valuetext=${this.#now()}
        min="0"
        max=${count}
        step=${step}
        .value=${String(position)}
        ?disabled=${waiting}
        @input=${({ target }: Event) => this.#move(Number((target as HTMLInputElement).value))}
      />
      <div class="marks">${Array.from({ length: count + 1 }, (_, level) => this.#mark(level, waiting))}</div>
    </div>`;
  }

  #choice(waiting: boolean) {
    const { pixels } = this.levels;
    const options = pixelChoices.map(
      (each) => html`<option value=${each} ?selected=${each === pixels}>error ≤ ${each} px</option>`,
    );
    return html`<select
      aria-label="Which level"
      title="By hand, or the coarsest whose error in space spans no more on screen"
      ?disabled=${waiting}
      @change=${this.#choiceChanged}
    >
      <option value="" ?selected=${pixels === null}>by hand</option>
      ${options}
    </select>`;
  }

  #mark(level: number, waiting: boolean) {
    const name = level === 0 ? 'Original' : `Level ${level}`;
    return html`<button ?disabled=${waiting} title=${name} aria-label=${name} @click=${() => this.#move(level)}>
      ${level === 0 ? 'O' : level}
    </button>`;
  }

  /** What is shown, in words. */
  #now(): string {
    const { nested, position } = this.levels;
    if (!nested) return this.levels.count > 0 ? '' : 'Coarser and coarser, with a smooth way from one to the next';
    const from = Math.floor(position);
    if (position === from && from === 0) return 'The original';
    if (position === from) return `Level ${from}: ${this.#triangles(from)}, bounds × ${2 ** (from - 1)}`;
    const percent = Math.round(100 * (position - from));
    const start = from === 0 ? 'the original' : `level ${from}`;
    const count = nested.morphs[from] ? `, ${countText(nested.morphs[from].triangles.length / 3)} pieces` : '';
    return `${percent} % from ${start} to level ${from + 1}${count}`;
  }

  #triangles(level: number): string {
    const count = this.levels.nested?.levels[level - 1].report.triangles.after ?? 0;
    return `${countText(count)} triangles`;
  }

  #countChanged = ({ target }: Event): void => {
    this.dispatchEvent(new CustomEvent('level-count', { detail: Number((target as HTMLSelectElement).value) }));
  };

  #choiceChanged = ({ target }: Event): void => {
    const { value } = target as HTMLSelectElement;
    this.dispatchEvent(new CustomEvent('level-pixels', { detail: value === '' ? null : Number(value) }));
  };

  #move(position: number): void {
    this.dispatchEvent(new CustomEvent('level-position', { detail: position }));
  }
}

customElements.define('meshbound-levels-panel', LevelsPanel);
