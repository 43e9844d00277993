import { Vector4 } from 'three';
import type { Frame } from './frame.ts';

export const axes = ['x', 'y', 'z'] as const;
export type Axis = (typeof axes)[number];

/** A plane across an axis, in the mesh's unit: what lies on its other side is not drawn. */
export interface ClipPlane {
  axis: Axis;
  at: number;
  keeps: 'below' | 'above';
}

/** A plane as text: "x < 0.5" keeps what is below, "z > -2" what is above. Null where the text is no plane. */
export function parseClip(text: string): ClipPlane | null {
  const [, axis, sign, number] = /^\s*([xyz])\s*([<>])\s*(\S+)\s*$/.exec(text.replace('\u2212', '-')) ?? [];
  const at = Number(number);
  return axis && Number.isFinite(at) ? { axis: axis as Axis, at, keeps: sign === '<' ? 'below' : 'above' } : null;
}

/** What `parseClip` reads as this plane. */
export function clipText({ axis, at, keeps }: ClipPlane): string {
  return `${axis} ${keeps === 'below' ? '<' : '>'} ${at}`;
}

/** How surfaces are drawn, whatever their colours. */
export interface Look {
  /** The triangles' edges, as lines. */
  edges: boolean;
  /** Flat: every triangle as the plane that it is. Smooth: creases of more than 60° stay. */
  shading: 'smooth' | 'flat';
  /** Whether the back of a triangle is drawn too; otherwise one looks through it. */
  doubleSided: boolean;
  clip: ClipPlane | null;
}

export const plainLook: Look = { edges: false, shading: 'smooth', doubleSided: true, clip: null };

/** Normal and offset of a plane in the frame, as the material takes it: everything is kept where there is none. */
export function planeInFrame(clip: ClipPlane | null, { centre, radius }: Frame): Vector4 {
  if (!clip) return new Vector4(0, 0, 0, 1);
  const axis = axes.indexOf(clip.axis);
  const sign = clip.keeps === 'below' ? -1 : 1;
  const plane = new Vector4(0, 0, 0, (-sign * (clip.at - centre[axis])) / radius);
  return plane.setComponent(axis, sign);
}
