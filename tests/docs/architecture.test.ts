// What docs/architecture.md says of the folders' imports is true.
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { expect, test } from 'vitest';

/** What each folder may import besides itself, from the table in the document. */
function allowedImports(): Map<string, string[]> {
  const table = readFileSync('docs/architecture.md', 'utf8').matchAll(/^\| `([\w/]+)` \|.*\|([^|]*)\|$/gm);
  return new Map(
    Array.from(table, ([, folder, names]) => [folder, [...names.matchAll(/`([\w/]+)`/g)].map(([, n]) => n)]),
  );
}

const allowed = allowedImports();

function folderOf(path: string): string | undefined {
  return [...allowed.keys()].find((folder) => path.startsWith(`${folder}/`));
}

function sources(folder: string, kind: RegExp): string[] {
  const names = readdirSync(folder, { recursive: true, encoding: 'utf8' });
  return names.map((name) => join(folder, name)).filter((path) => kind.test(path) && statSync(path).isFile());
}

/** The project's own files that a TypeScript file imports, by path from the root. */
function importsOf(path: string): string[] {
  const text = readFileSync(path, 'utf8');
  const names = text.matchAll(/(?:\bfrom|\bimport)\s*\(?\s*'(\.[^']*)'/g);
  return Array.from(names, ([, name]) => normalize(join(dirname(path), name)));
}

test('the table names every folder of web', () => {
  const folders = readdirSync('web', { withFileTypes: true }).filter((entry) => entry.isDirectory());
  expect([...allowed.keys()]).toEqual(expect.arrayContaining(folders.map(({ name }) => `web/${name}`)));
});

test.each([...allowed.keys()])('%s imports what it may', (folder) => {
  const strangers = sources(folder, /\.ts$/).flatMap((path) =>
    importsOf(path)
      .filter((imported) => {
        const home = folderOf(imported);
        return home
          ? home !== folder && !allowed.get(folder)?.includes(home)
          : /^(web|wasm|core|tests)\//.test(imported);
      })
      .map((imported) => `${path} imports ${imported}`),
  );
  expect(strangers).toEqual([]);
});

test('no file imports itself by way of others, not even for types', () => {
  const imports = new Map(
    ['workers', 'wasm', 'web'].flatMap((folder) => sources(folder, /\.ts$/)).map((path) => [path, importsOf(path)]),
  );
  const seen = new Set<string>();
  const circles: string[] = [];
  const follow = (path: string, way: string[]) => {
    if (way.includes(path)) circles.push([...way.slice(way.indexOf(path)), path].join(' → '));
    if (seen.has(path)) return;
    seen.add(path);
    for (const imported of imports.get(path) ?? []) follow(imported, [...way, path]);
  };
  for (const path of imports.keys()) follow(path, []);
  expect(imports.size).toBeGreaterThan(100);
  expect(circles).toEqual([]);
});

test('the core includes itself, GLM and the standard library', () => {
  const headers = sources('core', /\.[ch]pp$/).flatMap((path) =>
    Array.from(readFileSync(path, 'utf8').matchAll(/#include (?:<(\w+)\/|"(\.\.))/g), ([line]) => `${path}: ${line}`),
  );
  expect(headers.filter((line) => !/<(glm|meshbound)\//.test(line))).toEqual([]);
});

test('the judge takes nothing of the core but the mesh', () => {
  const headers = sources('tests/judge', /\.[ch]pp$/).flatMap((path) =>
    Array.from(readFileSync(path, 'utf8').matchAll(/"(meshbound\/[\w.]+)"/g), ([, header]) => header),
  );
  expect([...new Set(headers)]).toEqual(['meshbound/mesh.hpp']);
});
