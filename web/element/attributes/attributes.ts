import { type ValueColormap, valueColormaps } from '../../colour/colormaps.ts';
import type { Method } from '../../session/constraints/method.ts';
import { type Quantity, quantities, type View, views } from './view-settings.ts';

/** An attribute of the viewer, and the property of the same name. */
export interface Attribute<Value> {
  /** How text becomes a value: a flag is there or not, a choice is one of some words. */
  kind: 'text' | 'flag' | 'number' | 'choice';
  /** What the property is as long as nobody says anything. */
  initial: Value;
  /** What it is taken for then, as text: a state need not say that. */
  meaning?: string;
  choices?: readonly string[];
  /** It is part of what there is to say of a viewer to have the same again elsewhere. */
  isState: boolean;
  /** Setting it again to the same counts. */
  counts?: 'always';
}

interface Said {
  state?: false;
  means?: string;
  counts?: 'always';
}

const attribute = <Value>(kind: Attribute<Value>['kind'], initial: Value, said: Said): Attribute<Value> => ({
  kind,
  initial,
  isState: said.state !== false,
  ...(said.means === undefined ? {} : { meaning: said.means }),
  ...(said.counts ? { counts: said.counts } : {}),
});

const text = (said: Said = {}) => attribute<string | null>('text', null, said);
const flag = (said: Said = {}) => attribute('flag', false as boolean, said);
const number = (said: Said = {}) => attribute<number | null>('number', null, said);
/** The first choice is what no word, and one that is not known, stand for. */
const choice = <Word extends string>(choices: readonly Word[], said: Said = {}): Attribute<Word | null> => ({
  ...attribute<Word | null>('choice', null, { means: choices[0], ...said }),
  choices,
});

/** A property that the viewer writes itself, from what its session or its stage know better. */
const own = <Value>(each: Attribute<Value>) => ({ ...each, isOwn: true as const });

const accountings: readonly Method['errors'][] = ['tracked', 'propagated'];
const costs: readonly Method['cost'][] = ['introduced', 'maximum'];

/**
 * Everything that can be said of a viewer by attributes, once: the names of the properties (the attributes have them in kebab
 * case), kinds, defaults and what they mean; in the order in which a state has them. Properties, states, the manifest for
 * editors (web/element/manifest.config.mjs) and the table in the guide are made from this.
 */
export const attributes = {
  /** The address of a surface: PLY, VTP, legacy VTK, glTF, OBJ or STL, packed by gzip or not. */
  // Setting the same address again loads it again.
  src: text({ counts: 'always' }),
  /**
   * The bounds as text: `position: 1%; pressure: 3%; velocity: 0.2`, in percent of the variable's extent or in its unit;
   * `free` is no bound, `*` stands for every variable not named but identifiers. A variable that none reaches is free. What
   * cannot be a bound is refused. Default: 1 % in space and 3 % in every variable. Read, the bounds in force.
   */
  bounds: own(text()),
  /** How errors are accounted for: `tracked` (default) or `propagated`, as in the paper. */
  errors: choice(accountings),
  /** What retriangulation makes small where errors are propagated: the error `introduced` (default), or the `maximum`. */
  cost: choice(costs),
  /** Let no part of the surface pierce another one that passes near, which takes about half as long again. */
  refusePiercing: flag(),
  /** Limit the bound of position to half the smallest distance between two parts of the surface that face each other. */
  limitToFeatureSize: flag(),
  /** Leave out parts of the surface that are smaller than the bound of position, and count them; the guarantee is about the rest. */
  dropSmallComponents: flag(),
  /** Points that stay as they are, by their numbers in the surface as it is read, counted from 0: `3,17,20-40`. */
  lockPoints: text(),
  /**
   * A box whose inside stays as it is, in the unit of position: the lowest and the highest place along the axes,
   * `0,0,0,1,1,1`. Every triangle that meets it stays.
   */
  lockBox: text(),
  /** The cell data, of whole numbers, whose values part the surface into regions: their borders are kept within the bounds. */
  regions: text(),
  /** Regions that stay as they are, by their numbers: `2,5`. */
  lockRegions: text(),
  /** The variable, of one component and above zero everywhere, that multiplies every bound at each point of the original. */
  boundMultiplier: text(),
  /**
   * Where bounds are finer, as `x,y,z,radius,factor`: within the radius they are multiplied by the factor, 0…1, and rise
   * from there to what they are at twice the radius. With `bound-multiplier` both multiply.
   */
  focusPoint: text(),
  /** What the surfaces are coloured by: a variable, `position` among them. Default: the first that varies. */
  variable: text(),
  /** Which component of a vector: `magnitude` (default), or what it is called: x, y, z, or as in the file. */
  component: text(),
  /** What is shown of the variable: `value` (default), `error` as a share of its bound, or `signed-error`. */
  show: choice<Quantity>(quantities),
  /** The map for values; errors have maps of their own. Default: viridis. */
  colormap: choice<ValueColormap>(valueColormaps),
  /** What the map for values spans: `data` (default), percentiles as `2%…98%`, or two values as `0…1.5`. */
  range: text({ means: 'data' }),
  /**
   * `split` (default), `wipe` (one over the other, with a divider to drag), `original`, `reduced`, or `morph`
   * (the reduced surface with levels of detail, of which there are then four unless `level-count` says otherwise).
   */
  view: choice<View>(views),
  /** Whether the edges of the triangles are drawn. */
  edges: flag(),
  /** Whether every triangle is shaded as the plane that it is. */
  flat: flag(),
  /** Whether triangles are drawn only where their front is seen, so that one looks through the backs. */
  cull: flag(),
  /** Whether parallels stay parallel, instead of a perspective. */
  orthographic: flag(),
  /** A plane that cuts off one side, in the mesh's unit: `x < 0.5` keeps what is below. */
  clip: text(),
  /** Whether each side has a camera of its own, instead of one for both. */
  unlinked: flag(),
  /**
   * Where the camera stands and what it looks at, x y z each, where the surface lies within distance 1 of the origin:
   * `1.9 1.5 3.8 / 0 0 0`; two of these with `;` between where each side has a camera of its own. Null where all of the
   * surface is in view, as at first.
   */
  camera: own(text()),
  /**
   * How many nested levels of detail there are to be, with morphs between them: each has twice the bounds of the one before,
   * the first has `bounds`. At most 6; default: 0, none.
   */
  levelCount: own(number({ means: '0' })),
  /**
   * Which level is shown: 0 the original, 1 (default) the finest, and so on; between two whole numbers the way from one to
   * the other.
   */
  level: own(number({ means: '1' })),
  /**
   * Has the level chosen by its size on screen, the coarsest whose error in space spans no more than this many pixels; null
   * (default), and whenever `level` is set: it is not chosen so.
   */
  levelPixels: own(number()),
  /**
   * Closes cracks as a surface is read: points where sheets end that lie within this fraction of the extent of others, as
   * `1e-6`, are put into one place. Of the surfaces that are opened from then on.
   */
  weld: text({ state: false }),
  /** Whether there are a bar of controls above the stage and the result in words below it. */
  controls: flag({ state: false }),
  /** The address of an image to show until the first surface is drawn. */
  poster: text({ state: false }),
  /** `lazy`: nothing is loaded before the element comes near the part of the page in sight. */
  loading: choice(['eager', 'lazy'] as const, { state: false }),
  /** What the surface is, for those who cannot see it. */
  alt: text({ state: false }),
};

type Attributes = typeof attributes;
export type Property = keyof Attributes;

type ValueOf<Each> = Each extends Attribute<infer Value> ? Value : never;
type Kebab<Name extends string> = Name extends `${infer First}${infer Rest}`
  ? `${First extends Lowercase<First> ? First : `-${Lowercase<First>}`}${Kebab<Rest>}`
  : Name;

/** The properties that the viewer has from the table alone, with their values. */
export type Properties = {
  -readonly [Name in Property as Attributes[Name] extends { isOwn: true } ? never : Name]: ValueOf<Attributes[Name]>;
};
export type AttributeName = Kebab<Property>;

export const properties = Object.keys(attributes) as Property[];

/** Whether the viewer writes the property itself. */
export function isOwn(property: Property): boolean {
  return 'isOwn' in attributes[property];
}

/** What an attribute is called whose property is this. */
export function attributeName(property: Property): AttributeName {
  return property.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`) as AttributeName;
}
