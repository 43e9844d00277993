/** Space that does not break. */
const space = '\u00a0';

/** The English words that only the page shows, by the part that shows them: the element need not load them. */
export const pageEnglish = {
  bounds: {
    all: 'All',
    inProportion: 'in proportion',
    allHint: 'Sets the largest bound; the others keep their proportion to it.',
    largestInPercent: 'Largest bound in percent',
    of: (name: string) => `Bound of ${name}`,
    ofIn: (name: string, unit: string) => `Bound of ${name} in ${unit}`,
    percent: 'percent',
    itsUnit: 'its unit',
    value: 'value',
    stated: (name: string) => `How the bound of ${name} is stated`,
    bounded: 'bounded',
    isBounded: (name: string) => `${name} bounded`,
    multipliedHint: 'f multiplies the bounds: see “Finer bounds”.',
    by: (bound: string, multiplied: boolean) => `bounded by ${bound}${multiplied ? `${space}×${space}f` : ''}`,
    constant: 'constant',
    constantHint: 'Its values differ by rounding only: the percentage is of their magnitude.',
    identifier: 'identifier',
    identifierHint: 'It names things (numbers of points, masks): bounds for all variables are not about it.',
    nonFinite: 'has NaN',
    nonFiniteHint: 'It is NaN or infinite somewhere: it can have no bound, and is only carried along.',
    unknownError: 'error not known',
    unknownHint: 'The variable is NaN or infinite somewhere.',
    shownWith: (bound: string) => `shown with ${bound}:`,
    free: 'no bound',
    error: 'error',
    errorHint: 'No point of the surface has a larger error than this: show where it is.',
    undo: 'Undo',
    redo: 'Redo',
    stepHint: (step: string, keys: string) => `${step} the change of a bound (${keys})`,
    presets: 'Presets',
    presetNames: {
      fine: { text: 'Fine', title: '0.1 % in space, 0.3 % in every variable' },
      usual: { text: 'Usual', title: '1 % in space, 3 % in every variable' },
      coarse: { text: 'Coarse', title: '3 % in space, 9 % in every variable' },
      alike: { text: 'All alike', title: '1 % in space and in every variable' },
      shape: { text: 'Shape only', title: '1 % in space; every variable free' },
    },
  },

  chart: {
    title: 'Triangles by bound',
    what: 'Triangles left against the largest bound, the others in proportion.',
    point: (triangles: string, bound: string) => `${triangles} at ${bound}`,
    points: (points: string[]) => `Triangles left by the largest bound: ${points.join(', ') || 'not measured yet'}.`,
  },

  spread: {
    title: 'Errors by area',
    what: (measured: boolean) =>
      `How much of the area has which error, ${measured ? 'at the original’s vertices' : 'at most, in each reduced triangle'}. Dashed: the largest anywhere.`,
    folds: (cells: string, folded: string, share: string | null) =>
      `The map cuts the original into ${cells} cells and folds ${folded} of them${share ? ` (${share})` : ''}, within the bounds.`,
    axis: 'error / bound',
    free: 'free',
    short: (half: string, most: string) => `half ≤ ${half}, 95${space}% ≤ ${most}`,
    long: (half: string, most: string) => `half of the area ≤ ${half}, 95 % of it ≤ ${most} of the bound`,
  },

  method: {
    title: 'Method',
    now: (errors: string, ticked: string[]) => [`${errors} errors`, ...ticked].join(', '),
    short: {
      refusePiercing: 'no piercing',
      limitToFeatureSize: 'feature size',
      dropSmallComponents: 'small parts dropped',
    },
    errors: 'Errors',
    keepsSmall: 'Keeps small',
    means: {
      tracked: 'Every error is measured against the original: nothing is overestimated, and fewer triangles are left.',
      propagated:
        'Errors are added up removal by removal, as by Bajaj and Schikore (1996): limits from above, more triangles.',
    },
    costs: { introduced: 'error introduced', maximum: 'maximum error' },
    refusePiercing: 'Let no part pierce another',
    limitToFeatureSize: 'Limit space to feature size',
    nearParts:
      'Where parts pass near each other: keep them apart exactly, which takes about half as long again; or limit the bound in space to half their distance.',
    dropSmallComponents: 'Drop parts smaller than the bound',
    smallParts:
      'Parts of the surface whose box has a diagonal within the bound in space are left out and counted; the guarantee is about the rest.',
  },

  report: {
    title: 'Report',
    now: (unusual: string[]) => unusual.join(', ') || 'nothing unusual',
    unusual: {
      vanished: 'regions vanished',
      limited: 'space limited',
      flippedNormals: 'more turned over',
      turnedRound: 'turned round',
      oneSided: 'one-sided',
    },
    flippedNormals: 'Turned over 90°',
    folds: 'Folds of the map',
    foldsAre: (folded: string, cells: string) => `${folded} of ${cells} cells`,
    noMap: 'no map',
    beforeAndAfter: (before: string, after: string) => `${after} triangles (${before} before)`,
    orientation: 'Orientation',
    orientationIs: (turned: string, triangles: number, without: string, parts: number) =>
      [
        triangles > 0 ? `${turned} ${triangles === 1 ? 'triangle' : 'triangles'} turned round` : '',
        parts > 0 ? `${without} ${parts === 1 ? 'part has' : 'parts have'} no two sides` : '',
      ]
        .filter(Boolean)
        .join(', ') || 'the same everywhere',
    regions: 'Regions',
    noRegions: 'none',
    regionsAre: (kept: string, vanished: string[]) =>
      `${kept} kept${vanished.length > 0 ? `; vanished: ${vanished.join(', ')}` : ''}`,
    nonManifold: 'Non-manifold vertices',
    featureSize: 'Feature size',
    featureSizeIs: (size: string | null, asked: boolean) =>
      size ? `${size}: space is limited to half of it` : asked ? 'does not limit the bound' : 'not asked for',
    smallParts: 'Small parts',
    partsDropped: (count: string, parts: number) => `${count} ${parts === 1 ? 'part' : 'parts'} dropped`,
    smallPartsAre: (parts: string, triangles: string, asked: boolean) =>
      asked ? `${parts} dropped (${triangles} triangles)` : 'not dropped',
  },

  verification: {
    title: 'Verification',
    now: { notYet: 'not asked for', holds: 'bounds hold', broken: 'a bound is broken', fault: 'failed' },
    progress: (percent: number) => `${percent}${space}%`,
    what: 'A judge who knows nothing of the reduction compares the two surfaces as they are: from many points of each, how far is the other?',
    dropped: 'Small parts were dropped, which a judge would miss: the whole surface cannot be verified.',
    verify: 'Verify',
    cancel: 'Cancel',
    holds: (samples: string) => `Every bound holds at each of ${samples} points. The farthest, in bounds:`,
    broken: 'A bound is broken. The farthest points, in bounds:',
    farthest: (share: string, variable: string) => `${share}, in ${variable}`,
    nothing: 'none',
    nothingNear: 'no counterpart',
    surface: { fromOriginal: 'Original to reduced', fromReduced: 'Reduced to original' },
    boundary: { fromOriginal: 'Its boundary', fromReduced: 'The reduced boundary' },
  },

  pin: { hint: 'Pin a place on the original first: by a click, or Enter' },

  locks: {
    title: 'Locks and regions',
    now: (points: boolean, box: boolean, regions: number, of: string | null) =>
      [
        points ? 'points' : '',
        box ? 'a box' : '',
        regions > 0
          ? `${regions} ${regions === 1 ? 'region' : 'regions'} of ${of}`
          : of === null
            ? ''
            : `borders of ${of}`,
      ]
        .filter(Boolean)
        .join(', ') || 'none',
    points: 'Points',
    pointsMean: 'Points that stay, by their numbers in the surface, counted from 0: 3,17,20-40.',
    addPin: 'Add the pinned point',
    addPinMeans: 'The point of the original that is nearest to the pinned place.',
    box: 'Lock what meets a box',
    boxMeans: 'Every triangle that meets the box stays as it is. The box is drawn on the original.',
    unmet: 'No triangle meets the box: nothing stays because of it.',
    lowest: 'from',
    highest: 'to',
    place: (end: string, axis: string) => `Locked ${end} ${axis}`,
    aroundPin: 'Around the pinned place',
    regions: 'Regions from',
    none: 'none',
    regionsMean: 'Borders between different labels of the triangles are kept within the bounds, and so are the labels.',
    lockRegions: 'Locked regions',
    noRegions: 'This surface has no cell data of whole numbers, and no materials, that could part it into regions.',
  },

  multiplier: {
    title: 'Finer bounds',
    now: (variable: string | null, factor: string | null) =>
      [variable ? `× ${variable}` : '', factor ? `× ${factor} near a place` : ''].filter(Boolean).join(', ') ||
      'the same everywhere',
    variable: 'Multiply by',
    nothing: 'nothing',
    noVariable: 'No variable can multiply the bounds: it needs one component, above zero everywhere.',
    point: 'Finer near a place',
    place: 'at',
    at: (axis: string) => `Place ${axis}`,
    radius: 'radius',
    factor: 'times',
    toPin: 'At the pinned place',
    badRadius: 'The radius must be above zero.',
    badFactor: 'The factor must be above zero and at most 1.',
    means:
      'At each point of the original every bound is multiplied by the value there of the variable chosen: 0.1 makes it ten times finer, 2 twice as loose. Near a place it is multiplied by the factor, within the radius; from there the factor rises to 1 at twice the radius. Errors are then compared with the multiplied bounds.',
  },

  numbers: { none: 'A number is needed.' },

  keys: {
    title: 'Keys',
    hint: 'Keys (h)',
    sign: '?',
    close: 'Close',
    list: [
      ['h', 'this list'],
      ['o', 'open a file'],
      ['e', 'edges'],
      ['f', 'fit into view'],
      ['Ctrl Z, Ctrl Y', 'undo and redo the change of a bound'],
      ['Tab, Shift Tab', 'go through all controls, and to the surfaces'],
      ['← → ↑ ↓', 'on a surface: turn it; on a slider or the divider: move it'],
      ['Shift ← → ↑ ↓', 'on a surface: move it'],
      ['+ and −', 'on a surface: nearer, farther'],
      ['0', 'on a surface: fit into view'],
      ['Enter', 'on a surface: pin what its middle shows; a click pins any place'],
      ['Esc', 'let go of it'],
    ],
  },

  page: {
    title: 'Meshbound',
    open: 'Open…',
    sample: 'Sample',
    chooseSample: 'choose…',
    drop: 'Drop to open',
    copied: 'Copied',
    save: 'Save…',
    saveEarlier: 'Save the earlier result…',
    saved: {
      ply: { text: 'PLY', title: 'The reduced surface with all variables' },
      vtp: { text: 'VTP', title: 'The reduced surface with all variables, for ParaView' },
      vtk: { text: 'Legacy VTK', title: 'The reduced surface with all variables' },
      glb: { text: 'GLB', title: 'The reduced surface for viewers of glTF, in single precision' },
      obj: { text: 'OBJ', title: 'The reduced surface; of its variables only what the format holds' },
      stl: { text: 'STL', title: 'The reduced surface without variables' },
      report: { text: 'Report (JSON)', title: 'Bounds, errors and counts' },
      levels: { text: 'Levels (GLB)', title: 'All levels of detail in one file (MSFT_lod), in single precision' },
      map: { text: 'Map (VTP)', title: 'The original with where each vertex went, and what error it has there' },
    },
    picture: { text: 'Picture (PNG)', title: 'What is seen, with its legends' },
    barePicture: { text: 'Picture, no legends', title: 'The surfaces alone' },
    share: 'Share…',
    noLink: {
      text: 'Copy link',
      title: 'A link cannot hold a file of yours: put it where an address reaches it, and open that.',
    },
    copyLink: { text: 'Copy link', title: 'An address of this page with the same surface, bounds and view' },
    copyEmbed: { text: 'Copy embed code', title: 'A viewer for a page of your own' },
    saveState: { text: 'Save state', title: 'Bounds and view as a file' },
    loadState: { text: 'Load state…', title: 'Or drop such a file here' },
  },
} as const;
