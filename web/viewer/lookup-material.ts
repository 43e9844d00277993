import { DoubleSide, GLSL3, RawShaderMaterial, type Texture, type Vector4 } from 'three';
import { missingPlace } from '../colour/missing-place.ts';

/** Below this there is nothing to show, on the way of a morph between nothing and something either. */
const leastMissing = 1e-9 * missingPlace;

/** A colour as it is shown on screen, each part 0…1. */
export type ShownColour = readonly [red: number, green: number, blue: number];

const vertexShader = /* glsl */ `
in vec3 position;
in vec3 normal;
in float place;
#ifdef MORPH
in vec3 face;
in vec3 within;
in vec3 coarserPosition;
in vec3 coarserNormal;
in float coarserPlace;
in vec3 coarserFace;
in vec3 coarserWithin;
uniform float share;
out vec3 faceNormal;
out vec3 sight;
out vec3 coarserCorner;
#define towardsCoarser(finer, coarser) mix(finer, coarser, share)
#else
#define towardsCoarser(finer, coarser) finer
#endif

uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform mat3 normalMatrix;
uniform vec4 clipPlane;

out vec3 seenFrom;
out vec3 smoothNormal;
out vec3 corner;
out float shownPlace;
out float clipDistance;

void main() {
  vec4 inView = modelViewMatrix * vec4(towardsCoarser(position, coarserPosition), 1.0);
  gl_Position = projectionMatrix * inView;
  seenFrom = inView.xyz;
  smoothNormal = normalMatrix * towardsCoarser(normal, coarserNormal);
#ifdef MORPH
  faceNormal = normalMatrix * towardsCoarser(face, coarserFace);
  bool perspective = projectionMatrix[2][3] == -1.0;
  sight = perspective ? inView.xyz : vec3(0.0, 0.0, -1.0);
  corner = within;
  coarserCorner = coarserWithin;
#else
  // No vertex is shared between triangles, so its number says which corner of the triangle it is.
  int which = gl_VertexID % 3;
  corner = vec3(which == 0, which == 1, which == 2);
#endif
  shownPlace = towardsCoarser(place, coarserPlace);
  clipDistance = dot(clipPlane.xyz, towardsCoarser(position, coarserPosition)) + clipPlane.w;
}
`;

/** Light falls from beside the viewer; it only scales a colour, so that hue and order of the map survive. */
const fragmentShader = /* glsl */ `
precision highp float;

uniform sampler2D map;
uniform vec3 belowColour;
uniform vec3 aboveColour;
uniform vec3 missingColour;
uniform bool markBelow;
uniform bool markAbove;
uniform bool edges;
uniform bool flatShading;

in vec3 seenFrom;
in vec3 smoothNormal;
in vec3 corner;
in float shownPlace;
in float clipDistance;
#ifdef MORPH
in vec3 faceNormal;
in vec3 sight;
in vec3 coarserCorner;
uniform float share;
#endif

out vec4 colour;

const vec3 lightFrom = normalize(vec3(0.35, 0.45, 1.0));
const float darkest = 0.6;

/** Interpolating equal numbers may miss them by rounding: no place is outside 0…1 for that. */
const float rounding = 1e-5;

vec3 lookUp(float place) {
  if (place < ${leastMissing}) return missingColour;
  if (markBelow && place < -rounding) return belowColour;
  if (markAbove && place > 1.0 + rounding) return aboveColour;
  // The ends of the map are the centres of the first and the last texel.
  float texels = float(textureSize(map, 0).x);
  return texture(map, vec2((clamp(place, 0.0, 1.0) * (texels - 1.0) + 0.5) / texels, 0.5)).rgb;
}

/** What a morph folds lies back to front among the rest of its surface, and is lit as that is. */
bool isFront() {
#ifdef MORPH
  return dot(faceNormal, sight) <= 0.0;
#else
  return gl_FrontFacing;
#endif
}

/** Of a morph that of the levels' triangles: its own pieces stand this way and that between them, and would glitter. */
vec3 flatNormal() {
#ifdef MORPH
  if (dot(faceNormal, faceNormal) > 0.0) return normalize(isFront() ? faceNormal : -faceNormal);
#endif
  return normalize(cross(dFdx(seenFrom), dFdy(seenFrom)));
}

float light() {
  vec3 normal = flatShading || dot(smoothNormal, smoothNormal) == 0.0
    ? flatNormal()
    : normalize(isFront() ? smoothNormal : -smoothNormal);
  return mix(darkest, 1.0, max(dot(normal, lightFrom), 0.0));
}

/**
 * How much of this fragment an edge covers, from the weights of the triangle's corners; edges of triangles of few pixels
 * fade, or they would cover everything. Where a weight does not change, all is edge, which a morph has opened.
 */
float edgeCover(vec3 weights) {
  vec3 perPixel = fwidth(weights);
  vec3 pixels = mix(weights / max(perPixel, vec3(1e-9)), vec3(1e9), equal(perPixel, vec3(0.0)));
  float nearest = min(min(pixels.x, pixels.y), pixels.z);
  float narrowness = max(max(perPixel.x, perPixel.y), perPixel.z);
  return (1.0 - smoothstep(0.1, 1.1, nearest)) * (1.0 - smoothstep(0.15, 0.6, narrowness));
}

/** Of a morph the edges of the finer level, which give way to those of the coarser one. */
float edgeCover() {
#ifdef MORPH
  return mix(edgeCover(corner), edgeCover(coarserCorner), share);
#else
  return edgeCover(corner);
#endif
}

void main() {
  if (clipDistance < 0.0) discard;
  vec3 lit = lookUp(shownPlace) * light();
  if (edges) lit *= 1.0 - 0.55 * edgeCover();
  colour = vec4(lit, 1.0);
}
`;

/** What the material is told, beside the surface itself. */
export interface LookupUniforms {
  map: { value: Texture | null };
  belowColour: { value: ShownColour };
  aboveColour: { value: ShownColour };
  missingColour: { value: ShownColour };
  /** Whether places below 0 and above 1 get colours of their own or those of the map's ends. */
  markBelow: { value: boolean };
  markAbove: { value: boolean };
  edges: { value: boolean };
  flatShading: { value: boolean };
  /** Shown is where x, y, z (in the frame) and 1 times these four numbers add up to 0 or more. */
  clipPlane: { value: Vector4 };
  /** Of a morph: how far it is on its way to the coarser level, 0…1. */
  share: { value: number };
}

/**
 * Draws triangles whose attribute `place` says where in the map each corner stands, 0…1; `missingPlace` at all three where
 * there is nothing to show. The place is interpolated and the colour looked up for every fragment: blending the colours of
 * the vertices would show colours that are not in the map. With MORPH position, normal and place have counterparts on a
 * coarser level, and are mixed by the uniform `share`; each corner also knows the normal of the level's triangle that it
 * lies in (`face`), and its weights there (`within`), so that shading and edges are the levels', not those of the pieces.
 */
export function lookupMaterial(uniforms: LookupUniforms, defines: { MORPH?: true } = {}): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    side: DoubleSide,
    defines,
    uniforms: uniforms as unknown as RawShaderMaterial['uniforms'],
  });
}
