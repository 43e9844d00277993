/** A coarser level is taken only once its error is this much below what is allowed: near the limit nothing flickers. */
export const hysteresis = 1.25;

/**
 * The coarsest level whose geometric error spans no more pixels than allowed.
 *
 * @param errors the largest geometric error of each level, finest first, never falling; the first is always good enough
 * @param pixelsPerUnit how many pixels the unit of the errors spans on screen
 * @param allowed how many pixels an error may span
 * @param current the level that is shown: it stays while its error is allowed and no coarser one is well below that
 */
export function chooseLevel(
  errors: readonly number[],
  pixelsPerUnit: number,
  allowed: number,
  current: number,
): number {
  const fits = (level: number) => {
    const limit = level > current ? allowed / hysteresis : allowed;
    return level === 0 || errors[level] * pixelsPerUnit <= limit;
  };
  return errors.reduce((coarsest, _, level) => (fits(level) ? level : coarsest), 0);
}
