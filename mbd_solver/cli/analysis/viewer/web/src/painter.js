// Draws grains without a graphics card: the processor paints their discs into a picture, the nearest first, so that every pixel is shaded
// once, and one rectangle brings the picture to the screen with the depth of each pixel. A software renderer would shade
// every disc for itself. What is seen is what the shader of grains.js draws.
import * as three from "three";

const kDepths = 65535;  // steps from the nearest to the farthest grain; 0 is nothing
const kLights = 64, kColours = 128, kCells = 64;  // entries of the tables

// Depths are steps; uNear, uStep: the first and one [m]. P: of the projection.
const kVertex = /* glsl */ `
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }`;
const kFragment = /* glsl */ `
precision highp usampler2D;
uniform sampler2D uPicture;
uniform usampler2D uDepths;
uniform float uNear, uStep;
uniform mat4 uProjection;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uint depth = texelFetch(uDepths, at, 0).r;
  if (depth == 0u) discard;
  gl_FragColor = vec4(texelFetch(uPicture, at, 0).rgb, 1.0);
  gl_FragDepth = 0.5 + 0.5 * (uProjection[3][2] / (uNear + uStep * float(depth - 1u)) - uProjection[2][2]);
}`;

export class GrainPainter {
  // map: of the colours, in colours.js; lightOn(x, y, z): as in shading.js.
  constructor(count, map, lightOn) {
    this.x = new Float32Array(count);       // of the disc [pixels]
    this.y = new Float32Array(count);
    this.r = new Float32Array(count);
    this.depth = new Float32Array(count);   // along the line of sight [m]
    this.seen = new Uint32Array(count);
    this.order = new Uint32Array(count);
    this.places = new Uint32Array(kDepths + 1);
    this.makeTables(map, lightOn);
    const geometry = new three.BufferGeometry();
    geometry.setAttribute("position", new three.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    this.uniforms = { uPicture: { value: null }, uDepths: { value: null }, uNear: { value: 0 }, uStep: { value: 0 }, uProjection: { value: null } };
    this.object = new three.Mesh(geometry, new three.ShaderMaterial({ vertexShader: kVertex, fragmentShader: kFragment, uniforms: this.uniforms }));
    this.object.frustumCulled = false;
  }

  // light: by the place in a disc; palette: colours of the map under each light.
  makeTables(map, lightOn) {
    this.light = new Uint8Array(kCells * kCells);
    const dark = 0.42, bright = 1;
    for (let v = 0; v < kCells; ++v)
      for (let u = 0; u < kCells; ++u) {
        const x = (2 * u + 1) / kCells - 1, y = (2 * v + 1) / kCells - 1, z = Math.sqrt(Math.max(0, 1 - x * x - y * y));
        const share = (lightOn(x, y, z) - dark) / (bright - dark);
        this.light[v * kCells + u] = Math.round((kLights - 1) * Math.min(1, Math.max(0, share)));
      }
    this.palette = new Uint32Array(kColours * kLights);
    const bytes = new Uint8Array(this.palette.buffer);
    for (let c = 0; c < kColours; ++c) {
      const share = c / (kColours - 1);
      let k = 1;
      while (k < map.shares.length - 1 && share > map.shares[k]) ++k;
      const m = (share - map.shares[k - 1]) / (map.shares[k] - map.shares[k - 1]);
      for (let l = 0; l < kLights; ++l)
        for (let rgb = 0; rgb < 3; ++rgb) {
          const colour = map.stops[k - 1][rgb] + m * (map.stops[k][rgb] - map.stops[k - 1][rgb]);
          bytes[4 * (c * kLights + l) + rgb] = Math.min(255, Math.round(colour * (dark + ((bright - dark) * l) / (kLights - 1))));
        }
    }
  }

  resize(width, height) {
    if (this.width === width && this.height === height) return;
    Object.assign(this, { width, height });
    for (const { value } of [this.uniforms.uPicture, this.uniforms.uDepths]) value?.dispose();
    this.picture = new Uint32Array(width * height);
    this.depths = new Uint16Array(width * height);
    const depths = new three.DataTexture(this.depths, width, height, three.RedIntegerFormat, three.UnsignedShortType);
    depths.internalFormat = "R16UI";
    depths.unpackAlignment = 2;
    this.uniforms.uDepths.value = depths;
    this.uniforms.uPicture.value = new three.DataTexture(new Uint8Array(this.picture.buffer), width, height);
  }

  // a, b: frames of four 16-bit numbers; mix between them; box { low, size }; radius [m]; clip: normal, distance; share(i, mix): of
  // the colours, of a grain; width, height of the picture [pixels]. Returns how many grains are in the picture.
  paint({ a, b, mix, box, radius, camera, clip, width, height, share }) {
    this.resize(width, height);
    const view = camera.matrixWorldInverse.elements, P = camera.projectionMatrix.elements;
    const perPixel = P[5] * 0.5 * height;  // pixels of a metre at the distance of one metre
    const { low, size } = box;
    const sx = size[0] / 65534, sy = size[1] / 65534, sz = size[2] / 65534;
    let nearest = Infinity, farthest = 0, count = 0;
    for (let i = 0; i < radius.length; ++i) {
      const k = 4 * i;
      if (a[k] === 65535) continue;
      const m = b[k] === 65535 ? 0 : mix;
      const x = low[0] + sx * (a[k] + m * (b[k] - a[k]));
      const y = low[1] + sy * (a[k + 1] + m * (b[k + 1] - a[k + 1]));
      const z = low[2] + sz * (a[k + 2] + m * (b[k + 2] - a[k + 2]));
      if (x * clip.x + y * clip.y + z * clip.z > clip.w) continue;
      const depth = -(view[2] * x + view[6] * y + view[10] * z + view[14]);
      if (depth < camera.near) continue;
      const scale = perPixel / depth, r = Math.max(0.5, scale * radius[i]);
      const px = 0.5 * width + scale * (view[0] * x + view[4] * y + view[8] * z + view[12]);
      const py = 0.5 * height + scale * (view[1] * x + view[5] * y + view[9] * z + view[13]);
      if (px < -r || py < -r || px > width + r || py > height + r) continue;
      this.x[i] = px;
      this.y[i] = py;
      this.r[i] = r;
      this.depth[i] = depth;
      if (depth < nearest) nearest = depth;
      if (depth > farthest) farthest = depth;
      this.seen[count++] = i;
    }
    const step = (farthest - nearest || 1) / (kDepths - 1);
    this.sort(count, nearest, step);
    this.depths.fill(0);
    for (let j = 0; j < count; ++j) {
      const i = this.order[j];
      this.disc(i, 1 + (((this.depth[i] - nearest) / step) | 0), share, b[4 * i] === 65535 ? 0 : mix);
    }
    this.uniforms.uNear.value = nearest;
    this.uniforms.uStep.value = step;
    this.uniforms.uProjection.value = camera.projectionMatrix;
    this.uniforms.uPicture.value.needsUpdate = true;
    this.uniforms.uDepths.value.needsUpdate = true;
    return count;
  }

  // The first `count` of `seen` into `order`, the nearest first.
  sort(count, nearest, step) {
    const { places, seen, order, depth } = this;
    places.fill(0);
    for (let j = 0; j < count; ++j) ++places[(((depth[seen[j]] - nearest) / step) | 0) + 1];
    for (let d = 1; d <= kDepths; ++d) places[d] += places[d - 1];
    for (let j = 0; j < count; ++j) order[places[((depth[seen[j]] - nearest) / step) | 0]++] = seen[j];
  }

  // Pixels whose centres lie in the disc and on which nothing nearer stands.
  disc(i, depth, share, mix) {
    const { width, height, depths, picture, light, palette } = this;
    const x = this.x[i], y = this.y[i], r = this.r[i], rr = r * r;
    const toCell = (0.5 * kCells - 0.01) / r, middle = 0.5 * kCells;
    const top = Math.min(height - 1, Math.floor(y + r - 0.5));
    let colour = -1;
    for (let v = Math.max(0, Math.ceil(y - r - 0.5)); v <= top; ++v) {
      const dy = v + 0.5 - y, reach = Math.sqrt(Math.max(0, rr - dy * dy));
      const first = Math.max(0, Math.ceil(x - reach - 0.5)), last = Math.min(width - 1, Math.floor(x + reach - 0.5));
      const lights = kCells * ((dy * toCell + middle) | 0);
      for (let u = first, k = v * width + first; u <= last; ++u, ++k) {
        if (depths[k] !== 0) continue;
        if (colour < 0) colour = kLights * Math.round((kColours - 1) * Math.min(1, Math.max(0, share(i, mix))));
        depths[k] = depth;
        picture[k] = palette[colour + light[lights + (((u + 0.5 - x) * toCell + middle) | 0)]];
      }
    }
  }
}
