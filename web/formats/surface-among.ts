/** Files that are opened with a surface rather than as one, by the endings of their names. */
const companions = /\.(csv|bin|mtl|png|jpe?g)(\.gz)?$/i;

/** Which of several files chosen together is the surface: the first that is none of those that lie beside one. */
export function surfaceAmong<Named extends { name: string }>(files: readonly Named[]): Named | undefined {
  return files.find(({ name }) => !companions.test(name)) ?? files[0];
}
