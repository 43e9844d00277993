// Exits with 0 if node_modules holds what package-lock.json asks for, with 1 if `npm ci` is due.
import { existsSync, readFileSync } from 'node:fs';

const installedList = 'node_modules/.package-lock.json';

function packagesOf(file) {
  return Object.entries(JSON.parse(readFileSync(file, 'utf8')).packages).filter(([path]) => path !== '');
}

function isFresh() {
  if (!existsSync(installedList)) return false;
  const installed = new Map(packagesOf(installedList));
  // Optional packages are those of other platforms: their absence is as it should be.
  return packagesOf('package-lock.json').every(
    ([path, { version, optional }]) => optional || installed.get(path)?.version === version,
  );
}

process.exit(isFresh() ? 0 : 1);
