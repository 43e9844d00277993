import type { Variable } from '../../../wasm/types.ts';

/** What a variable is where formats have a place of their own for it. */
export type Role = 'normal' | 'textureCoordinates' | 'colour' | 'globalIds' | 'pedigreeIds';

/** How the formats spell a role. */
interface Spelling {
  /** The numbers of components that a variable of this role can have. */
  components: readonly number[];
  /** What such variables are called, in small letters without separators; the first is the name where a format has none. */
  names: readonly string[];
  /** PLY: properties, one a component. The first of each length is the one that is written. */
  ply?: readonly (readonly string[])[];
  /** glTF: the semantic of an attribute. */
  gltf?: string;
  /** OBJ: how the lines begin. */
  obj?: 'v' | 'vt' | 'vn';
  /** VTP: the attribute of PointData that names the array. */
  vtp?: string;
  /** Legacy VTK: the keyword before the array. */
  vtk?: string;
}

/** The one place that knows how a format spells what. */
export const spellings: Readonly<Record<Role, Spelling>> = {
  normal: {
    components: [3],
    names: ['normal', 'normals'],
    ply: [['nx', 'ny', 'nz']],
    gltf: 'NORMAL',
    obj: 'vn',
    vtp: 'Normals',
    vtk: 'NORMALS',
  },
  // Here, as in all formats but glTF, v rises from the lower edge of a picture.
  textureCoordinates: {
    components: [2],
    names: ['uv', 'tcoords', 'texcoords', 'texturecoordinates'],
    ply: [
      ['texture_u', 'texture_v'],
      ['s', 't'],
      ['u', 'v'],
    ],
    gltf: 'TEXCOORD_0',
    obj: 'vt',
    vtp: 'TCoords',
    vtk: 'TEXTURE_COORDINATES',
  },
  colour: {
    components: [3, 4],
    names: ['color', 'colors', 'colour', 'colours', 'rgb', 'rgba'],
    ply: [
      ['red', 'green', 'blue', 'alpha'],
      ['red', 'green', 'blue'],
    ],
    gltf: 'COLOR_0',
    obj: 'v',
    vtk: 'COLOR_SCALARS',
  },
  // By a declaration alone; what identifies by its name is told by identifiers.ts.
  globalIds: { components: [1], names: [], vtp: 'GlobalIds', vtk: 'GLOBAL_IDS' },
  pedigreeIds: { components: [1], names: [], vtp: 'PedigreeIds', vtk: 'PEDIGREE_IDS' },
};

const roles = Object.keys(spellings) as Role[];

type Shape = Pick<Variable, 'name' | 'components'>;

/** What files declare their variables to be, by name. */
export interface Declared {
  roles?: Record<string, Role>;
}

/** The role of a variable: as its file declares it, or by its name; undefined where it has none. */
export function roleOf(variable: Shape, { roles: declared = {} }: Declared = {}): Role | undefined {
  const { name, components } = variable;
  const said = Object.hasOwn(declared, name) ? declared[name] : undefined;
  if (said && spellings[said].components.includes(components)) return said;
  const plain = name.toLowerCase().replace(/[^a-z0-9]/g, '');
  return roles.find((role) => spellings[role].names.includes(plain) && spellings[role].components.includes(components));
}

/** The variables that take the places of the roles in a file: of each role the first one, those that a file declared before others. */
export function byRole<Each extends Shape>(variables: readonly Each[], labels: Declared = {}): Map<Role, Each> {
  const { roles: declared = {} } = labels;
  const isDeclared = ({ name }: Each) => (Object.hasOwn(declared, name) ? 1 : 0);
  const found = new Map<Role, Each>();
  for (const variable of variables.toSorted((a, b) => isDeclared(b) - isDeclared(a))) {
    const role = roleOf(variable, labels);
    if (role && !found.has(role)) found.set(role, variable);
  }
  return found;
}

/** The role that PLY spells by these properties; undefined where they are none's. */
export function roleOfProperties(properties: readonly string[]): Role | undefined {
  const spelled = properties.join(' ');
  return roles.find((role) => spellings[role].ply?.some((each) => each.join(' ') === spelled));
}

/** The role that a format spells so; undefined where the spelling is none. */
export function roleSpelled(format: 'gltf' | 'obj' | 'vtp' | 'vtk', spelling: string): Role | undefined {
  return roles.find((role) => spellings[role][format] === spelling);
}

/** Whether variables of this role tell things apart and measure nothing. */
export function identifies(role: Role | undefined): boolean {
  return role === 'globalIds' || role === 'pedigreeIds';
}

/** Declares what a variable is where its name does not tell. */
export function declareRole(declared: Record<string, Role>, variable: Shape, role: Role | undefined): void {
  if (role && roleOf(variable) !== role) declared[variable.name] = role;
}

/** What a variable of this role is called where its format has no names. */
export function nameOf(role: Role): string {
  return spellings[role].names[0];
}
