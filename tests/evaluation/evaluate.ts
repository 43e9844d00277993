/**
 * Repeats the evaluation of §5 and goes beyond it: writes docs/evaluation.md with its tables and pictures, and the README's
 * picture of the page. Wants a build, and a C++ compiler for the generated surfaces.
 *
 *     npm run evaluate
 */

import { readFileSync, writeFileSync } from 'node:fs';

import { readPly } from '../../web/formats/ply/read-ply.ts';
import type { Surface } from '../../web/formats/surface.ts';
import { buildNative } from '../peers/native.ts';
import { findSurfaces } from '../peers/surfaces.ts';
import { evaluationDocument } from './document.ts';
import { othersTable } from './others.ts';
import { paperCases, paperTables } from './paper.ts';
import { takePagePicture, takePictures } from './pictures.ts';
import { referenceTable } from './reference.ts';

const others = ['fireballs-fine', 'impact-fine', 'bunny', 'terrain'];

buildNative();
const files = new Map(findSurfaces().map(({ name, path }) => [name, path]));

function read(names: string[]): Map<string, Surface> {
  return new Map(names.map((name) => [name, readPly(readFileSync(files.get(name) as string))]));
}

const samples = read(paperCases.map(({ sample }) => sample));
console.log('The surfaces of §5 …');
const paper = await paperTables(samples);
console.log('What the geometric bound is relative to …');
const reference = await referenceTable(samples);
console.log('Other surfaces …');
const other = await othersTable(read(others));
console.log('Pictures …');
await takePictures(paperCases, 'docs/evaluation');
await takePagePicture('docs/page.jpg');
writeFileSync('docs/evaluation.md', evaluationDocument({ paper, reference, other, samples }));
console.log('docs/evaluation.md is written.');
