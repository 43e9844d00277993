/** Space that does not break. */
const space = '\u00a0';

/** "a", "a and b", "a, b and c" */
function listed(names: string[]): string {
  return names.length < 2 ? names.join('') : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`;
}

/**
 * Every English word that the element and the page show, by the part that shows it. What numbers look like is said by
 * `number-text.ts`, what is wrong with a file or a bound by what reads it.
 */
export const english = {
  triangles: (count: number) => (count === 1 ? 'triangle' : 'triangles'),

  promise: {
    space: 'space',
    counted: (after: string, before: string, triangles: string) => `${after} of ${before} ${triangles}.`,
    proved: (bounds: string, used: string) => `Every point within ${bounds}: proved; ${used}.`,
    bound: (bound: string, names: string[]) => `${bound} in ${listed(names)}`,
    multiplied: ', times the multiplier there',
    dropped: (count: string, parts: number) =>
      `${count} small ${parts === 1 ? 'part' : 'parts'} left out: nothing promised of ${parts === 1 ? 'it' : 'them'}.`,
    noError: 'no error at all',
    mostUsed: (name: string, error: string, share: string) => `most used: ${name}, ${error} (${share} of its bound)`,
    mostUsedThere: (name: string, error: string, share: string) =>
      `most used: ${name}, ${share} of its bound there; its largest error is ${error}`,
    atMost: (error: string) => `at most ${error}`,
    free: (names: string[]) => `Free, so nothing promised: ${listed(names)}.`,
  },

  heldBack: {
    nothing: 'Nothing holds it back.',
    what: 'Why the vertices that are still there could not go',
    most: 'Held back most by',
    next: (shares: string[]) => (shares.length > 0 ? `then ${shares.join(', ')}` : 'and nothing else'),
    folds: 'folds',
    piercing: 'near parts',
    topology: 'topology',
    fixed: 'fixed vertices',
  },

  progress: {
    phases: { download: 'Downloading', read: 'Reading', check: 'Checking' },
    percent: (percent: number) => ` ${percent}${space}%`,
    reducing: (percent: number) => `Reducing… ${percent}${space}%`,
    cancel: 'Cancel',
    cancelled: 'Cancelled',
    keptBefore: 'The result shown, and saved, is the one before.',
    reduce: 'Reduce',
    removed: (share: string, time: string) => `${share} removed in ${time}`,
  },

  faults: {
    noSurface: 'No surface is open.',
    noPicture: 'There is no picture: nothing can be drawn.',
    noLevels: 'There are no levels of detail.',
    noMap: 'There is no map: only tracked errors make one.',
    namesTaken: (names: string) => `The map needs the names of the variables ${names} for itself.`,
    aborted: 'The reduction was aborted.',
    failed: 'The reduction failed.',
    noWebGl: 'Nothing can be drawn: this browser offers no WebGL 2. Reducing and saving still work.',
    stateNotJson: 'This is no state of the viewer: it is not JSON.',
    stateMissing: 'This is no state of the viewer: “meshbound” is missing.',
    linkToFile: 'A link cannot hold a file of yours: put it where an address reaches it, and open that.',
    attribute: (name: string, text: string, why: string) => `${name} cannot be “${text}”: ${why}`,
    cannotCopy: (text: string) => `The browser does not let this page copy. ${text}`,
  },

  notices: { dismiss: 'Dismiss' },

  stage: {
    surfaces: { original: 'original surface', reduced: 'reduced surface' },
    keys: 'Arrow keys turn, with Shift they move, plus and minus zoom, 0 fits, Enter probes the middle.',
    original: 'Original',
    reduced: 'Reduced',
    reducing: 'Reducing…',
    notReduced: 'Not reduced',
    level: (level: number) => `Level ${level}`,
    levelZero: 'Original, as level 0',
    onTheWay: 'On the way to level',
    divider: 'How much of the stage shows the original',
    dividerAt: (percent: number) => `${percent} percent`,
  },

  legend: {
    lowest: (value: string) => `min ${value}`,
    highest: (value: string) => `max ${value}`,
    beyondNever: 'beyond: never',
    aboveOneNever: 'above 1: never',
    noBound: 'no bound',
    share: (name: string, free: boolean) => `error / bound: ${name}${free ? ' (free: no bound)' : ''}`,
    signed: (name: string) => `signed error: ${name}`,
    lowestBound: '−bound',
    highestBound: '+bound',
    lowestError: '−largest',
    highestError: '+largest',
    unknownErrors: 'values: errors at its vertices are known only when tracked',
    atVertices: 'true error at each vertex',
    inTriangles: 'largest error in each triangle',
    limitInTriangles: 'upper limit of the error in each triangle',
    multiplied: '; of the bound as it is multiplied there',
    difference: `; original${space}−${space}reduced`,
    alongNormal: '; along the normal, + where the reduced surface is outside',
    summedAlongNormals: '; summed along the normals, + where the reduced surface is outside',
  },

  probe: {
    name: 'Probe',
    pin: 'Click to pin',
    pinned: 'Pinned',
    unpin: 'Unpin',
    letGo: 'Let go (Esc)',
    original: 'original',
    reduced: 'reduced',
    error: 'error',
    ofBound: 'of bound',
    free: 'free',
    toWorst: (name: string) => `To where the error of ${name} is largest`,
    folded: (points: number, isLargest: boolean) =>
      `${points} points of the original are mapped here${isLargest ? '; this is the one with the largest error' : ''}.`,
    largest: (name: string, share: string) => `Pinned. Largest error: ${name}, ${share} of its bound.`,
    unknown: 'Pinned. No error is known here.',
  },

  view: {
    colour: 'Colour',
    show: 'Show',
    quantities: { value: 'values', error: 'error / bound', 'signed-error': 'signed error' },
    map: 'Map',
    ownMaps: 'Errors have colour maps of their own.',
    view: 'View',
    views: { split: 'side by side', wipe: 'wipe', original: 'original', reduced: 'reduced', morph: 'morph' },
    edges: 'Edges',
    oneCamera: 'One camera',
    more: 'More',
    fit: 'Fit',
    flat: 'Flat shading',
    bothSides: 'Both sides of triangles',
    parallel: 'Parallel, no perspective',
    range: 'Range',
    rangeHint: 'data, percentiles as 2%…98%, or two values as 0…1.5',
    cut: 'Cut at',
    cutHint: 'A plane: x < 0.5 keeps what is below, z > 2 what is above; empty, all',
    cutKeeps: 'What the cut keeps',
    cutKeepsAll: 'all',
    cutPlace: 'Place of the cut',
    noCut: 'no cut',
    axes: 'Look along an axis',
    from: (axis: string) => `From ${axis}`,
  },

  bounds: {
    title: 'Bounds',
    all: 'All',
    inProportion: 'in proportion',
    allHint: 'Sets the largest bound; the others keep their proportion to it.',
    allBounds: 'All bounds',
    largest: (percent: string) => `largest ${percent}`,
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
      dropSmallParts: 'small parts dropped',
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
      'Where parts pass near each other: keep them apart exactly, in about half the time more; or limit the bound in space to half their distance.',
    dropSmallParts: 'Drop parts smaller than the bound',
    smallParts:
      'Parts of the surface whose box has a diagonal within the bound in space are left out and counted; the promise is about the rest.',
  },

  report: {
    title: 'Report',
    now: (unusual: string[]) => unusual.join(', ') || 'nothing unusual',
    unusual: {
      vanished: 'regions vanished',
      limited: 'space limited',
      turnedAway: 'more turned over',
      turnedRound: 'turned round',
      oneSided: 'one-sided',
    },
    turnedAway: 'Turned over 90°',
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

  pin: { hint: 'Pin a place on the original first: by a click, or Enter' },

  locks: {
    title: 'Locks and regions',
    now: (box: boolean, regions: number, of: string | null) =>
      [
        box ? 'a box' : '',
        regions > 0
          ? `${regions} ${regions === 1 ? 'region' : 'regions'} of ${of}`
          : of === null
            ? ''
            : `borders of ${of}`,
      ]
        .filter(Boolean)
        .join(', ') || 'none',
    box: 'Lock what meets a box',
    boxMeans: 'Every triangle that meets the box stays as it is. The box is drawn on the original.',
    lowest: 'from',
    highest: 'to',
    place: (end: string, axis: string) => `Locked ${end} ${axis}`,
    aroundPin: 'Around the pinned place',
    regions: 'Regions from',
    none: 'none',
    regionsMean: 'Borders between different labels of the triangles are kept within the bounds, and so are the labels.',
    lockRegions: 'Locked regions',
    noRegions: 'This surface has no cell data of whole numbers that could part it into regions.',
  },

  focus: {
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
    means:
      'At each point of the original every bound is multiplied by f, what stands there: 0.1 makes it ten times finer, 2 twice as loose. Near a place it is the factor within the radius, and rises to 1 at twice the radius. Errors are then compared with the multiplied bounds.',
  },

  levels: {
    title: 'Levels of detail',
    region: 'Detail',
    none: 'none',
    what: 'Coarser and coarser, with a smooth way from one to the next',
    making: (percent: number) => `Making levels: ${percent} %`,
    position: 'Position among levels',
    choice: 'Which level',
    choiceHint: 'By hand, or the coarsest whose error in space spans no more on screen',
    byHand: 'by hand',
    pixels: (pixels: number) => `error ≤ ${pixels} px`,
    original: 'Original',
    originalSign: 'O',
    level: (level: number) => `Level ${level}`,
    theOriginal: 'The original',
    at: (level: number, triangles: string, factor: number) =>
      `Level ${level}: ${triangles} triangles, bounds × ${factor}`,
    between: (percent: number, from: number, pieces: string | null) =>
      `${percent} % from ${from === 0 ? 'the original' : `level ${from}`} to level ${from + 1}${pieces ? `, ${pieces} pieces` : ''}`,
  },

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
    copyLink: { text: 'Copy link', title: 'An address of this page with the same surface, bounds and view' },
    copyEmbed: { text: 'Copy embed code', title: 'A viewer for a page of your own' },
    saveState: { text: 'Save state', title: 'Bounds and view as a file' },
    loadState: { text: 'Load state…', title: 'Or drop such a file here' },
  },
} as const;
