// Sets up, builds, and runs every suite; ends with a table and the line "N passed, N failed". A suite that cannot say how
// many tests it ran counts as one.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

process.chdir(fileURLToPath(new URL('..', import.meta.url)));

const results = resolve('build/test-results');
const bin = 'node_modules/.bin/';

const ctestFile = `${results}/ctest.xml`;
const vitestFile = `${results}/vitest.json`;
const playwrightFile = `${results}/playwright.json`;

const steps = [
  { name: 'setup', command: ['scripts/setup.sh', 'test'], essential: true },
  { name: 'build', command: ['scripts/build.sh'] },
  { name: 'native build', command: ['bash', '-c', 'cmake --preset native && cmake --build --preset native'] },
  { name: 'build by Clang', command: ['bash', '-c', 'cmake --preset clang && cmake --build --preset clang'] },
  ...(process.arch === 'x64'
    ? [{ name: 'build for arm64', command: ['bash', '-c', 'cmake --preset arm64 && cmake --build --preset arm64'] }]
    : []),
  {
    name: 'core (ctest)',
    command: ['ctest', '--preset', 'native', '--no-tests=error', '-j', '2', '--output-junit', ctestFile],
    count: countCtest,
  },
  { name: 'fuzzer build', command: ['bash', '-c', 'cmake --preset fuzz && cmake --build --preset fuzz'] },
  { name: 'core (fuzzer)', command: ['scripts/fuzz.sh', '60'] },
  {
    name: 'module (Vitest)',
    command: [`${bin}vitest`, 'run', '--reporter=default', '--reporter=json', `--outputFile.json=${vitestFile}`],
    count: countVitest,
  },
  {
    name: 'page (Playwright)',
    command: [`${bin}playwright`, 'test', '--config', 'tests/e2e/playwright.config.ts', '--reporter=list,json'],
    env: { PLAYWRIGHT_JSON_OUTPUT_NAME: playwrightFile },
    count: countPlaywright,
  },
  { name: 'types (tsc)', command: [`${bin}tsc`, '--noEmit'] },
  { name: 'lint', command: ['scripts/lint.sh'] },
];

function readJson(file) {
  return JSON.parse(readFileSync(file, 'utf8'));
}

function countCtest() {
  if (!existsSync(ctestFile)) return undefined;
  const suite = readFileSync(ctestFile, 'utf8').match(/<testsuite[^>]*>/)[0];
  const number = (name) => Number(suite.match(new RegExp(`\\b${name}="(\\d+)"`))[1]);
  const skipped = number('disabled') + number('skipped');
  return { passed: number('tests') - number('failures') - skipped, failed: number('failures'), skipped };
}

function countVitest() {
  if (!existsSync(vitestFile)) return undefined;
  const { numPassedTests, numFailedTests, numPendingTests } = readJson(vitestFile);
  return { passed: numPassedTests, failed: numFailedTests, skipped: numPendingTests };
}

function countPlaywright() {
  if (!existsSync(playwrightFile)) return undefined;
  const { expected, unexpected, flaky, skipped } = readJson(playwrightFile).stats;
  return { passed: expected + flaky, failed: unexpected, skipped };
}

function run({ name, command, env, count }) {
  console.log(`\n=== ${name} ===`);
  const start = performance.now();
  const { status } = spawnSync(command[0], command.slice(1), { stdio: 'inherit', env: { ...process.env, ...env } });
  const seconds = (performance.now() - start) / 1000;
  const tests = count?.() ?? { passed: status === 0 ? 1 : 0, failed: 0, skipped: 0 };
  // A runner that fails without a failed test (nothing found, a crash) is itself the failure.
  const failed = status !== 0 && tests.failed === 0 ? 1 : tests.failed;
  return { name, ...tests, failed, seconds };
}

function report(outcomes) {
  console.log('\nstep                  passed  failed  skipped  seconds');
  for (const { name, passed, failed, skipped, seconds } of outcomes) {
    const numbers = [
      String(passed).padStart(6),
      String(failed).padStart(6),
      String(skipped).padStart(7),
      seconds.toFixed(1).padStart(7),
    ];
    console.log(`${name.padEnd(20)}  ${numbers.join('  ')}`);
  }
  const total = (key) => outcomes.reduce((sum, outcome) => sum + outcome[key], 0);
  const skipped = total('skipped');
  console.log(`\n${total('passed')} passed, ${total('failed')} failed${skipped > 0 ? `, ${skipped} skipped` : ''}`);
  process.exitCode = total('failed') === 0 ? 0 : 1;
}

rmSync(results, { recursive: true, force: true });
mkdirSync(results, { recursive: true });

const outcomes = [];
for (const step of steps) {
  const outcome = run(step);
  outcomes.push(outcome);
  if (step.essential && outcome.failed > 0) break;
}
report(outcomes);
