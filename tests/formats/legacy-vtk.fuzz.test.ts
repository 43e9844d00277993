import fc from 'fast-check';
import { expect, it } from 'vitest';
import { FormatError } from '../../web/formats/format-error.ts';
import { readVtk } from '../../web/formats/legacy-vtk/read-vtk.ts';
import { joined, labelsOf, legacyVtkModel, legacyVtkParts, type Part, variablesOf } from './legacy-vtk-file.ts';

it('gives back whatever a legacy VTK file can say', () => {
  const property = fc.property(legacyVtkModel(), (model) => {
    const { mesh, units, componentNames } = readVtk(joined(legacyVtkParts(model)));
    expect(Array.from(mesh.position)).toEqual(model.points);
    const ofStrip = model.strip ? [0, 1, 2, 1, 3, 2] : [];
    expect(Array.from(mesh.triangles)).toEqual([...model.triangles.flat(), ...ofStrip]);
    const found = mesh.variables.map((variable) => ({ ...variable, values: Float64Array.from(variable.values) }));
    expect(found.map(({ kind: _, ...variable }) => variable)).toEqual(variablesOf(model));
    expect({ units: { ...units }, componentNames: { ...componentNames } }).toEqual(labelsOf(model));
  });
  fc.assert(property, { numRuns: 500 });
});

/** Words that take the place of others; among them all that the format gives a meaning. */
const words =
  '-1 0 1 2 3 4 5 9 99 2147483647 4294967295 4294967296 99999999999999 1e99 nan inf abc # %41 %FF %zz ASCII BINARY DATASET ' +
  'POLYDATA POINTS POLYGONS TRIANGLE_STRIPS LINES VERTICES OFFSETS CONNECTIVITY POINT_DATA CELL_DATA SCALARS VECTORS NORMALS ' +
  'TENSORS TENSORS6 FIELD LOOKUP_TABLE COLOR_SCALARS METADATA COMPONENT_NAMES INFORMATION NAME DATA UNITS_LABEL GLOBAL_IDS ' +
  'bit char int float double string utf8_string variant vtktypeint64 __proto__ constructor';

const change = fc.record({
  how: fc.constantFrom('replace', 'insert', 'remove', 'repeat', 'swap', 'copy', 'move'),
  part: fc.nat(),
  word: fc.nat(),
  by: fc.constantFrom(...words.split(' ')),
});

/** Enough for a whole array with its head and its metadata. */
const longestRun = 8;

type Change = typeof change extends fc.Arbitrary<infer Value> ? Value : never;

function changed(parts: Part[], { how, part, word, by }: Change): Part[] {
  const at = part % parts.length;
  const chosen = parts[at];
  if (how === 'remove') return parts.toSpliced(at, 1);
  if (how === 'repeat') return parts.toSpliced(at, 0, chosen);
  const run = parts.slice(at, at + 1 + (word % longestRun));
  if (how === 'copy') return parts.toSpliced(word % parts.length, 0, ...run);
  if (how === 'move') return parts.toSpliced(at, run.length).toSpliced(word % parts.length, 0, ...run);
  if (how === 'swap') return parts.with(at, parts[word % parts.length]).with(word % parts.length, chosen);
  if (typeof chosen !== 'string') return parts.with(at, chosen.subarray(0, word % (chosen.length + 1)));
  const old = chosen.split(' ');
  return parts.with(at, old.toSpliced(word % old.length, how === 'replace' ? 1 : 0, by).join(' '));
}

it('refuses by name whatever else is put into one, or finds a mesh that holds together', () => {
  const property = fc.property(legacyVtkModel(), fc.array(change, { minLength: 1, maxLength: 4 }), (model, changes) => {
    const file = joined(changes.reduce(changed, legacyVtkParts(model)));
    let mesh: ReturnType<typeof readVtk>['mesh'];
    try {
      mesh = readVtk(file).mesh;
    } catch (error) {
      if (error instanceof FormatError) return;
      throw error;
    }
    const points = mesh.position.length / 3;
    expect(mesh.triangles.length % 3).toBe(0);
    expect(mesh.triangles.every((corner) => corner < points)).toBe(true);
    for (const { components, values } of mesh.variables) expect(values.length).toBe(points * components);
  });
  fc.assert(property, { numRuns: 5000 });
});
