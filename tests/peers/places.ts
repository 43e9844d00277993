import { fileURLToPath } from 'node:url';

function fromRoot(path: string): string {
  return fileURLToPath(new URL(`../../${path}`, import.meta.url));
}

/** The folders and files of the comparison. */
export const places = {
  nativeSources: fromRoot('tests/peers'),
  nativeBuild: fromRoot('build/peers'),
  /** What the peers' searches found, the surfaces that are made here, and the meshes under trial. */
  cache: fromRoot('build/peers-cache'),
  surfaces: fromRoot('build/peers-cache/surfaces'),
  samples: fromRoot('build/samples'),
  table: fromRoot('docs/peers.md'),
};
