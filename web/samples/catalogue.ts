/** A surface that the project ships: an isosurface of density in a flow that it simulates itself. */
export interface Sample {
  name: string;
  title: string;
  /** One sentence for people. */
  description: string;
  scene: 'fireballs' | 'impact';
  /** Cells along x, y and z; the values stand at their centres. */
  cells: [number, number, number];
  /** The density that the surface follows, in the scene's unit. */
  isovalue: number;
  /** The variables that the surface carries, in their order in the file. */
  variables: string[];
}

/** A sample that has been made, as samples.json lists it. */
export interface ListedSample {
  name: string;
  title: string;
  description: string;
  /** The PLY file beside samples.json. */
  file: string;
  triangles: number;
  vertices: number;
  boundaryLoops: number;
  components: number;
  /** By variable; `position` is the geometry. "1" for a variable without a unit. */
  units: Record<string, string>;
}

const fireballs = {
  scene: 'fireballs',
  isovalue: 0.45,
  variables: ['density', 'pressure', 'vx', 'vy', 'vz', 'energy', 'temperature'],
} as const;

const impact = {
  scene: 'impact',
  isovalue: 0.25,
  variables: ['pressure', 'vx', 'vy', 'vz', 'temperature', 'iron'],
} as const;

/** All samples, the quick ones first. */
export const samples: Sample[] = [
  {
    ...fireballs,
    name: 'fireballs',
    title: 'Fireballs',
    description: 'Two balls of gas, xenon and argon, have collided off-axis at 3 km/s in thin helium.',
    cells: [70, 40, 25],
    variables: [...fireballs.variables],
  },
  {
    ...impact,
    name: 'impact',
    title: 'Impact',
    description: 'An iron ball has struck through an aluminium plate at 16 km/s.',
    cells: [54, 24, 24],
    variables: [...impact.variables],
  },
  {
    ...fireballs,
    name: 'fireballs-fine',
    title: 'Fireballs, fine',
    description:
      'Two balls of gas, xenon and argon, have collided off-axis at 3 km/s in thin helium; simulated 3.8 times finer.',
    cells: [266, 152, 95],
    variables: [...fireballs.variables],
  },
  {
    ...impact,
    name: 'impact-fine',
    title: 'Impact, fine',
    description: 'An iron ball has struck through an aluminium plate at 16 km/s; simulated 3.8 times finer.',
    cells: [205, 91, 91],
    variables: [...impact.variables],
  },
];
