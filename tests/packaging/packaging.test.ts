// The C++ library as others build and use it: installed and found by CMake and by pkg-config, fetched, as a subdirectory;
// static and shared; by GCC and by Clang. Wants the presets native and clang built.
import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { beforeAll, describe, expect, test, vi } from 'vitest';

import { mustSkip } from '../skipping.ts';

const scratch = resolve('build/packaging');
const sources = resolve('tests/packaging/consumer');
const { version } = JSON.parse(readFileSync('package.json', 'utf8')) as { version: string };
const answer = `${version}: 8 to 2\n`;

const compilers = [
  { name: 'GCC', compiler: 'g++', build: 'build/native' },
  { name: 'Clang', compiler: 'clang++', build: 'build/clang' },
];

/** What is tested here is how things are put together: without optimisation they compile in a fraction of the time. */
const quickly = ['-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG', '-DCMAKE_CXX_FLAGS_DEBUG=-O0'];

/** The whole core is compiled three times: on a machine with other work, that takes longer than other tests may. */
vi.setConfig({ testTimeout: 900_000, hookTimeout: 900_000 });

/** Runs a program; where it fails, its words are the error. */
function run(program: string, args: string[], env: NodeJS.ProcessEnv = {}): string {
  return execFileSync(program, args, { encoding: 'utf8', stdio: 'pipe', env: { ...process.env, ...env } });
}

function configure(source: string, build: string, ...settings: string[]): string {
  return run('cmake', ['-S', source, '-B', build, ...settings]);
}

function build(folder: string): void {
  run('cmake', ['--build', folder, '--parallel', '2']);
}

/** Installs what has been built, and returns where. */
function installed(from: string, name: string): string {
  const prefix = join(scratch, name);
  run('cmake', ['--install', from, '--prefix', prefix]);
  return prefix;
}

/** Configures, builds and runs the consumer. */
function consumed(folder: string, ...settings: string[]): string {
  configure(sources, folder, ...settings);
  build(folder);
  return run(join(folder, 'consumer'), []);
}

/** The folder of an installation that holds its libraries. */
function libraries(prefix: string): string {
  const name = readdirSync(prefix).find((entry) => entry.startsWith('lib')) ?? 'lib';
  const triplets = readdirSync(join(prefix, name)).filter((entry) =>
    existsSync(join(prefix, name, entry, 'pkgconfig')),
  );
  return join(prefix, name, ...triplets);
}

function consumedByPkgConfig(compiler: string, prefix: string, name: string): string {
  const env = { PKG_CONFIG_PATH: join(libraries(prefix), 'pkgconfig') };
  const flags = run('pkg-config', ['--cflags', '--libs', 'meshbound'], env).trim().split(/\s+/);
  const program = join(scratch, name);
  run(compiler, ['-std=c++20', join(sources, 'main.cpp'), ...flags, '-o', program]);
  return run(program, [], { LD_LIBRARY_PATH: libraries(prefix) });
}

const unbuilt = compilers.find((each) => !existsSync(join(each.build, 'core/libmeshbound.a')));
const missing = unbuilt ? `${unbuilt.build} is missing` : undefined;

describe.skipIf(mustSkip(missing))('the library', () => {
  beforeAll(() => rmSync(scratch, { recursive: true, force: true }));

  describe.each(compilers)('by $name', ({ name, compiler, build: built }) => {
    const by = `-DCMAKE_CXX_COMPILER=${compiler}`;

    test('is found by find_package and by pkg-config where it is installed', () => {
      const prefix = installed(built, `${name}-prefix`);
      expect(consumed(join(scratch, `${name}-found`), by, `-DCMAKE_PREFIX_PATH=${prefix}`)).toBe(answer);
      expect(consumedByPkgConfig(compiler, prefix, `${name}-by-pkg-config`)).toBe(answer);
    });

    test.each(['FetchContent', 'add_subdirectory'])(
      'can be used by %s, without its tests and its install rules',
      (way) => {
        const folder = join(scratch, `${name}-within`);
        const settings = [
          by,
          `-DWAY=${way}`,
          `-DMESHBOUND_ROOT_DIR=${resolve('.')}`,
          '-DCMAKE_BUILD_TYPE=Debug',
          ...quickly,
        ];
        expect(consumed(folder, ...settings)).toBe(answer);
        const cache = readFileSync(join(folder, 'CMakeCache.txt'), 'utf8');
        expect(cache).toMatch(/MESHBOUND_BUILD_TESTS:BOOL=OFF/);
        expect(cache).toMatch(/MESHBOUND_INSTALL:BOOL=OFF/);
      },
    );
  });

  describe('shared, as docs/cpp.md builds it but for its kind', () => {
    const folder = join(scratch, 'plain');
    let prefix: string;
    beforeAll(() => {
      // Neither Ninja nor what the tests need may be asked for.
      const without = ['GTest', 'CGAL', 'benchmark'].map((name) => `-DCMAKE_DISABLE_FIND_PACKAGE_${name}=ON`);
      configure('.', folder, '-G', 'Unix Makefiles', '-DBUILD_SHARED_LIBS=ON', ...without, ...quickly);
      build(folder);
      prefix = installed(folder, 'plain-prefix');
    });

    test('is a release build, without tests', () => {
      const cache = readFileSync(join(folder, 'CMakeCache.txt'), 'utf8');
      expect(cache).toMatch(/CMAKE_BUILD_TYPE:STRING=Release/);
      expect(cache).toMatch(/MESHBOUND_BUILD_TESTS:BOOL=OFF/);
    });

    test.each(compilers)('is used by $name', ({ name, compiler }) => {
      const settings = [`-DCMAKE_CXX_COMPILER=${compiler}`, `-DCMAKE_PREFIX_PATH=${prefix}`];
      expect(consumed(join(scratch, `${name}-shared`), ...settings)).toBe(answer);
      expect(consumedByPkgConfig(compiler, prefix, `${name}-shared-by-pkg-config`)).toBe(answer);
    });

    test('is called by the part of the version that promises to stay compatible', () => {
      const [major, minor] = version.split('.');
      const promised = major === '0' ? `0.${minor}` : major;
      const library = join(libraries(prefix), 'libmeshbound.so');
      expect(run('readelf', ['-d', library])).toContain(`Library soname: [libmeshbound.so.${promised}]`);
    });

    test('hands out the functions of its headers and nothing else', () => {
      const headers = readdirSync('core/include/meshbound').map((name) => join('core/include/meshbound', name));
      const declared = headers.flatMap((path) =>
        Array.from(readFileSync(path, 'utf8').matchAll(/^MESHBOUND_API [\w:<> ]+ (\w+)\(/gm), ([, name]) => name),
      );
      const symbols = run('nm', ['-DC', '--defined-only', join(libraries(prefix), 'libmeshbound.so')]);
      const exported = Array.from(symbols.matchAll(/ [TWBDRV] meshbound::(.*)$/gm), ([, name]) => name);
      expect(exported.map((name) => name.replace(/(\[abi:\w+\])?\(.*$/, '')).sort()).toEqual(declared.sort());
    });
  });

  test('does not take GLM types that are padded', () => {
    const file = join(sources, 'main.cpp');
    const padded = ['-DGLM_FORCE_DEFAULT_ALIGNED_GENTYPES', '-DGLM_FORCE_INTRINSICS', '-msse4.1'];
    const compile = (...given: string[]) =>
      run('g++', ['-std=c++20', '-fsyntax-only', '-Icore/include', ...given, file]);
    expect(() => compile()).not.toThrow();
    if (process.arch === 'x64') expect(() => compile(...padded)).toThrow(/without padding/);
  });
});

test('every public function is marked for shared libraries', () => {
  const headers = readdirSync('core/include/meshbound').map((name) => join('core/include/meshbound', name));
  const unmarked = headers.flatMap((path) =>
    Array.from(
      readFileSync(path, 'utf8').matchAll(/^(?!MESHBOUND_API |inline |#|\/| )[\w:<>, ]+ \w+\([^{]*?\);/gm),
      ([line]) => `${path}: ${line}`,
    ),
  );
  expect(unmarked).toEqual([]);
});

test('header and package have one version', () => {
  const header = readFileSync('core/include/meshbound/version.hpp', 'utf8');
  const numbers = ['MAJOR', 'MINOR', 'PATCH'].map(
    (part) => header.match(new RegExp(`#define MESHBOUND_VERSION_${part} (\\d+)`))?.[1],
  );
  expect(numbers.join('.')).toBe(version);
});
