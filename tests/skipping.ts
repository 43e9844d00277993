/**
 * Why a suite cannot run here, if it cannot: for `skipIf`. In continuous integration (CI in the environment) everything has
 * been built and installed, so there it is an error: a test that is skipped proves nothing.
 */
export function mustSkip(reason: string | undefined): boolean {
  if (reason !== undefined && process.env.CI) {
    throw new Error(`In continuous integration no test is skipped, but here: ${reason}.`);
  }
  return reason !== undefined;
}
