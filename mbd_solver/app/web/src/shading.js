// What the shaders share. Positions come as four 16-bit numbers, 0 ... 1 of the box; x = 1 says that the thing is absent.

export const kScale = /* glsl */ `
uniform vec3 uStops[5];
uniform float uShares[5];
vec3 colourOf(float share) {
  vec3 c = uStops[0];
  for (int k = 1; k < 5; ++k) c = mix(c, uStops[k], clamp((share - uShares[k - 1]) / (uShares[k] - uShares[k - 1]), 0.0, 1.0));
  return c;
}`;

// At rest the grains show the layers in which they lay at the start: every other one is darker.
export const kLayerShade = 0.8, kMoving = 0.12;  // share of the colours at which the layers have faded

export const kBox = /* glsl */ `
uniform vec3 uLow, uSize;  // of the box [m]
uniform float uMix;        // 0: at frame a, 1: at frame b
vec3 placed(vec4 a, vec4 b) { return uLow + uSize * (65535.0 / 65534.0) * mix(a.xyz, b.xyz, uMix); }`;

// A light from the upper left behind the eye, and some from the sky. n: normal in the eye's axes.
export const kLight = /* glsl */ `
float lightOn(vec3 n) { return 0.42 + 0.58 * max(0.0, dot(n, vec3(-0.33, 0.62, 0.71))); }`;
export const lightOn = (x, y, z) => 0.42 + 0.58 * Math.max(0, -0.33 * x + 0.62 * y + 0.71 * z);

// Half of space can be left out: where dot(x, normal) > distance. A zero normal leaves out nothing.
export const kClip = /* glsl */ `
uniform vec4 uClip;  // normal, distance
bool clipped(vec3 x) { return dot(x, uClip.xyz) > uClip.w; }`;

export function scaleUniforms(map) {
  return { uStops: { value: map.stops.flatMap((c) => c.map((v) => v / 255)) }, uShares: { value: map.shares } };
}

export function boxUniforms(box) {
  return { uLow: { value: box.low }, uSize: { value: box.size }, uMix: { value: 0 } };
}
