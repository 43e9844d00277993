/**
 * Draws the figures of docs/algorithm.md and docs/architecture.md into this folder: npx tsx docs/drawings/draw.ts
 */

import { writeFileSync } from 'node:fs';

import { drawings } from './drawings.ts';

for (const [name, draw] of Object.entries(drawings)) writeFileSync(new URL(`${name}.svg`, import.meta.url), draw());
