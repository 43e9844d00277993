import { html, nothing } from 'lit';
import type { Multiplied } from '../../probe/multiplied.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import type { Standing } from '../../session/session-state.ts';
import { english } from '../../words/english.ts';
import { countText } from '../number-text.ts';
import { isProvisional } from '../result/guarantee-words.ts';
import type { LevelStep } from './level-view.ts';

/** What stands above the original: how many triangles it has. */
export function originalCaption(surface: OpenSurface | null) {
  if (!surface) return html`<span class="soft">${english.stage.original}</span>`;
  const count = surface.mesh.triangles.length / 3;
  return html`${english.stage.original} <b>${countText(count)}</b> ${english.triangles(count)}`;
}

/**
 * What stands above the reduced surface: which level of detail it is, how many triangles it has, and whether it is provisional.
 *
 * @param result null where there is none yet
 * @param step what is shown of levels of detail; null where there are none
 * @param standing how the result stands to what is asked for
 */
export function reducedCaption(
  result: Multiplied | null,
  step: LevelStep | null,
  isReducing: boolean,
  standing: Standing,
) {
  const { stage } = english;
  if (!result) return html`<span class="soft">${isReducing ? stage.reducing : stage.notReduced}</span>`;
  if (step && 'morph' in step) return html`${stage.onTheWay} <b>${step.from + 1}</b>`;
  if (step?.level === 0) return html`${stage.levelZero}`;
  const { report } = step?.result ?? result;
  const count = report.triangles.after;
  const word = isProvisional(report) ? stage.provisional : standing === 'asked' ? null : stage.earlier;
  const mark = word ? html`, <i>${word}</i>` : nothing;
  return html`${step ? stage.level(step.level) : stage.reduced} <b>${countText(count)}</b> ${english.triangles(count)}${mark}`;
}
