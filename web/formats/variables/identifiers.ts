import type { Variable } from '../../../wasm/types.ts';
import { listed } from '../text/wording.ts';

/** Names by which programs call numbers that tell things apart and measure nothing; without separators, in small letters. */
const identifierNames = new RegExp(
  `^(${[
    '(global|local|original)(node|point|vertex|element|cell|face|region)?(ids?|numbers?|index|indices)',
    '(node|point|vertex|element|cell|face|region|part|patch|body|surface|material|block|object|process|processor|rank|piece|model)ids?',
    'vtk(original|composite|block)?(point|cell|node|face|element)?(ids?|index|indices)',
    '(vtk)?pedigree(node|point|vertex|element|cell)?ids?',
    'vtk(valid(point|cell)mask|ghosttype|ghostlevels)',
    'ids?',
  ].join('|')})$`,
);

/** So few values are all different by chance. */
const mostByChance = 8;
const valuesOfMask = 2;

function isIdentifierName(name: string): boolean {
  return identifierNames.test(name.toLowerCase().replace(/[^a-z0-9]/g, ''));
}

/**
 * Says of each variable whether it is an identifier: by its name, or, where the file holds it in a whole-number type, by its
 * values at the corners of triangles, which are all different (ids) or at most two (a mask). Whole numbers that a file holds in
 * floating point, such as heights, are quantities.
 */
export function withKinds(
  variables: Variable[],
  triangles: Uint32Array,
  isWhole: (name: string) => boolean = () => false,
  isDeclared: (name: string) => boolean = () => false,
): Variable[] {
  return variables.map((variable) => {
    const { name, components } = variable;
    const byType = () => components === 1 && isWhole(name) && tellsApart(variable, triangles);
    const identifies = isDeclared(name) || (components === 1 && isIdentifierName(name)) || byType();
    return identifies ? { ...variable, kind: 'identifier' as const } : variable;
  });
}

function tellsApart({ values }: Variable, triangles: Uint32Array): boolean {
  const corners = new Set(triangles);
  const different = new Set<number>();
  for (const corner of corners) different.add(values[corner]);
  return different.size <= valuesOfMask || (different.size === corners.size && corners.size > mostByChance);
}

/** A sentence about the variables that were taken for identifiers; none where there are none. */
export function identifierNotes(variables: Variable[]): string[] {
  const names = variables.filter(({ kind }) => kind === 'identifier').map(({ name }) => name);
  if (names.length === 0) return [];
  return [`Taken for identifiers, which “*” does not bound: ${listed(names)}; a bound with the name (NAME=…) does.`];
}
