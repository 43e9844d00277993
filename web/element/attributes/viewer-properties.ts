import { LitElement, type PropertyDeclarations } from 'lit';
import type { ValueColormap } from '../../colour/colormaps.ts';
import type { Method } from '../../session/constraints/method.ts';
import type { WantedKeeping } from './keeping-attributes.ts';
import type { Quantity, View, WantedView } from './view-settings.ts';

/**
 * What is asked of a viewer, each by an attribute or its property. What its session or its stage know better, as its bounds and
 * its camera, is the viewer's own.
 */
export class ViewerProperties extends LitElement implements WantedView, WantedKeeping {
  static override properties: PropertyDeclarations = {
    // Setting the same address again loads it again.
    src: { hasChanged: () => true },
    weld: {},
    errors: {},
    cost: {},
    refusePiercing: { attribute: 'refuse-piercing', type: Boolean },
    limitToFeatureSize: { attribute: 'limit-to-feature-size', type: Boolean },
    dropSmallComponents: { attribute: 'drop-small-components', type: Boolean },
    lockPoints: { attribute: 'lock-points' },
    lockBox: { attribute: 'lock-box' },
    regions: {},
    lockRegions: { attribute: 'lock-regions' },
    boundMultiplier: { attribute: 'bound-multiplier' },
    focusPoint: { attribute: 'focus-point' },
    variable: {},
    component: {},
    show: {},
    colormap: {},
    range: {},
    view: {},
    edges: { type: Boolean },
    flat: { type: Boolean },
    cull: { type: Boolean },
    orthographic: { type: Boolean },
    clip: {},
    unlinked: { type: Boolean },
    controls: { type: Boolean },
    poster: {},
    loading: {},
    alt: {},
  };

  /** The address of a surface: PLY, VTP, legacy VTK, glTF, OBJ or STL, packed by gzip or not. */
  declare src: string | null;
  /**
   * Closes cracks as a surface is read: points where sheets end that lie within this fraction of the extent of others, as `1e-6`, are
   * put into one place. Of the surfaces that are opened from then on.
   */
  declare weld: string | null;
  /** How errors are accounted for: `tracked` (default) or `propagated`, as in the paper. */
  declare errors: Method['errors'] | null;
  /** What retriangulation makes small where errors are propagated: the error `introduced` (default), or the `maximum`. */
  declare cost: Method['cost'] | null;
  /**
   * Let no part of the surface pierce another one that passes near, which takes about half as long again.
   *
   * @attr refuse-piercing
   */
  declare refusePiercing: boolean;
  /**
   * Limit the bound of position to half the smallest distance between two parts of the surface that face each other.
   *
   * @attr limit-to-feature-size
   */
  declare limitToFeatureSize: boolean;
  /**
   * Leave out parts of the surface that are smaller than the bound of position, and count them; the promise is about the rest.
   *
   * @attr drop-small-components
   */
  declare dropSmallComponents: boolean;
  /**
   * Points that stay as they are, by their numbers in the surface as it is read, counted from 0: `3,17,20-40`.
   *
   * @attr lock-points
   */
  declare lockPoints: string | null;
  /**
   * A box whose inside stays as it is, in the unit of position: the lowest and the highest place along the axes,
   * `0,0,0,1,1,1`. Every triangle that meets it stays.
   *
   * @attr lock-box
   */
  declare lockBox: string | null;
  /** The cell data, of whole numbers, whose values part the surface into regions: their borders are kept within the bounds. */
  declare regions: string | null;
  /**
   * Regions that stay as they are, by their numbers: `2,5`.
   *
   * @attr lock-regions
   */
  declare lockRegions: string | null;
  /**
   * The variable, of one component and above zero everywhere, that multiplies every bound at each point of the original.
   *
   * @attr bound-multiplier
   */
  declare boundMultiplier: string | null;
  /**
   * Where bounds are finer, as `x,y,z,radius,factor`: within the radius they are multiplied by the factor, 0…1, and rise
   * from there to what they are at twice the radius. With `bound-multiplier` both multiply.
   *
   * @attr focus-point
   */
  declare focusPoint: string | null;
  /** What the surfaces are coloured by: a variable, `position` among them. Default: the first that varies. */
  declare variable: string | null;
  /** Which component of a vector: `magnitude` (default), or what it is called: x, y, z, or as in the file. */
  declare component: string | null;
  /** What is shown of the variable: `value` (default), `error` as a share of its bound, or `signed-error`. */
  declare show: Quantity | null;
  /** The map for values; errors have maps of their own. Default: viridis. */
  declare colormap: ValueColormap | null;
  /** What the map for values spans: `data` (default), percentiles as `2%…98%`, or two values as `0…1.5`. */
  declare range: string | null;
  /**
   * `split` (default), `wipe` (one over the other, with a divider to drag), `original`, `reduced`, or `morph`
   * (the reduced surface with levels of detail, of which there are then four unless `level-count` says otherwise).
   */
  declare view: View | null;
  /** Whether every triangle is shaded as the plane that it is. */
  declare flat: boolean;
  /** Whether triangles are drawn only where their front is seen, so that one looks through the backs. */
  declare cull: boolean;
  /** Whether parallels stay parallel, instead of a perspective. */
  declare orthographic: boolean;
  /** A plane that cuts off one side, in the mesh's unit: `x < 0.5` keeps what is below. */
  declare clip: string | null;
  /** Whether the edges of the triangles are drawn. */
  declare edges: boolean;
  /** Whether each side has a camera of its own, instead of one for both. */
  declare unlinked: boolean;
  /** Whether there are a bar of controls above the stage and the result in words below it. */
  declare controls: boolean;
  /** The address of an image to show until the first surface is drawn. */
  declare poster: string | null;
  /** `lazy`: nothing is loaded before the element comes near the part of the page in sight. */
  declare loading: 'eager' | 'lazy' | null;
  /** What the surface is, for those who cannot see it. */
  declare alt: string | null;

  constructor() {
    super();
    this.src = null;
    this.weld = null;
    this.errors = null;
    this.cost = null;
    this.refusePiercing = false;
    this.limitToFeatureSize = false;
    this.dropSmallComponents = false;
    this.lockPoints = null;
    this.lockBox = null;
    this.regions = null;
    this.lockRegions = null;
    this.boundMultiplier = null;
    this.focusPoint = null;
    this.variable = null;
    this.component = null;
    this.show = null;
    this.colormap = null;
    this.range = null;
    this.view = null;
    this.flat = false;
    this.cull = false;
    this.orthographic = false;
    this.clip = null;
    this.edges = false;
    this.unlinked = false;
    this.controls = false;
    this.poster = null;
    this.loading = null;
    this.alt = null;
  }
}
