// What docs/architecture.md says of the imports of folders, and of the includes of the core's rooms, is true.
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { describe, expect, test } from 'vitest';

import * as rooms from './rooms.ts';

/** The rows of the table under a heading of the document: what the first column names, and the text of the last one. */
function tableUnder(heading: string): [string, string][] {
  const document = readFileSync('docs/architecture.md', 'utf8');
  const section = document.split(/^## /m).find((text) => text.startsWith(`${heading}\n`)) ?? '';
  return Array.from(section.matchAll(/^\| `([\w/-]+)` \|.*\|([^|]*)\|$/gm), ([, name, last]) => [name, last]);
}

function namesIn(cell: string): string[] {
  return Array.from(cell.matchAll(/`([\w/.-]+)`/g), ([, name]) => name);
}

/** What each folder may import besides itself. */
const allowed = new Map(tableUnder('What each folder may know').map(([folder, cell]) => [folder, namesIn(cell)]));

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

/** Every circle in which files name each other. */
function circlesIn(imports: Map<string, string[]>): string[] {
  const seen = new Set<string>();
  const circles: string[] = [];
  const follow = (path: string, way: string[]) => {
    if (way.includes(path)) circles.push([...way.slice(way.indexOf(path)), path].join(' → '));
    if (seen.has(path)) return;
    seen.add(path);
    for (const imported of imports.get(path) ?? []) follow(imported, [...way, path]);
  };
  for (const path of imports.keys()) follow(path, []);
  return circles;
}

test('the table names every folder of web', () => {
  const folders = readdirSync('web', { withFileTypes: true }).filter((entry) => entry.isDirectory());
  expect([...allowed.keys()]).toEqual(expect.arrayContaining(folders.map(({ name }) => `web/${name}`)));
});

test('the table names every room of web', () => {
  const document = readFileSync('docs/architecture.md', 'utf8');
  const found = readdirSync('web', { recursive: true, encoding: 'utf8' })
    .map((path) => `web/${path}`)
    .filter((path) => path.split('/').length === 3 && statSync(path).isDirectory());
  expect(found.filter((room) => !document.includes(`\`${room}\``))).toEqual([]);
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
  expect(imports.size).toBeGreaterThan(100);
  expect(circlesIn(imports)).toEqual([]);
});

test('the core includes itself, GLM and the standard library', () => {
  const headers = sources('core', /\.[ch]pp$/).flatMap((path) =>
    Array.from(readFileSync(path, 'utf8').matchAll(/#include (?:<(\w+)\/|"(\.\.))/g), ([line]) => `${path}: ${line}`),
  );
  expect(headers.filter((line) => !/<(glm|meshbound)\//.test(line))).toEqual([]);
});

test.each(sources('core/include', /\.hpp$/))('%s includes public headers only', (path) => {
  const strangers = rooms.includesOf(path).filter((included) => !included.startsWith('core/include/'));
  expect(strangers).toEqual([]);
});

test('the rooms of the core are those of the table, and none includes what it may not', () => {
  const table = rooms.parse(tableUnder('The rooms of the core'));
  const files = sources('core/src', /\.[ch]pp$/);
  expect(files.length).toBeGreaterThan(100);
  expect(rooms.withoutFiles(table, files)).toEqual([]);
  expect(rooms.faults(table, new Map(files.map((path) => [path, rooms.includesOf(path)])))).toEqual([]);
});

test('no file of the core includes itself by way of others', () => {
  const files = sources('core', /\.[ch]pp$/);
  expect(circlesIn(new Map(files.map((path) => [path, rooms.includesOf(path)])))).toEqual([]);
});

describe('the check of rooms', () => {
  const table = rooms.parse([
    ['core/src/util', ''],
    ['core/src/mesh', ' all above '],
    ['core/src/errors', ' all above '],
    ['core/src/errors/tracked', ' all above '],
    ['core/src/verify', ' `core/src/mesh`, `core/src/util/indexing.hpp` '],
  ]);
  const faultsOf = (path: string, ...included: string[]) =>
    rooms.faults(table, new Map([[path, included.map((name) => `core/src/${name}`)]]));

  test('lets a file include its own room and what the table says', () => {
    expect(faultsOf('core/src/util/thread_pool.cpp', 'util/thread_pool.hpp')).toEqual([]);
    expect(faultsOf('core/src/errors/a.hpp', 'util/thread_pool.hpp', 'mesh/b.hpp')).toEqual([]);
    expect(faultsOf('core/src/errors/tracked/a.hpp', 'errors/a.hpp', 'errors/tracked/b.hpp')).toEqual([]);
    expect(faultsOf('core/src/verify/a.hpp', 'mesh/b.hpp', 'util/indexing.hpp')).toEqual([]);
  });

  test('finds an include that runs upward, also into a room within the own one', () => {
    expect(faultsOf('core/src/util/thread_pool.hpp', 'mesh/b.hpp')).toEqual([
      'core/src/util/thread_pool.hpp includes core/src/mesh/b.hpp',
    ]);
    expect(faultsOf('core/src/errors/a.hpp', 'errors/tracked/b.hpp')).toHaveLength(1);
  });

  test('finds a lower room that the table does not give', () => {
    expect(faultsOf('core/src/verify/a.hpp', 'util/thread_pool.hpp', 'errors/a.hpp')).toHaveLength(2);
  });

  test('finds a file that is in no room, and a room without files', () => {
    expect(faultsOf('core/src/stray.hpp')).toEqual(['core/src/stray.hpp is in no room']);
    expect(
      rooms.withoutFiles(table, [
        'core/src/util/thread_pool.hpp',
        'core/src/mesh/b.hpp',
        'core/src/errors/tracked/c.hpp',
      ]),
    ).toEqual(['core/src/errors', 'core/src/verify']);
  });

  test('finds a table whose rooms are not in order', () => {
    expect(() =>
      rooms.parse([
        ['core/src/mesh', ' `core/src/util` '],
        ['core/src/util', ''],
      ]),
    ).toThrow(/core\/src\/util/);
  });

  test('follows circles', () => {
    expect(
      circlesIn(
        new Map([
          ['a', ['b']],
          ['b', ['c']],
          ['c', ['b']],
        ]),
      ),
    ).toEqual(['b → c → b']);
  });
});

/** Everything that a file includes, and that the source behind one of these headers does, itself among them. */
function reachedFrom(paths: string[]): string[] {
  const reached = new Set<string>();
  const follow = (path: string) => {
    if (reached.has(path)) return;
    reached.add(path);
    const source = path.replace(/\.hpp$/, '.cpp');
    if (source.startsWith('core/src/') && existsSync(source)) follow(source);
    for (const included of rooms.includesOf(path)) follow(included);
  };
  for (const path of paths) follow(path);
  return [...reached];
}

describe('the judge', () => {
  const reached = reachedFrom(sources('core/src/verify', /\.[ch]pp$/));

  test('reaches nothing of the core but facts about meshes and tools', () => {
    const strangers = reached.filter(
      (path) => path.startsWith('core/src/') && !/^core\/src\/(verify|mesh|util)\//.test(path),
    );
    expect(reached.length).toBeGreaterThan(20);
    expect(strangers).toEqual([]);
  });

  test('reaches no public header but those of a mesh, a fault, progress and its own', () => {
    const headers = reached.filter((path) => path.startsWith('core/include/'));
    const known = ['api', 'glm_layout', 'mesh', 'progress', 'status', 'verify'];
    expect(headers.sort()).toEqual(known.map((name) => `core/include/meshbound/${name}.hpp`));
  });

  test('is known to nothing that reduces', () => {
    const others = sources('core/src', /\.[ch]pp$/).filter((path) => !path.startsWith('core/src/verify/'));
    const knowing = others.filter((path) => reachedFrom([path]).includes('core/include/meshbound/verify.hpp'));
    expect(knowing).toEqual([]);
  });

  test('is linked with nothing that reduces as a WebAssembly module', () => {
    const text = readFileSync('wasm/CMakeLists.txt', 'utf8');
    const [, files] = /file\(GLOB judge_sources([^)]*)\)/.exec(text) ?? [];
    const [, linked] = /add_executable\(judge_wasm([^)]*)\)/.exec(text) ?? [];
    expect(Array.from(files?.matchAll(/core\/src\/(\w+)/g) ?? [], ([, room]) => room)).toEqual(['verify', 'mesh']);
    expect(linked?.match(/[\w-]+\.cpp/g)).toEqual(['judge-bindings.cpp', 'from_js.cpp', 'outcome.cpp']);
    expect(text.match(/target_link_libraries\(judge_wasm.*/g)).toEqual([
      'target_link_libraries(judge_wasm PRIVATE glm::glm)',
    ]);
  });
});
