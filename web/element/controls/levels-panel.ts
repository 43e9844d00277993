import { css, html, LitElement, nothing } from 'lit';
import { type LevelState, mostLevels } from '../../session/reducing/level-session.ts';
import { english } from '../../words/english.ts';
import { countText } from '../number-text.ts';
import { controlsStyle } from './controls-style.ts';

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
        ${english.levels.title}
        <select ?disabled=${this.disabled} @change=${this.#countChanged}>
          ${counts.map((each) => html`<option value=${each} ?selected=${each === count}>${each || english.levels.none}</option>`)}
        </select>
      </label>
      ${count > 0 ? this.#slider(count, position, nested === null) : nothing}
      <span class="now soft">${progress === null ? this.#now() : english.levels.making(Math.floor(100 * progress))}</span>
    `;
  }

  #slider(count: number, position: number, waiting: boolean) {
    return html`${this.#choice(waiting)}<div class="slider">
      <input
        type="range"
        aria-label=${english.levels.position}
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
      (each) => html`<option value=${each} ?selected=${each === pixels}>${english.levels.pixels(each)}</option>`,
    );
    return html`<select
      aria-label=${english.levels.choice}
      title=${english.levels.choiceHint}
      ?disabled=${waiting}
      @change=${this.#choiceChanged}
    >
      <option value="" ?selected=${pixels === null}>${english.levels.byHand}</option>
      ${options}
    </select>`;
  }

  #mark(level: number, waiting: boolean) {
    const name = level === 0 ? english.levels.original : english.levels.level(level);
    return html`<button ?disabled=${waiting} title=${name} aria-label=${name} @click=${() => this.#move(level)}>
      ${level === 0 ? english.levels.originalSign : level}
    </button>`;
  }

  /** What is shown, in words. */
  #now(): string {
    const { nested, position, unbounded } = this.levels;
    if (unbounded) return english.levels.unbounded;
    if (!nested) return this.levels.count > 0 ? '' : english.levels.what;
    const from = Math.floor(position);
    if (position === from && from === 0) return english.levels.theOriginal;
    if (position === from) return english.levels.at(from, this.#triangles(from), 2 ** (from - 1));
    const percent = Math.round(100 * (position - from));
    const pieces = nested.morphs[from] ? countText(nested.morphs[from].triangles.length / 3) : null;
    return english.levels.between(percent, from, pieces);
  }

  #triangles(level: number): string {
    const count = this.levels.nested?.levels[level - 1].report.triangles.after ?? 0;
    return countText(count);
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
