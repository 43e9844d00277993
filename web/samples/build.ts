/**
 * Makes the sample surfaces in build/samples, those that are missing or older than their sources:
 *
 *     npx tsx web/samples/build.ts [NAME...]
 *
 * NAME.ply for each sample of the catalogue (or for those named), and samples.json, which lists those that are there.
 */
import { existsSync, mkdirSync, readdirSync, readFileSync, renameSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { type ListedSample, type Sample, samples } from './catalogue.ts';

const sources = fileURLToPath(new URL('.', import.meta.url));
const output = fileURLToPath(new URL('../../build/samples/', import.meta.url));
const list = join(output, 'samples.json');

function isFresh(sample: Sample): boolean {
  const file = join(output, `${sample.name}.ply`);
  const newestSource = Math.max(...readdirSync(sources).map((source) => statSync(join(sources, source)).mtimeMs));
  return (
    existsSync(file) && statSync(file).mtimeMs >= newestSource && listed().some((entry) => entry.name === sample.name)
  );
}

function listed(): ListedSample[] {
  return existsSync(list) ? (JSON.parse(readFileSync(list, 'utf8')) as ListedSample[]) : [];
}

/** Adds a sample to samples.json, or replaces it. */
function enlist(entry: ListedSample): void {
  const others = listed().filter(({ name }) => name !== entry.name);
  const place = ({ name }: ListedSample) => samples.findIndex((sample) => sample.name === name);
  const entries = [...others, entry].filter((one) => place(one) >= 0).sort((a, b) => place(a) - place(b));
  write(list, `${JSON.stringify(entries, null, 2)}\n`);
}

/** Whole or not at all, also for whoever reads at the same time. */
function write(file: string, content: string | Buffer): void {
  const unfinished = `${file}.${process.pid}`;
  writeFileSync(unfinished, content);
  renameSync(unfinished, file);
}

const wanted = process.argv.slice(2);
const chosen = samples.filter(({ name }) => wanted.length === 0 || wanted.includes(name));
const unknown = wanted.filter((name) => !samples.some((sample) => sample.name === name));
if (unknown.length > 0) {
  console.error(`No sample “${unknown.join('”, “')}”. There are: ${samples.map(({ name }) => name).join(', ')}.`);
  process.exit(1);
}
const stale = chosen.filter((sample) => !isFresh(sample));
if (stale.length === 0) {
  console.log('samples: up to date');
} else {
  // Imported only now: loading vtk.js takes longer than finding that there is nothing to do.
  const { makeSample } = await import('./make.ts');
  const { buildSimulator } = await import('./simulate.ts');
  mkdirSync(output, { recursive: true });
  console.log('samples: compiling the simulator');
  buildSimulator();
  for (const sample of stale) {
    const start = performance.now();
    console.log(`samples: simulating ${sample.name}, ${sample.cells.join(' x ')} cells`);
    const { entry, ply, summary } = makeSample(sample);
    write(join(output, entry.file), ply);
    enlist(entry);
    console.log(`samples: ${entry.file}: ${summary}, ${((performance.now() - start) / 1000).toFixed(1)} s`);
  }
}
