/** The message of whatever was thrown, for people. */
export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/** The variable that holds NaN or infinity, where that is what `error` says. */
export function nonFiniteVariable(error: unknown): string | undefined {
  const { code, variable } = (error ?? {}) as { code?: unknown; variable?: unknown };
  return code === 'non_finite_value' && typeof variable === 'string' ? variable : undefined;
}

/** What `error` calls itself, for programs; `failed` where it does not. */
export function codeOf(error: unknown): string {
  const { code } = (error ?? {}) as { code?: unknown };
  return typeof code === 'string' ? code : 'failed';
}
