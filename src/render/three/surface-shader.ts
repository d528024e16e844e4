import { LIGHT, LIT, STRIPES } from "../../scene/shade.ts";
import { LEVELS } from "../colour-map.ts";

/** What the colour shows, as the shader counts it. */
export const MODES = { lit: 0, normals: 1, values: 2, stripes: 3 } as const;

/** A value that stands for none: NaN does not travel well through graphics cards. */
export const NO_NUMBER = 1e30;

const vec = (v: readonly number[]) => `vec3(${v.map(float).join(", ")})`;
const float = (x: number) => (/[.e]/.test(String(x)) ? String(x) : `${x}.0`);

/** The picture of a camera without perspective: across, up, and towards the eye, straight into the window. */
export const vertexShader = `
precision highp float;
in vec3 position;
in vec3 normal;
in float value;
uniform mat3 axes; // rows: right, up, eye
uniform vec3 target;
uniform vec2 windowScale;
uniform vec2 windowOffset;
uniform float depthScale;
out vec3 pictureNormal;
out float shown;
void main() {
  vec3 at = axes * (position - target);
  pictureNormal = axes * normal;
  shown = value;
  gl_Position = vec4(at.xy * windowScale + windowOffset, -at.z * depthScale, 1.0);
}`;

/** The formulas of \`scene/shade.ts\`, from the same constants. */
export const fragmentShader = `
precision highp float;
precision highp sampler2D;
in vec3 pictureNormal;
in float shown;
uniform mat3 axes;
uniform int mode;
uniform vec2 range;
uniform sampler2D colourMap;
uniform vec3 frontDim;
uniform vec3 frontLit;
uniform vec3 backDim;
uniform vec3 backLit;
uniform vec3 stripeDim;
out vec4 colour;

float litShare(vec3 n) {
  float gloss = pow(max(0.0, dot(n, ${vec(LIT.halfway)})), ${float(LIT.hardness)});
  float share = ${float(LIT.base)} + ${float(LIT.light)} * max(0.0, dot(n, ${vec(LIGHT)}))
    + ${float(LIT.eye)} * max(0.0, n.z) + ${float(LIT.gloss)} * gloss;
  return min(1.0, share);
}

float stripeShare(vec3 n) {
  float wave = sin(${float(2 * STRIPES.count)} * asin(clamp(2.0 * n.z * n.y, -1.0, 1.0)));
  return 0.5 + 0.5 * clamp(${float(STRIPES.edge)} * wave, -1.0, 1.0);
}

vec3 mapped(float value) {
  float share = range.y > range.x ? clamp((value - range.x) / (range.y - range.x), 0.0, 1.0) : 0.5;
  return texelFetch(colourMap, ivec2(int(floor(share * ${float(LEVELS - 1)} + 0.5)), 0), 0).rgb;
}

void main() {
  // Where no corner has a normal, the surface is shown as if it faced the eye.
  float size = length(pictureNormal);
  vec3 n = size > 1e-6 ? pictureNormal / size : vec3(0.0, 0.0, gl_FrontFacing ? 1.0 : -1.0);
  vec3 seen = gl_FrontFacing ? n : -n;
  vec3 rgb;
  if (mode == ${MODES.normals}) rgb = size > 1e-6 ? 0.5 + 0.5 * (transpose(axes) * n) : frontDim;
  else if (mode == ${MODES.values}) rgb = abs(shown) < ${float(NO_NUMBER / 1e4)} ? mapped(shown) : frontDim;
  else if (mode == ${MODES.stripes}) rgb = mix(stripeDim, frontLit, stripeShare(seen));
  else if (gl_FrontFacing) rgb = mix(frontDim, frontLit, litShare(seen));
  else rgb = mix(backDim, backLit, litShare(seen));
  colour = vec4(rgb, 1.0);
}`;
