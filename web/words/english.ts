/** Space that does not break. */
const space = '\u00a0';

/** "a", "a and b", "a, b and c" */
function listed(names: string[]): string {
  return names.length < 2 ? names.join('') : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`;
}

/**
 * Every English word that the element shows, by the part that shows it, and what the page has in common with it. What
 * numbers look like is said by `number-text.ts`, what is wrong with a file or a bound by what reads it.
 */
export const english = {
  triangles: (count: number) => (count === 1 ? 'triangle' : 'triangles'),

  guarantee: {
    space: 'space',
    counted: (after: string, before: string, triangles: string) => `${after} of ${before} ${triangles}.`,
    proved: (bounds: string, used: string) => `Every point within ${bounds}: proved; ${used}.`,
    bound: (bound: string, names: string[]) => `${bound} in ${listed(names)}`,
    multiplied: ', times the multiplier there',
    dropped: (count: string, parts: number) =>
      `${count} small ${parts === 1 ? 'part' : 'parts'} left out: nothing guaranteed of ${parts === 1 ? 'it' : 'them'}.`,
    noError: 'no error at all',
    rounding: 'no error beyond rounding',
    mostUsed: (name: string, error: string, share: string) => `most used: ${name}, ${error} (${share} of its bound)`,
    mostUsedThere: (name: string, error: string, share: string) =>
      `most used: ${name}, ${share} of its bound there; its largest error is ${error}`,
    atMost: (error: string) => `at most ${error}`,
    free: (names: string[]) => `Free, so nothing guaranteed: ${listed(names)}.`,
  },

  sentence: {
    provisional: 'Provisional:',
    /** Before the sentence on a result that is not the answer to what is asked for. */
    earlier: {
      running: 'With the bounds before:',
      cancelled: 'Not with what is asked for, which was cancelled, but with the bounds before:',
      refused: 'Not with what is asked for, which was refused, but with the bounds before:',
    },
    notReduced: (reason: string) => `Not reduced. ${reason}`,
    levelZero: 'Shown is the original. Level 1:',
    onTheWay: (level: number) => `On the way to level ${level}. There:`,
    all: 'Show all',
    less: 'Show less',
  },

  heldBack: {
    nothing: 'Nothing holds it back.',
    what: 'Why the vertices that are still there could not go',
    most: 'Held back most by',
    next: (shares: string[]) => (shares.length > 0 ? `then ${shares.join(', ')}` : 'and nothing else'),
    reasons: {
      nonManifold: 'where curves meet',
      locked: 'locked vertices',
      ring: 'large rings',
      topology: 'topology',
      fold: 'folds',
      piercing: 'near parts',
    },
  },

  /** Why little went though the bounds would let it, behind the share of the vertices left that this kept. */
  littleWent: {
    sentence: (share: string, reason: string) =>
      `Why so little went: ${share}${space}% of the vertices left ${reason}.`,
    reasons: {
      nonManifold:
        'stand where curves meet or end: where three or more triangles share an edge, regions or seams meet, or parts touch in a point',
      locked: 'are locked',
      ring: 'have more than 48 neighbours, too many to fill the hole that they would leave',
      topology: 'cannot go without making another surface: a hole would close, or parts grow together',
      fold: 'cannot go without a fold, or without turning the surface away from where it faced',
      piercing: 'cannot go without piercing another part of the surface',
    },
  },

  progress: {
    phases: { download: 'Downloading', read: 'Reading', check: 'Checking' },
    percent: (percent: number) => ` ${percent}${space}%`,
    reducing: (percent: number) => `Reducing… ${percent}${space}%`,
    exact: (percent: number) => `Exact answer… ${percent}${space}%`,
    savedLater: 'Saved as soon as the answer to what is asked for is there.',
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
    attribute: (name: string, text: string, why: string) => `${name} cannot be “${text}”: ${why}`,
    cannotCopy: (text: string) => `The browser does not let this page copy. ${text}`,
  },

  notices: {
    dismiss: 'Dismiss',
    detail: 'Detail',
    /** Of errors that are no one's fault but ours. */
    ours: {
      internal:
        'Something went wrong inside Meshbound: this is its own fault, not that of your file. What was shown before is still there and can be saved.',
      worker_failed:
        'The part of Meshbound that computes could not be started, or has stopped. What was shown before is still there; the next change tries again.',
      bad_map:
        'Meshbound does not accept a map that it made itself: this is its own fault, not that of your file. The reduced surface keeps its bounds and can be saved; what needs the map, as levels, morphs and probes, does not work here.',
      bad_checkpoint:
        'Meshbound does not accept a state that it made itself: this is its own fault, not that of your file. What was shown before is still there and can be saved.',
    },
  },

  save: {
    again: (format: string, there: string, here: string) =>
      `${format} rounds numbers, so the surface was reduced again: ${there} triangles keep every bound in the file, in place of the ${here} shown.`,
    earlierPicture: (bounds: string) => `Reduced with the bounds before: ${bounds}`,
    provisionalPicture: (bounds: string) => `Provisional answer, within ${bounds}`,
    reducing: (percent: number) => `Reducing again for the file… ${percent}${space}%`,
    reducingCancelled: 'Saving was cancelled; no file was written.',
    earlier: (name: string, bounds: string) =>
      `${name} holds the result with the bounds before, ${bounds}; what is asked for now was not reduced.`,
  },

  stage: {
    surfaces: { original: 'original surface', reduced: 'reduced surface' },
    keys: 'Arrow keys turn, with Shift they move, plus and minus zoom, 0 fits, Enter probes the middle.',
    original: 'Original',
    reduced: 'Reduced',
    reducing: 'Reducing…',
    notReduced: 'Not reduced',
    provisional: 'provisional',
    earlier: 'earlier bounds',
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
    noNumber: 'no number',
    share: (name: string, free: boolean) => `error / bound: ${name}${free ? ' (free: no bound)' : ''}`,
    signed: (name: string) => `signed error: ${name}`,
    lowestBound: '−bound',
    highestBound: '+bound',
    lowestError: '−largest',
    highestError: '+largest',
    unknownErrors: 'values: errors at its vertices are known only when tracked',
    atVertices: 'true error at each vertex',
    inTriangles: 'largest error in each triangle',
    limitInTriangles: 'limit of the error in each triangle',
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
    allBounds: 'All bounds',
    largest: (percent: string) => `largest ${percent}`,
  },

  levels: {
    title: 'Levels of detail',
    region: 'Detail',
    none: 'none',
    what: 'Ever coarser, with smooth transitions',
    making: (percent: number) => `Making levels: ${percent} %`,
    unbounded: 'Levels grow from bounds, and no variable has one.',
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
} as const;
