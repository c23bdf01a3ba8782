// Draws grains without a graphics card: the processor paints their discs into a picture, the nearest first, so that every pixel is shaded
// once, and one rectangle brings the picture to the screen with the depth of each pixel. A software renderer would shade
// every disc for itself. What is seen is what the shader of grains.js draws. While it plays, facets of the mechanism (facets.js) join them.
import * as three from "three";
import { kDepths } from "./facets.js";
import { kLayerShade, kMoving } from "./shading.js";

const kLights = 64, kColours = 128, kCells = 64;  // entries of the tables

// A pixel: 6 bits of red, green and blue each, and 14 of the depth. Depths are steps; uNear, uStep: the first and one [m].
const kVertex = /* glsl */ `
uniform vec4 uBounds;  // of the picture that holds grains, -1 ... 1
void main() { gl_Position = vec4(mix(uBounds.xy, uBounds.zw, position.xy), 0.0, 1.0); }`;
const kFragment = /* glsl */ `
precision highp usampler2D;
uniform usampler2D uPixels;
uniform float uNear, uStep;
uniform mat4 uProjection;
void main() {
  uint pixel = texelFetch(uPixels, ivec2(gl_FragCoord.xy), 0).r;
  if (pixel == 0u) discard;
  gl_FragColor = vec4(vec3((uvec3(pixel) >> uvec3(26u, 20u, 14u)) & 63u) / 63.0, 1.0);
  gl_FragDepth = 0.5 + 0.5 * (uProjection[3][2] / (uNear + uStep * float((pixel & 16383u) - 1u)) - uProjection[2][2]);
}`;

export class GrainPainter {
  // map: of the colours, in colours.js; lightOn(x, y, z): as in shading.js.
  constructor(count, map, lightOn) {
    this.discs = new Float32Array(4 * count);  // in the picture: x, y, radius [pixels], depth along the line of sight [m]
    this.grain = new Uint32Array(count);       // of each disc
    this.steps = new Uint16Array(count);       // depth of each disc
    this.order = new Uint32Array(count);
    this.places = new Uint32Array(kDepths + 2);
    this.makeTables(map, lightOn);
    const geometry = new three.BufferGeometry();
    geometry.setAttribute("position", new three.BufferAttribute(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0]), 3));
    this.uniforms = { uPixels: { value: null }, uBounds: { value: new three.Vector4() }, uNear: { value: 0 }, uStep: { value: 0 }, uProjection: { value: null } };
    this.object = new three.Mesh(geometry, new three.ShaderMaterial({ vertexShader: kVertex, fragmentShader: kFragment, uniforms: this.uniforms }));
    this.object.frustumCulled = false;
  }

  // light: by the place in a disc; palette: colours of the map under each light, where a pixel has them.
  makeTables(map, lightOn) {
    this.light = new Uint8Array(kCells * kCells);
    const dark = 0.42, bright = 1;
    for (let v = 0; v < kCells; ++v)
      for (let u = 0; u < kCells; ++u) {
        const x = (2 * u + 1) / kCells - 1, y = (2 * v + 1) / kCells - 1, z = Math.sqrt(Math.max(0, 1 - x * x - y * y));
        const share = (lightOn(x, y, z) - dark) / (bright - dark);
        this.light[v * kCells + u] = Math.round((kLights - 1) * Math.min(1, Math.max(0, share)));
      }
    this.palette = new Int32Array(2 * kColours * kLights);  // of the grains of even layers, then of odd ones
    for (let c = 0; c < 2 * kColours; ++c) {
      const share = (c % kColours) / (kColours - 1), shade = c < kColours ? 1 : kLayerShade + (1 - kLayerShade) * Math.min(1, share / kMoving);
      let k = 1;
      while (k < map.shares.length - 1 && share > map.shares[k]) ++k;
      const m = (share - map.shares[k - 1]) / (map.shares[k] - map.shares[k - 1]);
      for (let l = 0; l < kLights; ++l)
        for (let rgb = 0; rgb < 3; ++rgb) {
          const colour = map.stops[k - 1][rgb] + m * (map.stops[k][rgb] - map.stops[k - 1][rgb]);
          const six = Math.min(63, Math.round((shade * colour * (dark + ((bright - dark) * l) / (kLights - 1)) * 63) / 255));
          this.palette[c * kLights + l] |= six << (26 - 6 * rgb);
        }
    }
  }

  resize(width, height) {
    if (this.width === width && this.height === height) return;
    Object.assign(this, { width, height });
    this.uniforms.uPixels.value?.dispose();
    this.pixels = new Int32Array(width * height);
    const texture = new three.DataTexture(new Uint32Array(this.pixels.buffer), width, height, three.RedIntegerFormat, three.UnsignedIntType);
    texture.internalFormat = "R32UI";
    this.uniforms.uPixels.value = texture;
    // Pixels that are still free: a bit each, in rows of whole words.
    this.words = Math.ceil(width / 32);
    this.free = new Int32Array(this.words * height);
  }

  // a, b: frames of four 16-bit numbers; mix between them; box { low, size }; radius [m]; clip: normal, distance; share(i, mix): of
  // the colours, of a grain; odd: 1 for grains of odd layers; width, height of the picture [pixels]; facets: of the mechanism, or none. Returns how
  // many grains are in the picture.
  paint({ a, b, mix, box, radius, camera, clip, width, height, share, odd, facets }) {
    this.resize(width, height);
    const { nearest, step, count } = this.place({ a, b, mix, box, radius, camera, clip, width, height, facets });
    this.sort(count, nearest, step);
    this.pixels.fill(0);
    this.free.fill(-1);
    this.discsOf(count, share, odd, b, mix);
    facets?.fill(this.pixels, nearest, step);
    this.uniforms.uNear.value = nearest;
    this.uniforms.uStep.value = step;
    this.uniforms.uProjection.value = camera.projectionMatrix;
    this.uniforms.uPixels.value.needsUpdate = true;
    return count;
  }

  // Discs of the grains that are in the picture.
  place({ a, b, mix, box, radius, camera, clip, width, height, facets }) {
    const { discs, grain } = this;
    const V = camera.matrixWorldInverse.elements, perPixel = camera.projectionMatrix.elements[5] * 0.5 * height;  // pixels of a metre at the distance of one metre
    const { low, size } = box, sx = size[0] / 65534, sy = size[1] / 65534, sz = size[2] / 65534, near = camera.near;
    // In the eye's axes, and along the normal of the clip plane, straight from the numbers of a frame.
    const ux = V[0] * sx, uy = V[4] * sy, uz = V[8] * sz, u0 = V[0] * low[0] + V[4] * low[1] + V[8] * low[2] + V[12];
    const vx = V[1] * sx, vy = V[5] * sy, vz = V[9] * sz, v0 = V[1] * low[0] + V[5] * low[1] + V[9] * low[2] + V[13];
    const wx = -V[2] * sx, wy = -V[6] * sy, wz = -V[10] * sz, w0 = -(V[2] * low[0] + V[6] * low[1] + V[10] * low[2] + V[14]);
    const cx = clip.x * sx, cy = clip.y * sy, cz = clip.z * sz, c0 = clip.x * low[0] + clip.y * low[1] + clip.z * low[2] - clip.w;
    let { nearest, farthest, left, right, bottom, top } = facets ?? { nearest: Infinity, farthest: 0, left: width, right: 0, bottom: height, top: 0 }, count = 0;
    for (let i = 0, k = 0; i < radius.length; ++i, k += 4) {
      let x = a[k], y = a[k + 1], z = a[k + 2];
      if (x === 65535) continue;
      if (b[k] !== 65535) {
        x += mix * (b[k] - x);
        y += mix * (b[k + 1] - y);
        z += mix * (b[k + 2] - z);
      }
      if (cx * x + cy * y + cz * z + c0 > 0) continue;
      const depth = wx * x + wy * y + wz * z + w0;
      if (depth < near) continue;
      const scale = perPixel / depth, r = Math.max(0.5, scale * radius[i]);
      const px = 0.5 * width + scale * (ux * x + uy * y + uz * z + u0), py = 0.5 * height + scale * (vx * x + vy * y + vz * z + v0);
      if (px < -r || py < -r || px > width + r || py > height + r) continue;
      const d = 4 * count;
      discs[d] = px;
      discs[d + 1] = py;
      discs[d + 2] = r;
      discs[d + 3] = depth;
      grain[count++] = i;
      if (depth < nearest) nearest = depth;
      if (depth > farthest) farthest = depth;
      if (px - r < left) left = px - r;
      if (px + r > right) right = px + r;
      if (py - r < bottom) bottom = py - r;
      if (py + r > top) top = py + r;
    }
    const end = (at, all) => Math.min(1, Math.max(-1, (2 * at) / all - 1));
    this.uniforms.uBounds.value.set(end(left - 1, width), end(bottom - 1, height), end(right + 1, width), end(top + 1, height));
    return { nearest, step: (farthest - nearest || 1) / (kDepths - 1), count };
  }

  // The first `count` discs into `order`, the nearest first.
  sort(count, nearest, step) {
    const { places, steps, order, discs } = this;
    places.fill(0);
    for (let d = 0; d < count; ++d) ++places[(steps[d] = 1 + (((discs[4 * d + 3] - nearest) / step) | 0)) + 1];
    for (let s = 1; s < places.length; ++s) places[s] += places[s - 1];
    for (let d = 0; d < count; ++d) order[places[steps[d]]++] = d;
  }

  // Pixels whose centres lie in a disc and show nothing nearer. Most grains are hidden: of those a row costs a look at one word or two.
  discsOf(count, share, odd, b, mix) {
    const { width, height, pixels, light, palette, free, words, discs, order, grain, steps } = this;
    for (let j = 0; j < count; ++j) {
      const d = order[j], x = discs[4 * d], y = discs[4 * d + 1], r = discs[4 * d + 2];
      const left = Math.max(0, Math.ceil(x - r - 0.5)), right = Math.min(width - 1, Math.floor(x + r - 0.5)), top = Math.min(height - 1, Math.floor(y + r - 0.5));
      if (right < left) continue;
      const one = left >> 5, two = right >> 5, maskOne = -1 << (left & 31), maskTwo = -1 >>> (31 - (right & 31)), toCell = (0.5 * kCells - 0.01) / r;
      let colour = -1;
      for (let v = Math.max(0, Math.ceil(y - r - 0.5)); v <= top; ++v) {
        const row = v * words;
        let open = one === two ? free[row + one] & maskOne & maskTwo : (free[row + one] & maskOne) | (free[row + two] & maskTwo);
        for (let w = one + 1; w < two; ++w) open |= free[row + w];
        if (open === 0) continue;
        const dy = v + 0.5 - y, reach = Math.sqrt(Math.max(0, r * r - dy * dy));
        const first = Math.max(0, Math.ceil(x - reach - 0.5)), last = Math.min(width - 1, Math.floor(x + reach - 0.5));
        const lights = kCells * ((dy * toCell + 0.5 * kCells) | 0);
        for (let w = first >> 5; w <= last >> 5; ++w) {
          let bits = free[row + w];
          if (w === first >> 5) bits &= -1 << (first & 31);
          if (w === last >> 5) bits &= -1 >>> (31 - (last & 31));
          free[row + w] &= ~bits;
          for (; bits !== 0; bits &= bits - 1) {
            const u = 32 * w + 31 - Math.clz32(bits & -bits);
            if (colour < 0) {
              const i = grain[d];
              colour = kLights * (odd[i] * kColours + Math.round((kColours - 1) * Math.min(1, Math.max(0, share(i, b[4 * i] === 65535 ? 0 : mix)))));
            }
            pixels[v * width + u] = palette[colour + light[lights + (((u + 0.5 - x) * toCell + 0.5 * kCells) | 0)]] | steps[d];
          }
        }
      }
    }
  }
}
